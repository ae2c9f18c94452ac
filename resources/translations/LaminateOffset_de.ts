<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>CoreSamplePanel</name>
    <message>
        <source>The plies at the point, from the top; From and To are distances from the face in mm</source>
        <translation>Die Lagen an dem Punkt, von oben; Von und Bis sind Abstände von der Fläche in mm</translation>
    </message>
    <message>
        <source>Core Sample</source>
        <translation>Kernprobe</translation>
    </message>
    <message>
        <source>Stack</source>
        <translation>Stapel</translation>
    </message>
    <message>
        <source>A ply stack of this document</source>
        <translation>Ein Lagenstapel dieses Dokuments</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Where the sample is taken</source>
        <translation>Wo die Probe genommen wird</translation>
    </message>
    <message>
        <source>Pick a point in the 3-D view</source>
        <translation>Einen Punkt in der 3D-Ansicht wählen</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Press, then click a point of the face or the stack</source>
        <translation>Drücken, dann einen Punkt der Fläche oder des Stapels anklicken</translation>
    </message>
    <message>
        <source>Ply</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>There is no ply stack in this document; make one first.</source>
        <translation>In diesem Dokument gibt es keinen Lagenstapel; legen Sie zuerst einen an.</translation>
    </message>
    <message>
        <source>Click a point of the face or the stack in the 3-D view.</source>
        <translation>Klicken Sie in der 3D-Ansicht einen Punkt der Fläche oder des Stapels an.</translation>
    </message>
    <message>
        <source>Click another point for another sample.</source>
        <translation>Klicken Sie für eine andere Probe einen anderen Punkt an.</translation>
    </message>
</context>
<context>
    <name>CurvatureMapPanel</name>
    <message>
        <source>Curvature Map</source>
        <translation>Krümmungskarte</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view; Ctrl+click adds further faces</source>
        <translation>Drücken, dann eine Fläche in der 3D-Ansicht anklicken; Strg+Klick fügt weitere hinzu</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Sample the faces that are listed</source>
        <translation>Die aufgeführten Flächen abtasten</translation>
    </message>
    <message>
        <source>Shows</source>
        <translation>Zeigt</translation>
    </message>
    <message>
        <source>Take the selected faces out of the list</source>
        <translation>Nimmt die ausgewählten Flächen aus der Liste</translation>
    </message>
    <message>
        <source>The faces; select some and press Remove to take them out</source>
        <translation>Die Flächen; ausgewählte nimmt Entfernen heraus</translation>
    </message>
    <message>
        <source>The wanted distance, signed along the face's outward normal; f(x) gives an expression</source>
        <translation>Der gewünschte Abstand mit Vorzeichen entlang der äußeren Flächennormalen; f(x) nimmt einen Ausdruck</translation>
    </message>
    <message>
        <source>What the colours stand for: how much of the limit the distance uses up, or the limit on one side</source>
        <translation>Wofür die Farben stehen: wie viel der Grenze der Abstand verbraucht, oder die Grenze auf einer Seite</translation>
    </message>
</context>
<context>
    <name>DeviationMapPanel</name>
    <message>
        <source>Choose an offset first.</source>
        <translation>Wählen Sie zuerst eine Versatzfläche.</translation>
    </message>
    <message>
        <source>Deviation Map</source>
        <translation>Abweichungskarte</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Höchste</translation>
    </message>
    <message>
        <source>Least number of triangles; more take longer</source>
        <translation>Mindestzahl der Dreiecke; mehr dauern länger</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Niedrigste</translation>
    </message>
    <message>
        <source>Measure the offset anew</source>
        <translation>Die Versatzfläche neu messen</translation>
    </message>
    <message>
        <source>Most negative deviation seen</source>
        <translation>Größte gesehene Abweichung nach unten</translation>
    </message>
    <message>
        <source>Most positive deviation seen</source>
        <translation>Größte gesehene Abweichung nach oben</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatzfläche</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>The offset that is measured</source>
        <translation>Die Versatzfläche, die gemessen wird</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
