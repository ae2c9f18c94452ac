<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>CoreSamplePanel</name>
    <message>
        <source>The plies at the point, from the top; From and To are distances from the face in mm</source>
        <translation>Les plis au point, depuis le haut ; De et À sont des distances à la face en mm</translation>
    </message>
    <message>
        <source>Core Sample</source>
        <translation>Carotte</translation>
    </message>
    <message>
        <source>Stack</source>
        <translation>Empilement</translation>
    </message>
    <message>
        <source>A ply stack of this document</source>
        <translation>Un empilement de plis de ce document</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Where the sample is taken</source>
        <translation>Où la carotte est prélevée</translation>
    </message>
    <message>
        <source>Pick a point in the 3-D view</source>
        <translation>Choisissez un point dans la vue 3D</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Press, then click a point of the face or the stack</source>
        <translation>Appuyez, puis cliquez un point de la face ou de l&apos;empilement</translation>
    </message>
    <message>
        <source>Ply</source>
        <translation>Pli</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>There is no ply stack in this document; make one first.</source>
        <translation>Il n&apos;y a pas d&apos;empilement dans ce document ; créez-en un d&apos;abord.</translation>
    </message>
    <message>
        <source>Click a point of the face or the stack in the 3-D view.</source>
        <translation>Cliquez un point de la face ou de l&apos;empilement dans la vue 3D.</translation>
    </message>
    <message>
        <source>Click another point for another sample.</source>
        <translation>Cliquez un autre point pour une autre carotte.</translation>
    </message>
</context>
<context>
    <name>CurvatureMapPanel</name>
    <message>
        <source>Curvature Map</source>
        <translation>Carte de courbure</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view; Ctrl+click adds further faces</source>
        <translation>Appuyez, puis cliquez une face dans la vue 3D ; Ctrl+clic en ajoute d'autres</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Sample the faces that are listed</source>
        <translation>Échantillonner les faces de la liste</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>Montre</translation>
    </message>
    <message>
        <source>Take the selected faces out of the list</source>
        <translation>Retire les faces sélectionnées de la liste</translation>
    </message>
    <message>
        <source>The faces; select some and press Remove to take them out</source>
        <translation>Les faces ; Retirer enlève celles qui sont sélectionnées</translation>
    </message>
    <message>
        <source>The wanted distance, signed along the face's outward normal; f(x) gives an expression</source>
        <translation>La distance voulue, signée le long de la normale extérieure de la face ; f(x) prend une expression</translation>
    </message>
    <message>
        <source>What the colours stand for: how much of the limit the distance uses up, or the limit on one side</source>
        <translation>Ce que disent les couleurs : la part de la limite que prend la distance, ou la limite d'un côté</translation>
    </message>
</context>
<context>
    <name>DeviationMapPanel</name>
    <message>
        <source>Choose an offset first.</source>
        <translation>Choisissez d'abord un décalage.</translation>
    </message>
    <message>
        <source>Deviation Map</source>
        <translation>Carte des écarts</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Plus grand</translation>
    </message>
    <message>
        <source>Least number of triangles; more take longer</source>
        <translation>Nombre minimal de triangles ; davantage prend plus de temps</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Plus petit</translation>
    </message>
    <message>
        <source>Measure the offset anew</source>
        <translation>Mesurer le décalage à nouveau</translation>
    </message>
    <message>
        <source>Most negative deviation seen</source>
        <translation>Écart le plus négatif observé</translation>
    </message>
    <message>
        <source>Most positive deviation seen</source>
        <translation>Écart le plus positif observé</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>The offset that is measured</source>
        <translation>Le décalage qui est mesuré</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
