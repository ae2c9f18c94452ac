# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the task panels of all our objects have in common."""

from typing import Any, List, Mapping, Tuple

import FreeCADGui
from PySide import QtCore, QtGui

from ...features.base_face import describe, links_of, rooted_links
from ...features.outcome import is_good
from ..resources import form
from ..selection import FacePicker, Link
from ..texts import translate

#: Legible on light and dark ground.
_REFUSED = "color: #e01b24;"
_WARNED = "color: #d05c00;"


def flags(value: Any) -> int:
    """Qt's flags as a number, in Qt 5 and Qt 6."""
    return int(getattr(value, "value", value))


class LineInSight(QtCore.QObject):
    """Scrolls to a line, again whenever the panel's height changes: a longer text gets its place only after several layouts."""

    def __init__(self, line: Any):
        super().__init__(line)
        self._line = line
        self._kept = False
        self._areas: List[Any] = []

    def keep(self, kept: bool) -> None:
        """From now on, or no longer."""
        self._kept = kept
        if kept:
            QtCore.QTimer.singleShot(0, self._reveal)

    def _reveal(self, *_range: int) -> None:
        if not self._kept:
            return
        if not self._areas:
            self._areas = self._find_areas()
        for area in self._areas:
            sideways = area.horizontalScrollBar()
            before = sideways.value()
            area.ensureWidgetVisible(self._line, 0, 0)
            sideways.setValue(before)

    def _find_areas(self) -> List[Any]:
        # Asked from above: a parent's wrapper takes the line's along when it goes.
        every = FreeCADGui.getMainWindow().findChildren(QtGui.QScrollArea)
        areas = [area for area in every if area.isAncestorOf(self._line)]
        for area in areas:
            area.verticalScrollBar().rangeChanged.connect(self._reveal)
        return areas


class FeaturePanel:
    """Edits one object in an open transaction; FreeCAD calls the methods with its names (accept, reject...)."""

    #: Name of the form, and of the widgets' texts for translators.
    FORM = ""
    #: What the panel needs so that nothing is cut off [pixels].
    WIDTH = 290
    #: Quantity fields, lists of words, ticks and whole numbers: widgets and the object's properties.
    LENGTHS: Mapping[str, str] = {}
    CHOICES: Mapping[str, str] = {}
    TICKS: Mapping[str, str] = {}
    NUMBERS: Mapping[str, str] = {}

    def __init__(self, feature: Any):
        self._doc = feature.Document
        self._feature = feature
        self.form = FreeCADGui.PySideUic.loadUi(form(self.FORM))
        self._sight = LineInSight(self.form.result)
        self._fill()
        self._connect()

    def start(self) -> None:
        """Called once the panel is visible."""

    def getStandardButtons(self) -> int:
        """OK and Cancel."""
        return flags(QtGui.QDialogButtonBox.Ok | QtGui.QDialogButtonBox.Cancel)

    def accept(self) -> bool:
        """Keeps the object, unless it was refused: then the panel stays and says why."""
        if not self.compute():
            return False
        self._close()
        self._doc.recompute()
        if any("Touched" in obj.State for obj in self._doc.Objects):
            self._doc.recompute()  # plies that the first pass has made
        self._doc.commitTransaction()
        self._end_editing()
        return True

    def reject(self) -> bool:
        """Takes back everything since the panel was opened."""
        self._close()
        self._doc.abortTransaction()
        self._end_editing()
        self._doc.recompute()
        return True

    def compute(self, *_checked: Any) -> bool:
        """Recomputes the object and shows the outcome. Returns whether it is valid."""
        missing = self.missing()
        if missing:
            self.tell(missing, refused=True)
            return False
        self._feature.touch()
        self._doc.recompute([self._feature])
        self.show_result()
        return is_good(self._feature)

    def missing(self) -> str:
        """What the user has to do before anything can be computed; "" when all is there."""
        return ""

    def changed(self) -> None:
        """A value has changed since the last result."""
        self.tell(translate("LaminateOffset", "Press Preview to see the result, or OK to make it."))

    def show_result(self) -> None:
        """Shows what the last recompute told; where an expression ended it before it began, FreeCAD's own words."""
        good = is_good(self._feature)
        if self._feature.Status == "ok" and not good:
            text = translate("LaminateOffset", "FreeCAD could not recompute the object: {error}")
            self.tell(text.format(error=self._feature.getStatusString()), refused=True)
        else:
            self.tell(self._feature.Message, not good, bool(self._feature.Warnings))

    def tell(self, text: str, refused: bool = False, warned: bool = False) -> None:
        """The panel's last line; a refusal is red, a warning orange, and both are scrolled to where they are seen."""
        self.form.result.setStyleSheet(_REFUSED if refused else _WARNED if warned else "")
        self.form.result.setText(text)
        self._sight.keep(refused or warned)

    def closing(self) -> None:
        """Called before the panel closes."""

    def assign(self, prop: str, value: Any) -> None:
        """Gives the object a value, unless it has it."""
        if getattr(self._feature, prop) != value:
            setattr(self._feature, prop, value)
            self.changed()

    def _fill(self) -> None:
        for name, prop in self.LENGTHS.items():
            box = self._widget(name)
            box.setProperty("value", getattr(self._feature, prop))
            FreeCADGui.ExpressionBinding(box).bind(self._feature, prop)
        for name, prop in self.CHOICES.items():
            self._widget(name).addItems(self._feature.getEnumerationsOfProperty(prop))
            self._widget(name).setCurrentText(getattr(self._feature, prop))
        for name, prop in self.TICKS.items():
            self._widget(name).setChecked(getattr(self._feature, prop))
        for name, prop in self.NUMBERS.items():
            self._widget(name).setValue(getattr(self._feature, prop))

    def _connect(self) -> None:
        for name, prop in self.LENGTHS.items():
            self._widget(name).valueChanged.connect(lambda *_, n=name, p=prop: self._length_changed(n, p))
        for name, prop in self.CHOICES.items():
            self._widget(name).currentTextChanged.connect(lambda text, p=prop: self.assign(p, text))
        for name, prop in self.TICKS.items():
            self._widget(name).toggled.connect(lambda on, p=prop: self.assign(p, on))
        for name, prop in self.NUMBERS.items():
            self._widget(name).valueChanged.connect(lambda number, p=prop: self.assign(p, number))
        if hasattr(self.form, "preview"):
            self.form.preview.clicked.connect(lambda *_: self.compute())

    def _widget(self, name: str) -> Any:
        return getattr(self.form, name)

    def _length_changed(self, name: str, prop: str) -> None:
        """The value [mm], or the expression that the f(x) button gave."""
        expression = dict(self._feature.ExpressionEngine).get(prop)
        self._feature.setExpression(prop, expression)
        setattr(self._feature, prop, self._widget(name).property("rawValue"))
        self.changed()

    def _close(self) -> None:
        self.closing()
        FreeCADGui.Control.closeDialog()

    def _end_editing(self) -> None:
        """Only after the transaction has ended: FreeCAD commits an open one here."""
        gui_document = FreeCADGui.getDocument(self._doc.Name)
        if gui_document.getInEdit() is not None:
            gui_document.resetEdit()