</context>
<context>
    <name>ExtendFacePanel</name>
    <message>
        <source>Extend Face</source>
        <translation>Fläche verlängern</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>The faces; select some and press Remove to take them out</source>
        <translation>Die Flächen; ausgewählte nimmt Entfernen heraus</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view; Ctrl+click adds further faces</source>
        <translation>Drücken, dann eine Fläche in der 3D-Ansicht anklicken; Strg+Klick fügt weitere hinzu</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Take the selected faces out of the list</source>
        <translation>Nimmt die ausgewählten Flächen aus der Liste</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Arc length of the extension; f(x) gives an expression</source>
        <translation>Bogenlänge der Verlängerung; f(x) gibt einen Ausdruck an</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>u min</source>
        <translation>u min</translation>
    </message>
    <message>
        <source>Extend the side where u is least</source>
        <translation>Die Seite verlängern, an der u am kleinsten ist</translation>
    </message>
    <message>
        <source>u max</source>
        <translation>u max</translation>
    </message>
    <message>
        <source>Extend the side where u is largest</source>
        <translation>Die Seite verlängern, an der u am größten ist</translation>
    </message>
    <message>
        <source>v min</source>
        <translation>v min</translation>
    </message>
    <message>
        <source>Extend the side where v is least</source>
        <translation>Die Seite verlängern, an der v am kleinsten ist</translation>
    </message>
    <message>
        <source>v max</source>
        <translation>v max</translation>
    </message>
    <message>
        <source>Extend the side where v is largest</source>
        <translation>Die Seite verlängern, an der v am größten ist</translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation>Stetigkeit</translation>
    </message>
    <message>
        <source>G1: the mirror image of the part next to the side; natural: the surface&apos;s last piece goes on</source>
        <translation>G1: das Spiegelbild des Teils an der Seite; natural: das letzte Stück der Fläche geht weiter</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Regel</translation>
    </message>
    <message>
        <source>mean: iso-curves have the length on the average; at-least: each of them has it</source>
        <translation>mean: Isokurven haben die Länge im Mittel; at-least: jede hat sie mindestens</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Compute once and leave the panel open</source>
        <translation>Einmal rechnen und das Fenster offen lassen</translation>
    </message>
