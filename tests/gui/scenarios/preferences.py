# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of preferences: what is set there is what new objects start from. German and French texts."""

import os

import FreeCADGui as Gui
import laminate_offset
from laminate_offset.gui import preferences
from PySide import QtCore, QtGui
from session import QTest, offsets, press, pump, run_command, screenshot, select, start, widget

BUTTON = QtGui.QDialogButtonBox
TRANSLATIONS = os.path.join(os.path.dirname(os.path.dirname(laminate_offset.__file__)), "resources", "translations")


def run() -> None:
    """Called by scenario_runner.py."""
    doc = start(1280, 720)
    ball = doc.addObject("Part::Sphere", "Ball")
    doc.recompute()
    assert (preferences.tolerance(), preferences.max_degree(), preferences.thread_count()) == (1e-3, 7, 0)
    QtCore.QTimer.singleShot(1500, fill_page)
    Gui.runCommand("Std_DlgPreferences", 0)
    pump(300)
    assert (preferences.tolerance(), preferences.max_degree(), preferences.thread_count()) == (0.02, 5, 1)
    assert preferences.method() == "same-parameter" and preferences.drop_off_ratio() == 30
    select(ball, "Face1")
    run_command()
    press(BUTTON.Ok)
    (offset,) = offsets(doc)
    assert offset.Tolerance.Value == 0.02 and offset.MaxDegree == 5 and offset.Status == "ok"
    for language, word in (("German", "Abstand"), ("French", "Distance")):
        translated(ball, language, word)


def fill_page() -> None:
    """Finds our page in the dialog, types and presses OK."""
    dialog = QtGui.QApplication.activeModalWidget()
    if dialog is None:  # a busy machine
        QtCore.QTimer.singleShot(500, fill_page)
        return
    choose_page(dialog, "Laminate Offset")
    page = dialog.findChild(QtGui.QWidget, "PreferencesPage")
    for name, text in (("tolerance", "0.02"), ("maxDegree", "5"), ("threads", "1"), ("dropOff", "30")):
        line = page.findChild(QtGui.QWidget, name).findChild(QtGui.QLineEdit)
        line.setFocus()
        line.selectAll()
        QTest.keyClicks(line, text)
        QTest.keyClick(line, QtCore.Qt.Key_Tab)
    screenshot("page")
    QTest.mouseClick(dialog.findChild(QtGui.QDialogButtonBox).button(BUTTON.Ok), QtCore.Qt.LeftButton)


def choose_page(dialog, name: str) -> None:
    """Clicks a group of pages: in a list, or in a tree from FreeCAD 1.0 on."""
    tree = dialog.findChild(QtGui.QTreeView, "groupsTreeView")
    groups = dialog.findChild(QtGui.QListWidget) if tree is None else tree
    first = groups.model().index(0, 0)
    found = groups.model().match(first, QtCore.Qt.DisplayRole, name, -1, QtCore.Qt.MatchExactly)
    assert len(found) == 1 and not found[0].data(QtCore.Qt.DecorationRole).isNull(), found
    groups.setCurrentIndex(found[0])
    pump(300)


def translated(ball, language: str, word: str) -> None:
    """The panel in another language."""
    if not os.path.exists(os.path.join(TRANSLATIONS, "LaminateOffset_de.qm")):
        return  # built without Qt's LinguistTools
    Gui.setLocale(language)
    pump(500)
    select(ball, "Face1")
    run_command()
    assert widget("distanceTitle", QtGui.QLabel).text() == word
    screenshot(language.lower())
    press(BUTTON.Cancel)
    Gui.setLocale("English")
    pump(200)