class FacePanel(FeaturePanel):
    """A panel with a list of picked faces."""

    #: Whether more than one face can be picked.
    MANY = True

    def __init__(self, feature: Any):
        self._picker = FacePicker([feature], self._picked)
        super().__init__(feature)
        self.form.pick.toggled.connect(self._toggle_picking)
        if self.MANY:
            self.form.remove.clicked.connect(self._remove)
        self.show_faces()

    def start(self) -> None:
        """The panel is visible: ask for a face when there is none."""
        FreeCADGui.Selection.clearSelection()  # its colour would hide the base and the preview
        if self.has_base():
            if self._feature.Status:
                self.show_result()
            else:
                self.changed()
        else:
            self.form.pick.setChecked(True)

    def links(self) -> List[Link]:
        """The faces that are picked now."""
        return links_of(self._feature.Base)

    def set_links(self, links: List[Link]) -> None:
        """Links these faces and no others."""
        raise NotImplementedError

    def has_base(self) -> bool:
        """Whether any face is picked."""
        return any(subs for _, subs in self.links())

    def missing(self) -> str:
        """A face, when there is none."""
        if self.has_base():
            return ""
        return translate("LaminateOffset", "Pick a face first: press Pick and click a face in the 3-D view.")

    def show_faces(self) -> None:
        """Fills the list."""
        self.form.faces.clear()
        self.form.faces.addItems([describe(base, sub) for base, sub in self._flat()])

    def closing(self) -> None:
        """Called before the panel closes."""
        self._picker.stop()

    def faces_changed(self) -> None:
        """Other faces are picked than before."""
        self.show_faces()
        self.changed()

    def _flat(self) -> List[Tuple[Any, str]]:
        return [(base, sub) for base, subs in self.links() for sub in subs]

    def _toggle_picking(self, picking: bool) -> None:
        if picking:
            self._picker.start()
            self.tell(translate("LaminateOffset", "Click a face in the 3-D view."))
        else:
            self._picker.stop()

    def _picked(self, base: Any, sub: str) -> None:
        """A picked face replaces the others; with Ctrl it joins them."""
        keys = QtGui.QApplication.keyboardModifiers()
        adds = self.MANY and bool(keys & QtCore.Qt.ControlModifier)
        old = self.links() if adds else []
        self.set_links([*old, (base, [sub])])
        self.faces_changed()

    def _remove(self) -> None:
        rows = {index.row() for index in self.form.faces.selectedIndexes()}
        kept = [(base, [sub]) for row, (base, sub) in enumerate(self._flat()) if row not in rows]
        self.set_links(kept)
        self.faces_changed()


class QuickFacePanel(FacePanel):
    """A panel with a list of picked faces whose figures take a moment only: they are made wherever there is a face."""

    def start(self) -> None:
        """The figures are shown at once where there is a face."""
        super().start()
        if self.has_base():
            self.compute()

    def set_links(self, links: List[Link]) -> None:
        """Links these faces and no others."""
        self._feature.Base = rooted_links(links)

    def faces_changed(self) -> None:
        """Other faces are picked than before."""
        self.show_faces()
        if self.has_base():
            self.compute()


def show(panel: FeaturePanel) -> None:
    """Shows a panel whose transaction is open."""
    FreeCADGui.Control.showDialog(panel)
    _widen(panel.form, panel.WIDTH)
    panel.start()


def _widen(form_widget: Any, width: int) -> None:
    """Makes the dock that holds the panel wide enough; a wider one stays as the user has it."""
    window, dock = FreeCADGui.getMainWindow(), form_widget
    while dock is not None and not isinstance(dock, QtGui.QDockWidget):
        dock = dock.parentWidget()
    if dock is not None and dock.width() < width:
        window.resizeDocks([dock], [width], QtCore.Qt.Horizontal)


def edit(kind: Any, feature: Any) -> None:
    """Shows a panel on an existing object, in a transaction of its own."""
    feature.Document.openTransaction(translate("LaminateOffset", "Edit {name}").format(name=feature.Label))
    show(kind(feature))