</context>
<context>
    <name>ExtendFacePanel</name>
    <message>
        <source>Extend Face</source>
        <translation>Prolonger une face</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>The faces; select some and press Remove to take them out</source>
        <translation>Les faces ; Retirer enlève celles qui sont sélectionnées</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view; Ctrl+click adds further faces</source>
        <translation>Appuyez, puis cliquez une face dans la vue 3D ; Ctrl+clic en ajoute d&apos;autres</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Take the selected faces out of the list</source>
        <translation>Retire les faces sélectionnées de la liste</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Arc length of the extension; f(x) gives an expression</source>
        <translation>Longueur d&apos;arc du prolongement ; f(x) donne une expression</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Côtés</translation>
    </message>
    <message>
        <source>u min</source>
        <translation>u min</translation>
    </message>
    <message>
        <source>Extend the side where u is least</source>
        <translation>Prolonge le côté où u est le plus petit</translation>
    </message>
    <message>
        <source>u max</source>
        <translation>u max</translation>
    </message>
    <message>
        <source>Extend the side where u is largest</source>
        <translation>Prolonge le côté où u est le plus grand</translation>
    </message>
    <message>
        <source>v min</source>
        <translation>v min</translation>
    </message>
    <message>
        <source>Extend the side where v is least</source>
        <translation>Prolonge le côté où v est le plus petit</translation>
    </message>
    <message>
        <source>v max</source>
        <translation>v max</translation>
    </message>
    <message>
        <source>Extend the side where v is largest</source>
        <translation>Prolonge le côté où v est le plus grand</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>Continuité</translation>
    </message>
    <message>
        <source>G1: the mirror image of the part next to the side; natural: the surface&apos;s last piece goes on</source>
        <translation>G1 : l&apos;image miroir de la partie voisine du côté ; natural : le dernier morceau de la surface continue</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Règle</translation>
    </message>
    <message>
        <source>mean: iso-curves have the length on the average; at-least: each of them has it</source>
        <translation>mean : les isocourbes ont la longueur en moyenne ; at-least : chacune l&apos;a au moins</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Compute once and leave the panel open</source>
        <translation>Calcule une fois et laisse le panneau ouvert</translation>
    </message>
