# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of plies in the layup panel: cells that are edited in place, rows that are dragged."""

import re
from dataclasses import replace
from typing import Any, Callable, Dict, Iterable, List, Sequence

from PySide import QtCore, QtGui

#: Columns of the table and of the document's entries.
COLUMNS = ("ply", "material", "thickness_mm", "angle_deg", "count", "boundary", "rosette", "active")
_FIELDS = ("name", "material", "thickness", "angle", "count", "boundary", "rosette", "active")
NAME, MATERIAL, THICKNESS, ANGLE, COUNT, BOUNDARY, ROSETTE, ACTIVE = range(8)

_WIDTHS = (50, 112, 46, 46, 44, 64, 58, 26)

#: Of a column for names, and what it has beside their letters.
_WIDEST, _MARGINS = 200, 12

ANGLES = (0, 45, -45, 90, 30, -30, 60, -60)

_WRONG = QtGui.QBrush(QtGui.QColor(224, 27, 36))
_ROW_FLAGS = (
    QtCore.Qt.ItemIsEnabled
    | QtCore.Qt.ItemIsSelectable
    | QtCore.Qt.ItemIsEditable
    | QtCore.Qt.ItemIsDragEnabled
    | QtCore.Qt.ItemIsUserCheckable
)
#: Fields of a ply that have no column; they stay with their row.
_KEPT = QtCore.Qt.UserRole


class PlyTable:
    """The rows of a layup in a QTreeWidget, as texts: what they mean is checked by the layup's own reader.

    library, rosettes: the names that are offered for materials and rosettes.
    """

    def __init__(self, tree: Any, library: List[str], rosettes: List[str], changed: Callable[[], None]):
        self._tree = tree
        self._library = library
        self._own: List[str] = []
        self._changed = changed
        self._warning = tree.style().standardIcon(QtGui.QStyle.SP_MessageBoxWarning)
        self._delegates = {
            MATERIAL: ChoiceDelegate(tree, self._materials),
            ANGLE: ChoiceDelegate(tree, lambda: [f"{a}" for a in ANGLES]),
            ROSETTE: ChoiceDelegate(tree, lambda: rosettes),
        }
        for column, delegate in self._delegates.items():
            tree.setItemDelegateForColumn(column, delegate)
        tree.setEditTriggers(
            QtGui.QAbstractItemView.DoubleClicked
            | QtGui.QAbstractItemView.EditKeyPressed
            | QtGui.QAbstractItemView.AnyKeyPressed
        )
        tree.invisibleRootItem().setFlags(tree.invisibleRootItem().flags() | QtCore.Qt.ItemIsDropEnabled)
        tree.itemChanged.connect(lambda *_: self._changed())
        tree.model().rowsInserted.connect(lambda *_: QtCore.QTimer.singleShot(0, self._changed))

    def show(self, plies: Iterable[Dict[str, Any]], own: List[str]) -> None:
        """Replaces the rows. own: the materials that are not in the library."""
        self._own = own
        self._tree.blockSignals(True)
        self._tree.clear()
        self._tree.addTopLevelItems([_item(ply) for ply in plies])
        self._tree.blockSignals(False)
        self._widen()

    def _widen(self) -> None:
        """Makes the columns wide enough for their titles, and for the names of materials that can be chosen."""
        letters = self._tree.fontMetrics()
        names = max(letters.boundingRect(name).width() for name in ["", *self._materials()])
        for column, width in enumerate(_WIDTHS):
            if column == MATERIAL:
                width = max(width, min(names + _MARGINS, _WIDEST))
            # Style sheets may give titles more room than their letters need.
            self._tree.setColumnWidth(column, max(width, self._tree.header().sectionSizeHint(column)))

    def rows(self) -> List[Dict[str, Any]]:
        """The plies as entries of a document, their values as texts."""
        return [_entry(item) for item in self._items()]

    def mark(self, problems: Sequence[Any]) -> None:
        """Makes the cells red that are wrong, with a sign and with what is expected as their tool tip."""
        self._tree.blockSignals(True)
        for item in self._items():
            for column in range(len(COLUMNS)):
                item.setData(column, QtCore.Qt.ForegroundRole, None)
                item.setData(column, QtCore.Qt.DecorationRole, None)
                item.setToolTip(column, "")
        items = self._items()
        for problem in problems:
            if problem.unit == "ply" and problem.row is not None and problem.row <= len(items):
                column = _column(problem.column)
                items[problem.row - 1].setForeground(column, _WRONG)
                # The colour of the selection hides that of the text.
                items[problem.row - 1].setIcon(column, self._warning)
                items[problem.row - 1].setToolTip(column, f"found {problem.found}, expected {problem.expected}")
        self._tree.blockSignals(False)
        self._tree.viewport().update()

    def titled(self, problems: Sequence[Any]) -> List[Any]:
        """The problems with the titles of their columns, as the table has them; what has no column here keeps its name."""
        header = self._tree.headerItem()
        return [
            replace(problem, column=header.text(_column(problem.column)))
            if problem.unit == "ply" and _has_column(problem.column)
            else problem
            for problem in problems
        ]

    def add(self) -> None:
        """Adds a ply of the same material after the selected one, and lets its angle be typed."""
        items, selected = self._items(), self._selected()
        place = self._tree.indexOfTopLevelItem(selected[-1]) + 1 if selected else len(items)
        like = items[place - 1] if items and place else None
        material = like.text(MATERIAL) if like else self._materials()[0]
        item = _item({"ply": self._free_name("P1"), "material": material, "angle_deg": 0.0})
        self._insert(place, [item])
        self._tree.setCurrentItem(item, ANGLE)

    def duplicate(self) -> None:
        """Copies the selected rows below the last of them."""
        selected = self._selected()
        if selected:
            place = self._tree.indexOfTopLevelItem(selected[-1]) + 1
            self._insert(place, self._copies(selected))

    def mirror(self) -> None:
        """Adds the mirror image of the selected rows, or of all, below them."""
        sources = self._selected() or self._items()
        if sources:
            place = self._tree.indexOfTopLevelItem(sources[-1]) + 1
            self._insert(place, self._copies(sources[::-1]))

    def delete(self) -> None:
        """Takes the selected rows out."""
        for item in self._selected():
            self._tree.takeTopLevelItem(self._tree.indexOfTopLevelItem(item))
        self._changed()

    def up(self) -> None:
        """Moves the selected rows towards the tool."""
        self._move(self._selected(), -1)

    def down(self) -> None:
        """Moves the selected rows away from the tool."""
        self._move(self._selected()[::-1], 1)

    def set_angle(self, angle: float) -> None:
        """Gives the selected rows an angle in degrees."""
        for item in self._selected():
            item.setText(ANGLE, f"{angle:g}")

    def _items(self) -> List[Any]:
        return [self._tree.topLevelItem(index) for index in range(self._tree.topLevelItemCount())]

    def _selected(self) -> List[Any]:
        return [item for item in self._items() if item.isSelected()]

    def _materials(self) -> List[str]:
        return [*self._own, *(name for name in self._library if name not in self._own)]

    def _insert(self, place: int, items: List[Any]) -> None:
        self._tree.insertTopLevelItems(place, items)
        self._tree.clearSelection()
        for item in items:
            item.setSelected(True)
        self._changed()

    def _copies(self, items: Iterable[Any]) -> List[Any]:
        copies: List[Any] = []
        for item in items:
            copy = item.clone()
            copy.setText(NAME, self._free_name(item.text(NAME), [other.text(NAME) for other in copies]))
            copies.append(copy)
        return copies

    def _free_name(self, like: str, taken: Sequence[str] = ()) -> str:
        """A name that no row has: that one, or with the next free number at its end."""
        used = {item.text(NAME) for item in self._items()} | set(taken)
        found = re.fullmatch(r"(.*?)(\d*)", like)
        stem, number = (found.group(1), int(found.group(2) or 1)) if found else (like, 1)
        name = like
        while name in used or not name:
            number += 1
            name = f"{stem}{number}"
        return name

    def _move(self, items: Iterable[Any], step: int) -> None:
        moved = list(items)
        for item in moved:
            place = self._tree.indexOfTopLevelItem(item)
            target = place + step
            if not 0 <= target < self._tree.topLevelItemCount() or self._tree.topLevelItem(target) in moved:
                continue
            self._tree.takeTopLevelItem(place)
            self._tree.insertTopLevelItem(target, item)
        for item in moved:
            item.setSelected(True)
        self._changed()