</context>
<context>
    <name>LaminateOffset</name>
    <message>
        <source>Export the stack</source>
        <translation>Stapel exportieren</translation>
    </message>
    <message>
        <source>STEP, one part a ply (*.step)</source>
        <translation>STEP, ein Teil je Lage (*.step)</translation>
    </message>
    <message>
        <source>Table of the plies (*.csv)</source>
        <translation>Tabelle der Lagen (*.csv)</translation>
    </message>
    <message>
        <source>CalculiX shell section (*.inp)</source>
        <translation>CalculiX-Schalenquerschnitt (*.inp)</translation>
    </message>
    <message>
        <source>HDF5 composite CAE (*.h5)</source>
        <translation>HDF5 Composite CAE (*.h5)</translation>
    </message>
    <message>
        <source>Ply book (*.html)</source>
        <translation>Lagenbuch (*.html)</translation>
    </message>
    <message>
        <source>Import a layup</source>
        <translation>Lagenaufbau importieren</translation>
    </message>
    <message>
        <source>Layups (*.csv *.json *.yaml *.yml)</source>
        <translation>Lagenaufbauten (*.csv *.json *.yaml *.yml)</translation>
    </message>
    <message>
        <source>Export the layup</source>
        <translation>Lagenaufbau exportieren</translation>
    </message>
    <message>
        <source>Whole job, YAML (*.yaml)</source>
        <translation>Ganzer Auftrag, YAML (*.yaml)</translation>
    </message>
    <message>
        <source>Whole job, JSON (*.json)</source>
        <translation>Ganzer Auftrag, JSON (*.json)</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Layup</source>
        <translation>Lagenaufbau</translation>
    </message>
    <message>
        <source>FreeCAD could not recompute the object: {error}</source>
        <translation>FreeCAD konnte das Objekt nicht neu berechnen: {error}</translation>
    </message>
    <message>
        <source>Press Preview to see the result, or OK to make it.</source>
        <translation>Vorschau zeigt das Ergebnis, OK übernimmt es.</translation>
    </message>
    <message>
        <source>Pick a face first: press Pick and click a face in the 3-D view.</source>
        <translation>Wählen Sie zuerst eine Fläche: Wählen drücken und eine Fläche in der 3D-Ansicht anklicken.</translation>
    </message>
    <message>
        <source>Click a face in the 3-D view.</source>
        <translation>Klicken Sie eine Fläche in der 3D-Ansicht an.</translation>
    </message>
    <message>
        <source>Edit {name}</source>
        <translation>{name} bearbeiten</translation>
    </message>
    <message>
        <source>Computing {title}...</source>
        <translation>{title} wird berechnet...</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Limit inwards</source>
        <translation>Grenze nach innen</translation>
    </message>
    <message>
        <source>Limit outwards</source>
        <translation>Grenze nach außen</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>folds</source>
        <translation>faltet sich</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_CoreSample</name>
    <message>
        <source>Core Sample</source>
        <translation>Kernprobe</translation>
    </message>
    <message>
        <source>Shows which plies of a stack are met at a point, and from where to where</source>
        <translation>Zeigt, welche Lagen eines Stapels an einem Punkt liegen, und von wo bis wo</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_CurvatureMap</name>
    <message>
        <source>Curvature Map</source>
        <translation>Krümmungskarte</translation>
    </message>
    <message>
        <source>Shows in colours how near a distance is to the curvature limit of the faces</source>
        <translation>Zeigt in Farben, wie nahe ein Abstand der Krümmungsgrenze der Flächen kommt</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_DeviationMap</name>
    <message>
        <source>Deviation Map</source>
        <translation>Abweichungskarte</translation>
    </message>
    <message>
        <source>Shows in colours how far the selected offset is from the exact one</source>
        <translation>Zeigt in Farben, wie weit der gewählte Versatz vom genauen entfernt ist</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ExplodedView</name>
    <message>
        <source>Draws the plies of the selected stack apart from each other; again: together</source>
        <translation>Zeichnet die Lagen des gewählten Stapels auseinander; noch einmal: zusammen</translation>
    </message>
    <message>
        <source>Exploded View</source>
        <translation>Explosionsansicht</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ExportLayup</name>
    <message>
        <source>Export Layup...</source>
        <translation>Lagenaufbau exportieren...</translation>
    </message>
    <message>
        <source>Writes the selected layup as a table (.csv) or as a whole job (.json, .yaml)</source>
        <translation>Schreibt den gewählten Lagenaufbau als Tabelle (.csv) oder als ganzen Auftrag (.json, .yaml)</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ExportPlyBook</name>
    <message>
        <source>Export Ply Book...</source>
        <translation>Lagenbuch exportieren...</translation>
    </message>
    <message>
        <source>Writes the ply book of the selected stack: a page with a picture for every ply</source>
        <translation>Schreibt das Lagenbuch des gewählten Stapels: eine Seite mit Bild für jede Lage</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ExportStack</name>
    <message>
        <source>Export Stack...</source>
        <translation>Stapel exportieren...</translation>
    </message>
    <message>
        <source>Writes the selected stack: STEP with named plies, table, ply book, CalculiX section, HDF5 composite CAE</source>
        <translation>Schreibt den gewählten Lagenstapel: STEP mit benannten Lagen, Lagentabelle, Lagenbuch, CalculiX-Querschnitt, HDF5 Composite CAE</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ExtendFace</name>
    <message>
        <source>Extend Face</source>
        <translation>Fläche verlängern</translation>
    </message>
    <message>
        <source>Makes the selected faces longer past their sides by a length</source>
        <translation>Verlängert die gewählten Flächen über ihre Seiten hinaus</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ImportLayup</name>
    <message>
        <source>Import Layup...</source>
        <translation>Lagenaufbau importieren...</translation>
    </message>
    <message>
        <source>Reads a layup table (.csv) or a whole job (.json, .yaml)</source>
        <translation>Liest eine Lagentabelle (.csv) oder einen ganzen Auftrag (.json, .yaml)</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_Layup</name>
    <message>
        <source>Layup</source>
        <translation>Lagenaufbau</translation>
    </message>
    <message>
        <source>Makes a layup: a table of plies with materials, angles, thicknesses</source>
        <translation>Legt einen Lagenaufbau an: eine Tabelle der Lagen mit Materialien, Winkeln, Dicken</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_OffsetFace</name>
    <message>
        <source>Offset Face</source>
        <translation>Fläche versetzen</translation>
    </message>
    <message>
        <source>Offsets the selected faces by a constant distance, within a tolerance</source>
        <translation>Versetzt die gewählten Flächen um einen festen Abstand, innerhalb einer Toleranz</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_OffsetLimits</name>
    <message>
        <source>Offset Limits</source>
        <translation>Versatzgrenzen</translation>
    </message>
    <message>
        <source>Shows how far faces can be offset, and where an offset would fold first</source>
        <translation>Zeigt, wie weit Flächen versetzt werden können und wo ein Versatz zuerst falten würde</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_PlyStack</name>
    <message>
        <source>Ply Stack</source>
        <translation>Lagenstapel</translation>
    </message>
    <message>
        <source>Lays the plies of a layup on the selected face</source>
        <translation>Legt die Lagen eines Lagenaufbaus auf die gewählte Fläche</translation>
    </message>