</context>
<context>
    <name>LaminateOffset</name>
    <message>
        <source>Export the stack</source>
        <translation>Exporter l&apos;empilement</translation>
    </message>
    <message>
        <source>STEP, one part a ply (*.step)</source>
        <translation>STEP, une pièce par pli (*.step)</translation>
    </message>
    <message>
        <source>Table of the plies (*.csv)</source>
        <translation>Tableau des plis (*.csv)</translation>
    </message>
    <message>
        <source>CalculiX shell section (*.inp)</source>
        <translation>Section de coque CalculiX (*.inp)</translation>
    </message>
    <message>
        <source>HDF5 composite CAE (*.h5)</source>
        <translation>HDF5 Composite CAE (*.h5)</translation>
    </message>
    <message>
        <source>Ply book (*.html)</source>
        <translation>Livre des plis (*.html)</translation>
    </message>
    <message>
        <source>Import a layup</source>
        <translation>Importer un drapage</translation>
    </message>
    <message>
        <source>Layups (*.csv *.json *.yaml *.yml)</source>
        <translation>Drapages (*.csv *.json *.yaml *.yml)</translation>
    </message>
    <message>
        <source>Export the layup</source>
        <translation>Exporter le drapage</translation>
    </message>
    <message>
        <source>Whole job, YAML (*.yaml)</source>
        <translation>Travail complet, YAML (*.yaml)</translation>
    </message>
    <message>
        <source>Whole job, JSON (*.json)</source>
        <translation>Travail complet, JSON (*.json)</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <source>Layup</source>
        <translation>Drapage</translation>
    </message>
    <message>
        <source>FreeCAD could not recompute the object: {error}</source>
        <translation>FreeCAD n'a pas pu recalculer l'objet : {error}</translation>
    </message>
    <message>
        <source>Press Preview to see the result, or OK to make it.</source>
        <translation>Aperçu montre le résultat, OK le crée.</translation>
    </message>
    <message>
        <source>Pick a face first: press Pick and click a face in the 3-D view.</source>
        <translation>Choisissez d&apos;abord une face : appuyez sur Choisir et cliquez une face dans la vue 3D.</translation>
    </message>
    <message>
        <source>Click a face in the 3-D view.</source>
        <translation>Cliquez une face dans la vue 3D.</translation>
    </message>
    <message>
        <source>Edit {name}</source>
        <translation>Modifier {name}</translation>
    </message>
    <message>
        <source>Computing {title}...</source>
        <translation>Calcul de {title}...</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Limit inwards</source>
        <translation>Limite vers l'intérieur</translation>
    </message>
    <message>
        <source>Limit outwards</source>
        <translation>Limite vers l'extérieur</translation>
    </message>
    <message>
        <source>any</source>
        <translation>toutes</translation>
    </message>
    <message>
        <source>folds</source>
        <translation>se replie</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_CoreSample</name>
    <message>
        <source>Core Sample</source>
        <translation>Carotte</translation>
    </message>
    <message>
        <source>Shows which plies of a stack are met at a point, and from where to where</source>
        <translation>Montre quels plis d&apos;un empilement se trouvent en un point, et d&apos;où à où</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_CurvatureMap</name>
    <message>
        <source>Curvature Map</source>
        <translation>Carte de courbure</translation>
    </message>
    <message>
        <source>Shows in colours how near a distance is to the curvature limit of the faces</source>
        <translation>Montre en couleurs à quel point une distance approche la limite de courbure des faces</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_DeviationMap</name>
    <message>
        <source>Deviation Map</source>
        <translation>Carte des écarts</translation>
    </message>
    <message>
        <source>Shows in colours how far the selected offset is from the exact one</source>
        <translation>Montre en couleurs de combien le décalage sélectionné s&apos;écarte du décalage exact</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ExplodedView</name>
    <message>
        <source>Draws the plies of the selected stack apart from each other; again: together</source>
        <translation>Dessine les plis de l'empilement choisi séparés ; encore une fois : réunis</translation>
    </message>
    <message>
        <source>Exploded View</source>
        <translation>Vue éclatée</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ExportLayup</name>
    <message>
        <source>Export Layup...</source>
        <translation>Exporter le drapage...</translation>
    </message>
    <message>
        <source>Writes the selected layup as a table (.csv) or as a whole job (.json, .yaml)</source>
        <translation>Écrit le drapage sélectionné comme tableau (.csv) ou comme travail complet (.json, .yaml)</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ExportPlyBook</name>
    <message>
        <source>Export Ply Book...</source>
        <translation>Exporter le livre des plis...</translation>
    </message>
    <message>
        <source>Writes the ply book of the selected stack: a page with a picture for every ply</source>
        <translation>Écrit le livre des plis de l&apos;empilement sélectionné : une page avec image pour chaque pli</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ExportStack</name>
    <message>
        <source>Export Stack...</source>
        <translation>Exporter l&apos;empilement...</translation>
    </message>
    <message>
        <source>Writes the selected stack: STEP with named plies, table, ply book, CalculiX section, HDF5 composite CAE</source>
        <translation>Écrit l'empilement sélectionné : STEP avec plis nommés, tableau des plis, livre des plis, section CalculiX, HDF5 Composite CAE</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ExtendFace</name>
    <message>
        <source>Extend Face</source>
        <translation>Prolonger une face</translation>
    </message>
    <message>
        <source>Makes the selected faces longer past their sides by a length</source>
        <translation>Prolonge les faces sélectionnées d&apos;une longueur au-delà de leurs côtés</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ImportLayup</name>
    <message>
        <source>Import Layup...</source>
        <translation>Importer un drapage...</translation>
    </message>
    <message>
        <source>Reads a layup table (.csv) or a whole job (.json, .yaml)</source>
        <translation>Lit un tableau de plis (.csv) ou un travail complet (.json, .yaml)</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_Layup</name>
    <message>
        <source>Layup</source>
        <translation>Drapage</translation>
    </message>
    <message>
        <source>Makes a layup: a table of plies with materials, angles, thicknesses</source>
        <translation>Crée un drapage : un tableau de plis avec matériaux, angles, épaisseurs</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_OffsetFace</name>
    <message>
        <source>Offset Face</source>
        <translation>Décaler une face</translation>
    </message>
    <message>
        <source>Offsets the selected faces by a constant distance, within a tolerance</source>
        <translation>Décale les faces sélectionnées d&apos;une distance constante, dans une tolérance</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_OffsetLimits</name>
    <message>
        <source>Offset Limits</source>
        <translation>Limites de décalage</translation>
    </message>
    <message>
        <source>Shows how far faces can be offset, and where an offset would fold first</source>
        <translation>Montre jusqu&apos;où des faces peuvent être décalées et où un décalage se replierait d&apos;abord</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_PlyStack</name>
    <message>
        <source>Ply Stack</source>
        <translation>Empilement de plis</translation>
    </message>
    <message>
        <source>Lays the plies of a layup on the selected face</source>
        <translation>Pose les plis d&apos;un drapage sur la face sélectionnée</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_Rosette</name>
    <message>
        <source>Makes the axes that ply angles refer to, on a face, an edge, a point or a coordinate system</source>
        <translation>Crée les axes auxquels se rapportent les angles des plis, sur une face, une arête, un point ou un repère</translation>
    </message>
    <message>
        <source>Rosette</source>
        <translation>Rosette</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_StackSection</name>
    <message>
        <source>Shows the cut of every ply of a stack by a plane, as thick as you like</source>
        <translation>Montre la coupe de chaque pli d'un empilement par un plan, aussi épaisse que voulu</translation>
    </message>
    <message>
        <source>Stack Section</source>
        <translation>Coupe de l'empilement</translation>
    </message>
