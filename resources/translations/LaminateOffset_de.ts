<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>CoreSamplePanel</name>
    <message>
        <source>Core Sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stack</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A ply stack of this document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the sample is taken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick a point in the 3-D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press, then click a point of the face or the stack</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no ply stack in this document; make one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a point of the face or the stack in the 3-D view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click another point for another sample.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ExtendFacePanel</name>
    <message>
        <source>Extend Face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The faces; select some and press Remove to take them out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view; Ctrl+click adds further faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the selected faces out of the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arc length of the extension; f(x) gives an expression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extend the side where u is least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>u max</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extend the side where u is largest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>v min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extend the side where v is least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>v max</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Extend the side where v is largest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Continuity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>G1: the mirror image of the part next to the side; natural: the surface&apos;s last piece goes on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean: iso-curves have the length on the average; at-least: each of them has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute once and leave the panel open</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LaminateOffset</name>
    <message>
        <source>Computing {title}...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Preview to see the result, or OK to make it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick a face first: press Pick and click a face in the 3-D view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a face in the 3-D view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit {name}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a layup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layups (*.csv *.json *.yaml *.yml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the layup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole job, YAML (*.yaml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole job, JSON (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layup</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LaminateOffset_CoreSample</name>
    <message>
        <source>Core Sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows which plies of a stack are met at a point, and from where to where</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LaminateOffset_DeviationMap</name>
    <message>
        <source>Deviation Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows in colours how far the selected offset is from the exact one</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ExportLayup</name>
    <message>
        <source>Export Layup...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the selected layup as a table (.csv) or as a whole job (.json, .yaml)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ExtendFace</name>
    <message>
        <source>Extend Face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the selected faces longer past their sides by a length</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LaminateOffset_ImportLayup</name>
    <message>
        <source>Import Layup...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads a layup table (.csv) or a whole job (.json, .yaml)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LaminateOffset_Layup</name>
    <message>
        <source>Layup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes a layup: a table of plies with materials, angles, thicknesses</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LaminateOffset_OffsetFace</name>
    <message>
        <source>Offset Face</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LaminateOffset_OffsetLimits</name>
    <message>
        <source>Offset Limits</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LaminateOffset_PlyStack</name>
    <message>
        <source>Ply Stack</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lays the plies of a layup on the selected face</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LayupPanel</name>
    <message>
        <source>Layup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the tool outwards. Double-click or press F2 to edit; drag rows to reorder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a ply after the selected one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selected plies below them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the mirror image of the selected plies, or of all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the selected plies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the selected plies towards the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the selected plies away from the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the selected plies this angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often the rows are laid, before they are mirrored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mirror image follows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shared middle ply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last row is the middle of the stack</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the face&apos;s outward normal or against it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surface of the stack that lies on the face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read a table (.csv) or a whole job (.json, .yaml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a table (.csv) or a whole job (.json, .yaml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} plies, {thickness} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No ply is active.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>OffsetFacePanel</name>
    <message>
        <source>Offset Face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The faces; select some and press Remove to take them out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view; Ctrl+click adds further faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the selected faces out of the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signed distance along the face&apos;s outward normal; f(x) gives an expression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset to the other side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feasible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distances by which the faces can be offset before an offset folds; the places are marked on the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest deviation from the exact offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the offset surface is found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Degree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest degree of the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute after every change, while you go on working</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute once and leave the panel open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>known after the first result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing the preview...</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>OffsetLimitsPanel</name>
    <message>
        <source>Offset Limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The faces; select some and press Remove to take them out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view; Ctrl+click adds further faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the selected faces out of the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Most negative feasible distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest feasible distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the faces that are listed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any distance</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlyStackPanel</name>
    <message>
        <source>Ply Stack</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press, then click a face in the 3-D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A layup of this document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make a new layup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest deviation from the exact offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which surface of every ply is made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One compound of all plies, or an object for every ply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the plies&apos; colours stand for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute once and leave the panel open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a layup first, or press New to make one.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