</context>
<context>
    <name>LaminateOffset_Rosette</name>
    <message>
        <source>Makes the axes that ply angles refer to, on a face, an edge, a point or a coordinate system</source>
        <translation>Erzeugt die Achsen, auf die sich Lagenwinkel beziehen, auf einer Fläche, einer Kante, einem Punkt oder einem Koordinatensystem</translation>
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
        <translation>Zeigt den Schnitt jeder Lage eines Stapels mit einer Ebene, so dick wie gewünscht</translation>
    </message>
    <message>
        <source>Stack Section</source>
        <translation>Stapelschnitt</translation>
    </message>
</context>
<context>
    <name>LayupPanel</name>
    <message>
        <source>Layup</source>
        <translation>Lagenaufbau</translation>
    </message>
    <message>
        <source>From the tool outwards. Double-click or press F2 to edit; drag rows to reorder</source>
        <translation>Vom Werkzeug nach außen. Doppelklick oder F2 bearbeitet; Zeilen lassen sich ziehen</translation>
    </message>
    <message>
        <source>Ply</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Rosette</source>
        <translation>Rosette</translation>
    </message>
    <message>
        <source>On</source>
        <translation>An</translation>
    </message>
    <message>
        <source>Of the whole stack, as the table stands now</source>
        <translation>Des ganzen Stapels, so wie die Tabelle jetzt ist</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Add a ply after the selected one</source>
        <translation>Fügt nach der gewählten eine Lage ein</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Doppeln</translation>
    </message>
    <message>
        <source>Copy the selected plies below them</source>
        <translation>Kopiert die gewählten Lagen darunter</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Add the mirror image of the selected plies, or of all</source>
        <translation>Fügt das Spiegelbild der gewählten oder aller Lagen an</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the selected plies</source>
        <translation>Löscht die gewählten Lagen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Move the selected plies towards the tool</source>
        <translation>Bewegt die gewählten Lagen zum Werkzeug hin</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Move the selected plies away from the tool</source>
        <translation>Bewegt die gewählten Lagen vom Werkzeug weg</translation>
    </message>
    <message>
        <source>Give the selected plies this angle</source>
        <translation>Gibt den gewählten Lagen diesen Winkel</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>How often the rows are laid, before they are mirrored</source>
        <translation>Wie oft die Zeilen gelegt werden, bevor sie gespiegelt werden</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symmetrisch</translation>
    </message>
    <message>
        <source>The mirror image follows</source>
        <translation>Das Spiegelbild folgt</translation>
    </message>
    <message>
        <source>Shared middle ply</source>
        <translation>Gemeinsame Mittellage</translation>
    </message>
    <message>
        <source>The last row is the middle of the stack</source>
        <translation>Die letzte Zeile ist die Mitte des Stapels</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Along the face&apos;s outward normal or against it</source>
        <translation>Entlang der äußeren Normalen der Fläche oder dagegen</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Bezug</translation>
    </message>
    <message>
        <source>The surface of the stack that lies on the face</source>
        <translation>Die Fläche des Stapels, die auf der Fläche liegt</translation>
    </message>
    <message>
        <source>Import...</source>
        <translation>Importieren...</translation>
    </message>
    <message>
        <source>Read a table (.csv) or a whole job (.json, .yaml)</source>
        <translation>Liest eine Tabelle (.csv) oder einen ganzen Auftrag (.json, .yaml)</translation>
    </message>
    <message>
        <source>Export...</source>
        <translation>Exportieren...</translation>
    </message>
    <message>
        <source>Write a table (.csv) or a whole job (.json, .yaml)</source>
        <translation>Schreibt eine Tabelle (.csv) oder einen ganzen Auftrag (.json, .yaml)</translation>
    </message>
    <message>
        <source>Angle...</source>
        <translation>Winkel...</translation>
    </message>
    <message>
        <source>{count} plies, {thickness} mm</source>
        <translation>{count} Lagen, {thickness} mm</translation>
    </message>
    <message>
        <source>No ply is active.</source>
        <translation>Keine Lage ist aktiv.</translation>
    </message>