</context>
<context>
    <name>LayupPanel</name>
    <message>
        <source>Layup</source>
        <translation>Drapage</translation>
    </message>
    <message>
        <source>From the tool outwards. Double-click or press F2 to edit; drag rows to reorder</source>
        <translation>De l&apos;outil vers l&apos;extérieur. Double-clic ou F2 pour modifier ; glissez les lignes pour les déplacer</translation>
    </message>
    <message>
        <source>Ply</source>
        <translation>Pli</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>Rosette</source>
        <translation>Rosette</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Actif</translation>
    </message>
    <message>
        <source>Of the whole stack, as the table stands now</source>
        <translation>De tout l&apos;empilement, selon le tableau actuel</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Add a ply after the selected one</source>
        <translation>Ajoute un pli après celui qui est sélectionné</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Copy the selected plies below them</source>
        <translation>Copie les plis sélectionnés en dessous</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Refléter</translation>
    </message>
    <message>
        <source>Add the mirror image of the selected plies, or of all</source>
        <translation>Ajoute l&apos;image miroir des plis sélectionnés, ou de tous</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete the selected plies</source>
        <translation>Supprime les plis sélectionnés</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Monter</translation>
    </message>
    <message>
        <source>Move the selected plies towards the tool</source>
        <translation>Déplace les plis sélectionnés vers l&apos;outil</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Descendre</translation>
    </message>
    <message>
        <source>Move the selected plies away from the tool</source>
        <translation>Éloigne les plis sélectionnés de l&apos;outil</translation>
    </message>
    <message>
        <source>Give the selected plies this angle</source>
        <translation>Donne cet angle aux plis sélectionnés</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>How often the rows are laid, before they are mirrored</source>
        <translation>Combien de fois les lignes sont posées avant d&apos;être reflétées</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symétrique</translation>
    </message>
    <message>
        <source>The mirror image follows</source>
        <translation>L&apos;image miroir suit</translation>
    </message>
    <message>
        <source>Shared middle ply</source>
        <translation>Pli central commun</translation>
    </message>
    <message>
        <source>The last row is the middle of the stack</source>
        <translation>La dernière ligne est le milieu de l&apos;empilement</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Along the face&apos;s outward normal or against it</source>
        <translation>Le long de la normale extérieure de la face ou à l&apos;opposé</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
    <message>
        <source>The surface of the stack that lies on the face</source>
        <translation>La surface de l&apos;empilement qui repose sur la face</translation>
    </message>
    <message>
        <source>Import...</source>
        <translation>Importer...</translation>
    </message>
    <message>
        <source>Read a table (.csv) or a whole job (.json, .yaml)</source>
        <translation>Lit un tableau (.csv) ou un travail complet (.json, .yaml)</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exporter...</translation>
    </message>
    <message>
        <source>Write a table (.csv) or a whole job (.json, .yaml)</source>
        <translation>Écrit un tableau (.csv) ou un travail complet (.json, .yaml)</translation>
    </message>
    <message>
        <source>Angle...</source>
        <translation>Angle...</translation>
    </message>
    <message>
        <source>{count} plies, {thickness} mm</source>
        <translation>{count} plis, {thickness} mm</translation>
    </message>
    <message>
        <source>No ply is active.</source>
        <translation>Aucun pli n&apos;est actif.</translation>
    </message>
