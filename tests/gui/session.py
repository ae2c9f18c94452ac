# SPDX-License-Identifier: LGPL-2.1-or-later
"""A user's hands and eyes inside FreeCAD: select, press, type, look."""

import gc
import importlib
import os
from typing import Any, Callable, List, Tuple

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

#: Of the PySide that FreeCAD uses, 2 or 6: its own package leaves this part out.
QTest = importlib.import_module(QtCore.QObject.__module__.replace("QtCore", "QtTest")).QTest

OUT = os.environ["LAMINATE_OFFSET_GUI_OUT"]
COMMAND = "LaminateOffset_OffsetFace"
WORKBENCH = "LaminateOffsetWorkbench"


def pump(ms: int = 150) -> None:
    """Lets FreeCAD work off its events for a while."""
    clock = QtCore.QElapsedTimer()
    clock.start()
    while clock.elapsed() < ms:
        QtGui.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 10)
        QtGui.QApplication.sendPostedEvents(None, QtCore.QEvent.DeferredDelete)


def wait_until(condition: Callable[[], bool], what: str, limit_ms: int = 20000) -> None:
    """Pumps until condition holds."""
    clock = QtCore.QElapsedTimer()
    clock.start()
    while not condition():
        assert clock.elapsed() < limit_ms, f"waited in vain for {what}"
        pump(20)


def start(width: int = 1400, height: int = 900) -> Any:
    """Activates the workbench in a window of known size and opens a document with undo."""
    Gui.getMainWindow().resize(width, height)
    Gui.activateWorkbench(WORKBENCH)
    doc = App.newDocument("Scenario")
    doc.UndoMode = 1
    pump(300)
    return doc


def look_at_all() -> Any:
    """Fits an isometric view on everything. Returns the view."""
    view = Gui.ActiveDocument.ActiveView
    view.setAnimationEnabled(False)
    view.viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    pump(400)
    return view


def select(obj: Any, *subs: str) -> None:
    """Selects sub-elements and nothing else."""
    Gui.Selection.clearSelection()
    for sub in subs:
        Gui.Selection.addSelection(obj.Document.Name, obj.Name, sub)
    pump(50)


def run_command(name: str = COMMAND) -> None:
    """Runs a command as the toolbar does: Offset Face when none is named."""
    Gui.runCommand(name, 0)
    pump(300)


def edit(obj: Any) -> None:
    """What a double click in the tree does."""
    obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    pump(300)


def shown(kind: type = QtGui.QWidget, name: str = "", class_name: str = "") -> List[Any]:
    """The visible widgets of a kind, with an object name or a class of Qt where one is given."""
    children = Gui.getMainWindow().findChildren
    found = []
    for one in children(kind, name) if name else children(kind):
        try:
            if one.isVisible() and class_name in ("", one.metaObject().className()):
                found.append(one)
        except RuntimeError:  # Python's side of a widget that FreeCAD has deleted
            continue
    return found


def widget(name: str, kind: type = QtGui.QWidget) -> Any:
    """The visible widget with an object name."""
    found = shown(kind, name)
    assert len(found) == 1, f"{len(found)} visible widgets are named {name}"
    return found[0]


def type_into(name: str, text: str) -> None:
    """Replaces the text of a line or a spin box and leaves the field."""
    field = widget(name)
    line = field if isinstance(field, QtGui.QLineEdit) else field.findChild(QtGui.QLineEdit)
    line.setFocus()
    line.selectAll()
    QTest.keyClick(line, QtCore.Qt.Key_Delete)
    QTest.keyClicks(line, text)
    QTest.keyClick(line, QtCore.Qt.Key_Tab)
    pump(200)