</context>
<context>
    <name>OffsetFacePanel</name>
    <message>
        <source>How far the preview is</source>
        <translation>Wie weit die Vorschau ist</translation>
    </message>
    <message>
        <source>Offset Face</source>
        <translation>Fläche versetzen</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>The faces; select some and press Remove to take them out</source>
        <translation>Die Flächen; ausgewählte nimmt Entfernen heraus</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view; Ctrl+click adds further faces</source>
        <translation>Drücken, dann eine Fläche in der 3D-Ansicht anklicken; Strg+Klick fügt weitere hinzu</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Take the selected faces out of the list</source>
        <translation>Nimmt die ausgewählten Flächen aus der Liste</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Signed distance along the face&apos;s outward normal; f(x) gives an expression</source>
        <translation>Abstand mit Vorzeichen entlang der äußeren Normalen; f(x) gibt einen Ausdruck an</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Offset to the other side</source>
        <translation>Auf die andere Seite versetzen</translation>
    </message>
    <message>
        <source>Feasible</source>
        <translation>Möglich</translation>
    </message>
    <message>
        <source>Distances by which the faces can be offset before an offset folds; the places are marked on the model</source>
        <translation>Abstände, um die sich die Flächen versetzen lassen, bevor ein Versatz faltet; die Stellen sind am Modell markiert</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Largest deviation from the exact offset</source>
        <translation>Größte Abweichung vom genauen Versatz</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>How the offset surface is found</source>
        <translation>Wie die versetzte Fläche gefunden wird</translation>
    </message>
    <message>
        <source>Degree</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>Highest degree of the surface</source>
        <translation>Höchster Grad der Fläche</translation>
    </message>
    <message>
        <source>Live preview</source>
        <translation>Live-Vorschau</translation>
    </message>
    <message>
        <source>Compute after every change, while you go on working</source>
        <translation>Nach jeder Änderung rechnen, während Sie weiterarbeiten</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Compute once and leave the panel open</source>
        <translation>Einmal rechnen und das Fenster offen lassen</translation>
    </message>
    <message>
        <source>known after the first result</source>
        <translation>nach dem ersten Ergebnis bekannt</translation>
    </message>
    <message>
        <source>Computing the preview...</source>
        <translation>Die Vorschau wird berechnet...</translation>
    </message>
</context>
<context>
    <name>OffsetLimitsPanel</name>
    <message>
        <source>Offset Limits</source>
        <translation>Versatzgrenzen</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>The faces; select some and press Remove to take them out</source>
        <translation>Die Flächen; ausgewählte nimmt Entfernen heraus</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view; Ctrl+click adds further faces</source>
        <translation>Drücken, dann eine Fläche in der 3D-Ansicht anklicken; Strg+Klick fügt weitere hinzu</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Take the selected faces out of the list</source>
        <translation>Nimmt die ausgewählten Flächen aus der Liste</translation>
    </message>
    <message>
        <source>Inwards</source>
        <translation>Nach innen</translation>
    </message>
    <message>
        <source>Most negative feasible distance</source>
        <translation>Kleinster möglicher Abstand</translation>
    </message>
    <message>
        <source>Outwards</source>
        <translation>Nach außen</translation>
    </message>
    <message>
        <source>Largest feasible distance</source>
        <translation>Größter möglicher Abstand</translation>
    </message>
    <message>
        <source>Find limits</source>
        <translation>Grenzen suchen</translation>
    </message>
    <message>
        <source>Search the faces that are listed</source>
        <translation>Untersucht die Flächen der Liste</translation>
    </message>
    <message>
        <source>any distance</source>
        <translation>jeder Abstand</translation>
    </message>