</context>
<context>
    <name>OffsetFacePanel</name>
    <message>
        <source>How far the preview is</source>
        <translation>Avancement de l'aperçu</translation>
    </message>
    <message>
        <source>Offset Face</source>
        <translation>Décaler une face</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>The faces; select some and press Remove to take them out</source>
        <translation>Les faces ; Retirer enlève celles qui sont sélectionnées</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view; Ctrl+click adds further faces</source>
        <translation>Appuyez, puis cliquez une face dans la vue 3D ; Ctrl+clic en ajoute d&apos;autres</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Take the selected faces out of the list</source>
        <translation>Retire les faces sélectionnées de la liste</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Signed distance along the face&apos;s outward normal; f(x) gives an expression</source>
        <translation>Distance signée le long de la normale extérieure ; f(x) donne une expression</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Offset to the other side</source>
        <translation>Décale de l&apos;autre côté</translation>
    </message>
    <message>
        <source>Feasible</source>
        <translation>Possible</translation>
    </message>
    <message>
        <source>Distances by which the faces can be offset before an offset folds; the places are marked on the model</source>
        <translation>Distances dont les faces peuvent être décalées avant qu&apos;un décalage se replie ; les endroits sont marqués sur le modèle</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Largest deviation from the exact offset</source>
        <translation>Plus grand écart au décalage exact</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>How the offset surface is found</source>
        <translation>Comment la surface décalée est trouvée</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Degré</translation>
    </message>
    <message>
        <source>Highest degree of the surface</source>
        <translation>Degré maximal de la surface</translation>
    </message>
    <message>
        <source>Live preview</source>
        <translation>Aperçu continu</translation>
    </message>
    <message>
        <source>Compute after every change, while you go on working</source>
        <translation>Calcule après chaque changement, pendant que vous continuez</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Compute once and leave the panel open</source>
        <translation>Calcule une fois et laisse le panneau ouvert</translation>
    </message>
    <message>
        <source>known after the first result</source>
        <translation>connu après le premier résultat</translation>
    </message>
    <message>
        <source>Computing the preview...</source>
        <translation>Calcul de l&apos;aperçu...</translation>
    </message>
</context>
<context>
    <name>OffsetLimitsPanel</name>
    <message>
        <source>Offset Limits</source>
        <translation>Limites de décalage</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>The faces; select some and press Remove to take them out</source>
        <translation>Les faces ; Retirer enlève celles qui sont sélectionnées</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view; Ctrl+click adds further faces</source>
        <translation>Appuyez, puis cliquez une face dans la vue 3D ; Ctrl+clic en ajoute d&apos;autres</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Take the selected faces out of the list</source>
        <translation>Retire les faces sélectionnées de la liste</translation>
    </message>
    <message>
        <source>Inwards</source>
        <translation>Vers l&apos;intérieur</translation>
    </message>
    <message>
        <source>Most negative feasible distance</source>
        <translation>Distance possible la plus négative</translation>
    </message>
    <message>
        <source>Outwards</source>
        <translation>Vers l&apos;extérieur</translation>
    </message>
    <message>
        <source>Largest feasible distance</source>
        <translation>Plus grande distance possible</translation>
    </message>
    <message>
        <source>Find limits</source>
        <translation>Chercher les limites</translation>
    </message>
    <message>
        <source>Search the faces that are listed</source>
        <translation>Examine les faces de la liste</translation>
    </message>
    <message>
        <source>any distance</source>
        <translation>toute distance</translation>
    </message>
