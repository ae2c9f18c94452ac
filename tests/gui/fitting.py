# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a task panel can be read in its window: nothing is cut off, and what warns is in sight."""

from typing import Any

from PySide import QtGui
from session import result_is_orange, result_is_red, screenshot, widget


#: Parts of panels that show a line of text.
_WITH_TEXT = (QtGui.QLabel, QtGui.QAbstractButton, QtGui.QComboBox, QtGui.QAbstractSpinBox, QtGui.QLineEdit)


def fits(picture: str) -> None:
    """Takes a picture and asserts that every visible part of the panel has the room that it needs, within the panel's width;
    what does not fit into its height can be scrolled to, and a refusal or a warning is in sight."""
    screenshot(picture)
    form = widget("result", QtGui.QLabel).parentWidget()
    area = scroll_area(form)
    right = area.viewport().mapToGlobal(area.viewport().rect().topRight()).x()
    hidden = area.widget().height() - area.viewport().height()
    assert hidden <= area.verticalScrollBar().maximum(), f"{hidden} pixels of the panel are out of reach"
    assert area.horizontalScrollBar().value() == 0, "the panel is scrolled sideways"
    for child in form.findChildren(QtGui.QWidget):
        if child.isVisible() and not isinstance(child.parentWidget(), (QtGui.QAbstractScrollArea, QtGui.QHeaderView)):
            assert child.mapToGlobal(child.rect().topRight()).x() <= right, f"{child.objectName()} is cut off"
            assert child.height() >= least_height(child), f"{child.objectName()} is {child.height()} pixels high"
            if isinstance(child, QtGui.QLabel) and not child.wordWrap():
                assert child.width() >= child.sizeHint().width(), f"{child.text()!r} is cut off"
            if isinstance(child, QtGui.QTreeWidget):
                columns_fit(child)
    if result_is_red() or result_is_orange():
        assert_result_in_sight()


def scroll_area(form: Any) -> Any:
    """What scrolls a task panel."""
    area = form
    while not isinstance(area, QtGui.QScrollArea):
        area = area.parentWidget()
    return area


def least_height(child: Any) -> int:
    """That a part of a panel needs; a label with several lines, at its width; a list, for one row."""
    if isinstance(child, QtGui.QAbstractItemView):
        return int(max(child.sizeHintForRow(0), 0) + 2 * child.frameWidth())
    if isinstance(child, QtGui.QLabel) and child.wordWrap():
        return int(child.heightForWidth(child.width()))
    # That of its letters: what a theme asks for around them may be more than layouts give.
    letters = isinstance(child, _WITH_TEXT) and not (isinstance(child, QtGui.QLabel) and not child.text())
    return int(child.fontMetrics().height()) if letters else 0


def columns_fit(tree: Any) -> None:
    """All columns are within the table, with their titles and the texts of every row."""
    last = tree.columnCount() - 1
    end = tree.header().sectionViewportPosition(last) + tree.header().sectionSizeHint(last)
    assert end <= tree.viewport().width(), f"columns are cut off: {end} > {tree.viewport().width()} pixels"
    for column in range(tree.columnCount()):
        needed = max(tree.header().sectionSizeHint(column), tree.sizeHintForColumn(column))
        title = tree.headerItem().text(column)
        assert tree.columnWidth(column) >= needed, f"column {title}: {tree.columnWidth(column)} < {needed} pixels"


def assert_result_in_sight() -> None:
    """The whole of the panel's last line is seen, or as much as the panel has room for."""
    line = widget("result", QtGui.QLabel)
    seen, room = line.visibleRegion().boundingRect().height(), scroll_area(line).viewport().height()
    assert seen >= min(line.height(), room) - 2, f"{seen} of {line.height()} pixels are in sight: {line.text()!r}"