</context>
<context>
    <name>PlyStackPanel</name>
    <message>
        <source>none; e.g. 0, 8, 16</source>
        <translation>keine; z. B. 0, 8, 16</translation>
    </message>
    <message>
        <source>Ply Stack</source>
        <translation>Lagenstapel</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>The face</source>
        <translation>Die Fläche</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view</source>
        <translation>Drücken, dann eine Fläche in der 3D-Ansicht anklicken</translation>
    </message>
    <message>
        <source>Layup</source>
        <translation>Lagenaufbau</translation>
    </message>
    <message>
        <source>A layup of this document</source>
        <translation>Ein Lagenaufbau dieses Dokuments</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Make a new layup</source>
        <translation>Legt einen neuen Lagenaufbau an</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Largest deviation from the exact offset</source>
        <translation>Größte Abweichung vom genauen Versatz</translation>
    </message>
    <message>
        <source>Drop-off</source>
        <translation>Abstufung</translation>
    </message>
    <message>
        <source>Length of a ramp over its height where plies end</source>
        <translation>Länge einer Rampe zu ihrer Höhe, wo Lagen enden</translation>
    </message>
    <message>
        <source>Boundary gap</source>
        <translation>Randabstand</translation>
    </message>
    <message>
        <source>Stagger</source>
        <translation>Staffelung</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>inside; e.g. Edge=left</source>
        <translation>innen; z. B. Edge=left</translation>
    </message>
    <message>
        <source>The part of the face that plies keep: Edge=left; Hole=outside for boundaries with these labels. Closed boundaries: inside or outside; open ones: left or right of their direction, as seen from outside</source>
        <translation>Der Teil der Fläche, den Lagen behalten: Edge=left; Hole=outside für Grenzen mit diesen Bezeichnungen. Geschlossene Grenzen: inside (innen) oder outside (außen); offene: left (links) oder right (rechts) ihrer Richtung, von außen gesehen</translation>
    </message>
    <message>
        <source>Which slope of a ramp that is: the mean one, or the steepest, which makes ramps longer</source>
        <translation>Welche Steigung einer Rampe das ist: die mittlere (mean) oder die größte (steepest), die Rampen länger macht</translation>
    </message>
    <message>
        <source>Ramp length</source>
        <translation>Rampenlänge</translation>
    </message>
    <message>
        <source>Length of a ramp where plies end, in place of the drop-off; 0 mm: by the drop-off</source>
        <translation>Länge einer Rampe, wo Lagen enden, anstelle der Abstufung; 0 mm: nach der Abstufung</translation>
    </message>
    <message>
        <source>Distances in mm by which successive plies keep inside of their boundary: 0, 8, 16 for all boundaries, or Edge=0,8,16; Patch=0,5 for boundaries with these labels</source>
        <translation>Abstände in mm, um die aufeinanderfolgende Lagen innerhalb ihrer Grenze bleiben: 0, 8, 16 für alle Grenzen, oder Edge=0,8,16; Patch=0,5 für Grenzen mit diesen Bezeichnungen</translation>
    </message>
    <message>
        <source>Largest distance of a boundary from the face</source>
        <translation>Größter Abstand einer Grenze von der Fläche</translation>
    </message>
    <message>
        <source>0 mm: a quarter of the boundary&apos;s size</source>
        <translation>0 mm: ein Viertel der Größe der Grenze</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Which surface of every ply is made</source>
        <translation>Welche Seite jeder Lage erzeugt wird</translation>
    </message>
    <message>
        <source>Plies</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>Solid plies instead of surfaces</source>
        <translation>Körper statt Flächen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>One compound of all plies, or an object for every ply</source>
        <translation>Ein Verbund aller Lagen oder ein Objekt je Lage</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>What the plies&apos; colours stand for</source>
        <translation>Wofür die Farben der Lagen stehen</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Compute once and leave the panel open</source>
        <translation>Einmal rechnen und das Fenster offen lassen</translation>
    </message>
    <message>
        <source>Choose a layup first, or press New to make one.</source>
        <translation>Wählen Sie zuerst einen Lagenaufbau, oder legen Sie mit Neu einen an.</translation>
    </message>
    <message>
        <source>Rosette</source>
        <translation>Rosette</translation>
    </message>
    <message>
        <source>The axes that angles count from, where a row of the layup names none. Without a rosette: the model&apos;s x axis, or another one where x stands on the face</source>
        <translation>Die Achsen, von denen Winkel zählen, wo eine Zeile des Lagenaufbaus keine nennt. Ohne Rosette: die x-Achse des Modells, oder eine andere, wo x auf der Fläche steht</translation>
    </message>
    <message>
        <source>none: an axis of the model</source>
        <translation>keine: eine Achse des Modells</translation>
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
        <translation>Neue Objekte</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Largest deviation of new offsets and stacks</source>
        <translation>Größte Abweichung neuer Versätze und Stapel</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>How the surfaces of new offsets are found</source>
        <translation>Wie die Flächen neuer Versätze gefunden werden</translation>
    </message>
    <message>
        <source>Highest degree</source>
        <translation>Höchster Grad</translation>
    </message>
    <message>
        <source>Highest degree of new surfaces</source>
        <translation>Höchster Grad neuer Flächen</translation>
    </message>
    <message>
        <source>Drop-off ratio</source>
        <translation>Abstufung</translation>
    </message>
    <message>
        <source>Length of a ramp over its height where plies end</source>
        <translation>Länge einer Rampe zu ihrer Höhe, wo Lagen enden</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Rechnen</translation>
    </message>
    <message>
        <source>Processor cores</source>
        <translation>Prozessorkerne</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Most processor cores that a computation uses</source>
        <translation>Höchste Zahl der Prozessorkerne, die eine Rechnung nutzt</translation>
    </message>
    <message>
        <source>Colours of plies</source>
        <translation>Farben der Lagen</translation>
    </message>
    <message>
        <source>0 degrees</source>
        <translation>0 Grad</translation>
    </message>
    <message>
        <source>Colour of plies with fibres at this angle; in between, colours change evenly</source>
        <translation>Farbe der Lagen mit Fasern in diesem Winkel; dazwischen gehen die Farben ineinander über</translation>
    </message>
    <message>
        <source>45 degrees</source>
        <translation>45 Grad</translation>
    </message>
    <message>
        <source>90 degrees</source>
        <translation>90 Grad</translation>
    </message>
    <message>
        <source>-45 degrees</source>
        <translation>-45 Grad</translation>
    </message>