</context>
<context>
    <name>PlyStackPanel</name>
    <message>
        <source>none; e.g. 0, 8, 16</source>
        <translation>aucun ; p. ex. 0, 8, 16</translation>
    </message>
    <message>
        <source>Ply Stack</source>
        <translation>Empilement de plis</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Face</translation>
    </message>
    <message>
        <source>The face</source>
        <translation>La face</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view</source>
        <translation>Appuyez, puis cliquez une face dans la vue 3D</translation>
    </message>
    <message>
        <source>Layup</source>
        <translation>Drapage</translation>
    </message>
    <message>
        <source>A layup of this document</source>
        <translation>Un drapage de ce document</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouveau</translation>
    </message>
    <message>
        <source>Make a new layup</source>
        <translation>Crée un nouveau drapage</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Largest deviation from the exact offset</source>
        <translation>Plus grand écart au décalage exact</translation>
    </message>
    <message>
        <source>Drop-off</source>
        <translation>Chute</translation>
    </message>
    <message>
        <source>Length of a ramp over its height where plies end</source>
        <translation>Longueur d&apos;une rampe sur sa hauteur où des plis finissent</translation>
    </message>
    <message>
        <source>Boundary gap</source>
        <translation>Écart du contour</translation>
    </message>
    <message>
        <source>Stagger</source>
        <translation>Étagement</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Côtés</translation>
    </message>
    <message>
        <source>inside; e.g. Edge=left</source>
        <translation>intérieur ; p. ex. Edge=left</translation>
    </message>
    <message>
        <source>The part of the face that plies keep: Edge=left; Hole=outside for boundaries with these labels. Closed boundaries: inside or outside; open ones: left or right of their direction, as seen from outside</source>
        <translation>La partie de la face que les plis gardent : Edge=left; Hole=outside pour les contours portant ces étiquettes. Contours fermés : inside (intérieur) ou outside (extérieur) ; contours ouverts : left (gauche) ou right (droite) de leur sens, vus de l'extérieur</translation>
    </message>
    <message>
        <source>Which slope of a ramp that is: the mean one, or the steepest, which makes ramps longer</source>
        <translation>De quelle pente d'une rampe il s'agit : la moyenne (mean) ou la plus forte (steepest), qui allonge les rampes</translation>
    </message>
    <message>
        <source>Ramp length</source>
        <translation>Longueur de rampe</translation>
    </message>
    <message>
        <source>Length of a ramp where plies end, in place of the drop-off; 0 mm: by the drop-off</source>
        <translation>Longueur d'une rampe là où les plis finissent, à la place de la chute ; 0 mm : selon la chute</translation>
    </message>
    <message>
        <source>Distances in mm by which successive plies keep inside of their boundary: 0, 8, 16 for all boundaries, or Edge=0,8,16; Patch=0,5 for boundaries with these labels</source>
        <translation>Distances en mm dont les plis successifs restent à l'intérieur de leur contour : 0, 8, 16 pour tous les contours, ou Edge=0,8,16; Patch=0,5 pour les contours qui portent ces étiquettes</translation>
    </message>
    <message>
        <source>Largest distance of a boundary from the face</source>
        <translation>Plus grande distance d&apos;un contour à la face</translation>
    </message>
    <message>
        <source>0 mm: a quarter of the boundary&apos;s size</source>
        <translation>0 mm : un quart de la taille du contour</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Which surface of every ply is made</source>
        <translation>Quelle surface de chaque pli est créée</translation>
    </message>
    <message>
        <source>Plies</source>
        <translation>Plis</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Solide</translation>
    </message>
    <message>
        <source>Solid plies instead of surfaces</source>
        <translation>Des solides au lieu de surfaces</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Résultat</translation>
    </message>
    <message>
        <source>One compound of all plies, or an object for every ply</source>
        <translation>Un composé de tous les plis, ou un objet par pli</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>What the plies&apos; colours stand for</source>
        <translation>Ce que signifient les couleurs des plis</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Compute once and leave the panel open</source>
        <translation>Calcule une fois et laisse le panneau ouvert</translation>
    </message>
    <message>
        <source>Choose a layup first, or press New to make one.</source>
        <translation>Choisissez d&apos;abord un drapage, ou créez-en un avec Nouveau.</translation>
    </message>
    <message>
        <source>Rosette</source>
        <translation>Rosette</translation>
    </message>
    <message>
        <source>The axes that angles count from, where a row of the layup names none. Without a rosette: the model&apos;s x axis, or another one where x stands on the face</source>
        <translation>Les axes d'où comptent les angles, là où une ligne du drapage n'en nomme pas. Sans rosette : l'axe x du modèle, ou un autre là où x est perpendiculaire à la face</translation>
    </message>
    <message>
        <source>none: an axis of the model</source>
        <translation>aucune : un axe du modèle</translation>
    </message>