def click(name: str) -> None:
    """Presses a button, or ticks a box, of the task panel."""
    target = widget(name)
    QTest.mouseClick(target, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, QtCore.QPoint(8, target.height() // 2))
    pump(200)


def press(role: Any) -> None:
    """Presses OK or Cancel of the task panel."""
    boxes = shown(QtGui.QDialogButtonBox)
    assert len(boxes) == 1, f"{len(boxes)} button boxes are visible"
    QTest.mouseClick(boxes[0].button(role), QtCore.Qt.LeftButton)
    pump(400)


def faces() -> List[str]:
    """The faces in the panel's list."""
    box = widget("faces", QtGui.QListWidget)
    return [box.item(row).text() for row in range(box.count())]


def result_text() -> str:
    """What the panel's result line says."""
    return widget("result", QtGui.QLabel).text()


def result_is_red() -> bool:
    """Whether the result line is shown as a refusal."""
    return "#e01b24" in widget("result", QtGui.QLabel).styleSheet()


def result_is_orange() -> bool:
    """Whether the result line is shown as a warning."""
    return "#d05c00" in widget("result", QtGui.QLabel).styleSheet()


def offsets(doc: Any) -> List[Any]:
    """The document's offset objects."""
    return [obj for obj in doc.Objects if obj.Name.startswith("OffsetFace")]


def screenshot(name: str) -> None:
    """Stores the whole screen and asserts that it was really drawn."""
    pump(200)
    image = QtGui.QApplication.primaryScreen().grabWindow(0)
    assert image.save(os.path.join(OUT, f"{name}.png"))
    assert count_colours(image.toImage()) > 20, f"{name}: the screen is empty"


def view_image() -> Any:
    """What the 3-D view shows."""
    pump(250)
    canvas, _ = centre_of_view()
    place = canvas.mapToGlobal(QtCore.QPoint(0, 0))
    return (
        QtGui.QApplication.primaryScreen()
        .grabWindow(0, place.x(), place.y(), canvas.width(), canvas.height())
        .toImage()
    )


def count_colours(image: Any, step: int = 5) -> int:
    """Number of different colours on a coarse grid of pixels."""
    return len({image.pixel(x, y) for x in range(0, image.width(), step) for y in range(0, image.height(), step)})


def centre_of_view() -> Tuple[Any, Any]:
    """The visible OpenGL widget and its centre, for mouse events."""
    canvases = shown(class_name="QOpenGLWidget")
    for _ in range(20):  # a new view may stand where Python still sees a deleted one
        if canvases:
            break
        gc.collect()
        pump(100)
        canvases = shown(class_name="QOpenGLWidget")
    assert len(canvases) == 1, f"{len(canvases)} 3-D views are visible"
    return canvases[0], QtCore.QPoint(canvases[0].width() // 2, canvases[0].height() // 2)


def click_in_view(keys: Any = QtCore.Qt.NoModifier, point: Any = None) -> None:
    """Clicks the middle of the 3-D view, or where a point [mm] is seen, with keys held down."""
    canvas, place = centre_of_view()
    if point is not None:
        x, y = Gui.ActiveDocument.ActiveView.getPointOnScreen(point)
        place = QtCore.QPoint(x, canvas.height() - 1 - y)
    QTest.mouseMove(canvas, place)
    pump(250)
    QTest.mouseClick(canvas, QtCore.Qt.LeftButton, keys, place)
    pump(400)


def words_in(obj: Any) -> List[str]:
    """The words that are drawn in the 3-D view with an object."""
    from pivy import coin

    search = coin.SoSearchAction()
    search.setType(coin.SoText2.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(obj.ViewObject.RootNode)
    paths = search.getPaths()
    return [paths[index].getTail().string[0].getString() for index in range(paths.getLength())]


def cell(row: int, column: int, text: str) -> None:
    """Types into a cell of the layup's table, as a user does: double click, keys, Enter."""
    tree = widget("rows", QtGui.QTreeWidget)
    item = tree.topLevelItem(row)
    tree.scrollToItem(item)
    place = tree.visualItemRect(item).center()
    place.setX(tree.header().sectionViewportPosition(column) + 12)
    QTest.mouseClick(tree.viewport(), QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, place)
    QTest.mouseDClick(tree.viewport(), QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, place)
    pump(100)
    editor = QtGui.QApplication.focusWidget()
    line = editor if isinstance(editor, QtGui.QLineEdit) else editor.lineEdit()
    line.selectAll()
    if text:
        QTest.keyClicks(line, text)
    else:
        QTest.keyClick(line, QtCore.Qt.Key_Delete)
    QTest.keyClick(line, QtCore.Qt.Key_Return)
    pump(100)
    assert item.text(column) == text, f"row {row}, column {column}: {item.text(column)!r} instead of {text!r}"


def inside_point(face: Any) -> Any:
    """A point [mm] of the face, not in a hole and away from the edges."""
    u0, u1, v0, v1 = face.ParameterRange
    places = [(u0 + (u1 - u0) * i / 20, v0 + (v1 - v0) * j / 20) for i in range(6, 15) for j in range(6, 15)]
    return face.valueAt(*next(place for place in places if face.isPartOfDomain(*place)))