</context>
<context>
    <name>RosettePanel</name>
    <message>
        <source>Click a face, an edge or a point in the 3-D view.</source>
        <translation>Klicken Sie eine Fläche, eine Kante oder einen Punkt in der 3D-Ansicht an.</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Of the first axis, projected onto the face; an edge or a coordinate system gives its own</source>
        <translation>Der ersten Achse, auf die Fläche projiziert; eine Kante oder ein Koordinatensystem gibt die eigene vor</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Press, then click a face, an edge or a point in the 3-D view</source>
        <translation>Drücken, dann eine Fläche, eine Kante oder einen Punkt in der 3D-Ansicht anklicken</translation>
    </message>
    <message>
        <source>Rosette</source>
        <translation>Rosette</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Turns the first axis about the normal; f(x) gives an expression</source>
        <translation>Dreht die erste Achse um die Normale; f(x) nimmt einen Ausdruck</translation>
    </message>
    <message>
        <source>What carries the rosette and moves it along</source>
        <translation>Was die Rosette trägt und mitnimmt</translation>
    </message>
    <message>
        <source>along {axis}</source>
        <translation>entlang {axis}</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nichts</translation>
    </message>
</context>
<context>
    <name>StackSectionPanel</name>
    <message>
        <source>A ply stack of this document</source>
        <translation>Ein Lagenstapel dieses Dokuments</translation>
    </message>
    <message>
        <source>Cut the stack anew</source>
        <translation>Den Stapel neu schneiden</translation>
    </message>
    <message>
        <source>Distance of the plane from the origin along its normal; f(x) gives an expression</source>
        <translation>Abstand der Ebene vom Ursprung entlang ihrer Normalen; f(x) nimmt einen Ausdruck</translation>
    </message>
    <message>
        <source>How much thicker the plies are drawn than they are; the shape stays as it is</source>
        <translation>Wie viel dicker die Lagen gezeichnet werden, als sie sind; die Form bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>Names of the plies</source>
        <translation>Namen der Lagen</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage der Ebene</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Stack</source>
        <translation>Stapel</translation>
    </message>
    <message>
        <source>Stack Section</source>
        <translation>Stapelschnitt</translation>
    </message>
    <message>
        <source>The axis that the plane stands across; set the property Normal for any other</source>
        <translation>Die Achse, zu der die Ebene quer steht; für jede andere die Eigenschaft Normal setzen</translation>
    </message>
    <message>
        <source>There is no ply stack in this document; make one first.</source>
        <translation>In diesem Dokument gibt es keinen Lagenstapel; legen Sie zuerst einen an.</translation>
    </message>
    <message>
        <source>Thicker by</source>
        <translation>Überhöhung</translation>
    </message>
    <message>
        <source>Write name and angle beside every ply</source>
        <translation>Name und Winkel neben jede Lage schreiben</translation>
    </message>
    <message>
        <source>across {axis}</source>
        <translation>quer zu {axis}</translation>
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