</context>
<context>
    <name>PreferencesPage</name>
    <message>
        <source>Laminate Offset</source>
        <translation>Laminate Offset</translation>
    </message>
    <message>
        <source>New objects</source>
        <translation>Nouveaux objets</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Largest deviation of new offsets and stacks</source>
        <translation>Plus grand écart des nouveaux décalages et empilements</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>How the surfaces of new offsets are found</source>
        <translation>Comment les surfaces des nouveaux décalages sont trouvées</translation>
    </message>
    <message>
        <source>Highest degree</source>
        <translation>Degré maximal</translation>
    </message>
    <message>
        <source>Highest degree of new surfaces</source>
        <translation>Degré maximal des nouvelles surfaces</translation>
    </message>
    <message>
        <source>Drop-off ratio</source>
        <translation>Rapport de chute</translation>
    </message>
    <message>
        <source>Length of a ramp over its height where plies end</source>
        <translation>Longueur d&apos;une rampe sur sa hauteur où des plis finissent</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Calcul</translation>
    </message>
    <message>
        <source>Processor cores</source>
        <translation>Cœurs du processeur</translation>
    </message>
    <message>
        <source>all</source>
        <translation>tous</translation>
    </message>
    <message>
        <source>Most processor cores that a computation uses</source>
        <translation>Nombre maximal de cœurs qu&apos;un calcul utilise</translation>
    </message>
    <message>
        <source>Colours of plies</source>
        <translation>Couleurs des plis</translation>
    </message>
    <message>
        <source>0 degrees</source>
        <translation>0 degré</translation>
    </message>
    <message>
        <source>Colour of plies with fibres at this angle; in between, colours change evenly</source>
        <translation>Couleur des plis dont les fibres ont cet angle ; entre deux, les couleurs changent régulièrement</translation>
    </message>
    <message>
        <source>45 degrees</source>
        <translation>45 degrés</translation>
    </message>
    <message>
        <source>90 degrees</source>
        <translation>90 degrés</translation>
    </message>
    <message>
        <source>-45 degrees</source>
        <translation>-45 degrés</translation>
    </message>
</context>
<context>
    <name>RosettePanel</name>
    <message>
        <source>Click a face, an edge or a point in the 3-D view.</source>
        <translation>Cliquez une face, une arête ou un point dans la vue 3D.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Of the first axis, projected onto the face; an edge or a coordinate system gives its own</source>
        <translation>Du premier axe, projetée sur la face ; une arête ou un repère donne la sienne</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Sur</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Choisir</translation>
    </message>
    <message>
        <source>Press, then click a face, an edge or a point in the 3-D view</source>
        <translation>Appuyez, puis cliquez une face, une arête ou un point dans la vue 3D</translation>
    </message>
    <message>
        <source>Rosette</source>
        <translation>Rosette</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Turns the first axis about the normal; f(x) gives an expression</source>
        <translation>Tourne le premier axe autour de la normale ; f(x) prend une expression</translation>
    </message>
    <message>
        <source>What carries the rosette and moves it along</source>
        <translation>Ce qui porte la rosette et l'entraîne</translation>
    </message>
    <message>
        <source>along {axis}</source>
        <translation>le long de {axis}</translation>
    </message>
    <message>
        <source>none</source>
        <translation>rien</translation>
    </message>
</context>
<context>
    <name>StackSectionPanel</name>
    <message>
        <source>A ply stack of this document</source>
        <translation>Un empilement de plis de ce document</translation>
    </message>
    <message>
        <source>Cut the stack anew</source>
        <translation>Couper l'empilement à nouveau</translation>
    </message>
    <message>
        <source>Distance of the plane from the origin along its normal; f(x) gives an expression</source>
        <translation>Distance du plan à l'origine le long de sa normale ; f(x) prend une expression</translation>
    </message>
    <message>
        <source>How much thicker the plies are drawn than they are; the shape stays as it is</source>
        <translation>Combien de fois plus épais les plis sont dessinés ; la forme reste telle quelle</translation>
    </message>
    <message>
        <source>Names of the plies</source>
        <translation>Noms des plis</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Stack</source>
        <translation>Empilement</translation>
    </message>
    <message>
        <source>Stack Section</source>
        <translation>Coupe de l'empilement</translation>
    </message>
    <message>
        <source>The axis that the plane stands across; set the property Normal for any other</source>
        <translation>L'axe que le plan traverse ; pour tout autre, changez la propriété Normal</translation>
    </message>
    <message>
        <source>There is no ply stack in this document; make one first.</source>
        <translation>Il n'y a pas d'empilement dans ce document ; créez-en un d'abord.</translation>
    </message>
    <message>
        <source>Thicker by</source>
        <translation>Exagération</translation>
    </message>
    <message>
        <source>Write name and angle beside every ply</source>
        <translation>Écrire le nom et l'angle à côté de chaque pli</translation>
    </message>
    <message>
        <source>across {axis}</source>
        <translation>en travers de {axis}</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Laminate Offset</source>
        <translation>Laminate Offset</translation>
    </message>
</context>
</TS>