class ChoiceDelegate(QtGui.QStyledItemDelegate):
    """Edits a cell with a list of choices; other texts can be typed as well."""

    def __init__(self, parent: Any, choices: Callable[[], List[str]]):
        super().__init__(parent)
        self._choices = choices

    def createEditor(self, parent: Any, _option: Any, _index: Any) -> Any:
        """Called by Qt when editing begins."""
        box = QtGui.QComboBox(parent)
        box.setEditable(True)
        box.addItems(self._choices())
        return box

    def setEditorData(self, editor: Any, index: Any) -> None:
        """Called by Qt to show the cell's text."""
        editor.setEditText(index.data(QtCore.Qt.EditRole) or "")
        editor.lineEdit().selectAll()

    def setModelData(self, editor: Any, model: Any, index: Any) -> None:
        """Called by Qt when editing ends."""
        model.setData(index, editor.currentText(), QtCore.Qt.EditRole)


def _item(ply: Dict[str, Any]) -> Any:
    texts = [_text(ply.get(column)) for column in COLUMNS[:ACTIVE]]
    texts[ANGLE], texts[COUNT] = texts[ANGLE] or "0", texts[COUNT] or "1"
    item = QtGui.QTreeWidgetItem([*texts, ""])
    item.setFlags(_ROW_FLAGS)
    item.setCheckState(ACTIVE, QtCore.Qt.Checked if ply.get("active", True) else QtCore.Qt.Unchecked)
    item.setData(NAME, _KEPT, {key: value for key, value in ply.items() if key not in COLUMNS})
    return item


def _entry(item: Any) -> Dict[str, Any]:
    entry = {column: item.text(number) for number, column in enumerate(COLUMNS[:ACTIVE])}
    entry["active"] = item.checkState(ACTIVE) == QtCore.Qt.Checked
    return {**(item.data(NAME, _KEPT) or {}), **entry}


def _text(value: Any) -> str:
    return "" if value is None else f"{value:g}" if isinstance(value, float) else str(value)


def _has_column(name: str) -> bool:
    return name in COLUMNS or name in _FIELDS


def _column(name: str) -> int:
    """The column of a problem, which names a document's key or a ply's field; the first when it has none here."""
    names = COLUMNS if name in COLUMNS else _FIELDS
    return names.index(name) if name in names else NAME
