# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text of the workbench is translated, and the translations are compiled into the add-on."""

import ast
import importlib
import os
import pathlib
import re
import xml.etree.ElementTree as ElementTree

import pytest

ADDON = pathlib.Path(os.environ["LAMINATE_OFFSET_BUILD_DIR"]) / "Mod" / "LaminateOffset"
PROJECT = pathlib.Path(os.environ["LAMINATE_OFFSET_PROJECT_DIR"])
LANGUAGES = ("de", "fr")


def texts_of_the_code():
    """(context, text) of every call that marks a text."""
    found = set()
    for path in (ADDON / "laminate_offset" / "gui").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") in ("translate", "QT_TRANSLATE_NOOP"):
                if all(isinstance(argument, ast.Constant) for argument in node.args):
                    found.add(tuple(argument.value for argument in node.args))
    return found


def texts_of_the_forms():
    """(context, text) of every text in the forms that is to be translated."""
    found = set()
    for path in (ADDON / "resources" / "ui").glob("*.ui"):
        root = ElementTree.parse(path).getroot()
        texts = [node.text for node in root.iter("string") if node.get("notr") != "true" and node.text]
        found |= {(root.find("class").text, text) for text in texts}
    return found


def translations(language):
    """(context, text): translation, from the file for Qt Linguist."""
    root = ElementTree.parse(PROJECT / "resources" / "translations" / f"LaminateOffset_{language}.ts").getroot()
    assert root.get("language") == language
    return {
        (context.find("name").text, message.find("source").text): message.find("translation")
        for context in root.iter("context")
        for message in context.iter("message")
    }


def qt_core():
    """Qt of FreeCAD's Python: 6, or 5. Skips without either."""
    try:
        return importlib.import_module("PySide6.QtCore")
    except ImportError:
        return pytest.importorskip("PySide2.QtCore")


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_text_is_translated(language):
    wanted = texts_of_the_code() | texts_of_the_forms()
    assert len(wanted) > 150
    found = translations(language)
    assert wanted == set(found), sorted(wanted ^ set(found))[:5]
    for (_, text), node in found.items():
        assert node.text and node.get("type") is None, f"{text!r} is not translated"
        assert sorted(re.findall(r"{\w+}", text)) == sorted(re.findall(r"{\w+}", node.text)), text
    assert sum(node.text != key[1] for key, node in found.items()) > 0.8 * len(found)


@pytest.mark.parametrize("language", LANGUAGES)
def test_translations_are_compiled(language):
    path = ADDON / "resources" / "translations" / f"LaminateOffset_{language}.qm"
    if not path.exists():
        pytest.skip("built without Qt's LinguistTools")
    translator = qt_core().QTranslator()
    assert translator.load(str(path))
    for (context, text), node in translations(language).items():
        assert translator.translate(context, text) == node.text
