# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs one scenario inside FreeCAD's GUI, in a process and with settings of its own."""

import os
import pathlib
import re
import shutil
import subprocess
from typing import Sequence

HERE = pathlib.Path(__file__).resolve().parent
ADDON = pathlib.Path(os.environ["LAMINATE_OFFSET_BUILD_DIR"]) / "Mod" / "LaminateOffset"
OUT = pathlib.Path(os.environ["LAMINATE_OFFSET_BUILD_DIR"]) / "tests" / "gui" / "out"

#: A scenario takes about 10 s; a hang is FreeCAD waiting for someone to answer a dialog.
TIMEOUT_S = 240

_SETTINGS = """<?xml version="1.0" encoding="UTF-8" standalone="no" ?>
<FCParameters><FCParamGroup Name="Root"><FCParamGroup Name="BaseApp"><FCParamGroup Name="Preferences">
<FCParamGroup Name="General"><FCText Name="AutoloadModule">PartWorkbench</FCText><FCText Name="Language">English</FCText>
<FCBool Name="ConfirmAll" Value="0"/></FCParamGroup>
<FCParamGroup Name="MainWindow"><FCBool Name="StartupSplash" Value="0"/><!--theme--></FCParamGroup>
<FCParamGroup Name="Document"><FCBool Name="CreateNewDoc" Value="0"/><FCBool Name="AutoSaveEnabled" Value="0"/>
</FCParamGroup>
<FCParamGroup Name="View"><FCBool Name="ShowNaviCube" Value="0"/></FCParamGroup>
<FCParamGroup Name="Mod"><FCParamGroup Name="Start"><FCBool Name="DoNotShowOnOpen" Value="1"/></FCParamGroup></FCParamGroup>
</FCParamGroup></FCParamGroup></FCParamGroup></FCParameters>
"""


#: FreeCAD's dark style sheets, of 0.20 and of 1.0.
_DARK = ("Behave-dark.qss", "FreeCAD Dark.qss")


def run_scenario(name: str, install: str = "option", refusals: Sequence[str] = (), dark: bool = False) -> None:
    """Runs scenarios/<name>.py and asserts that it passed and that FreeCAD reported no error.

    install: "option" loads the add-on with -M, "user" from the user's Mod folder.
    dark: with FreeCAD's dark theme instead of its light one.
    refusals: parts of the errors that the scenario provokes; each must be reported, and nothing else.
    """
    out = OUT / f"{name}_{'dark' if dark else install}"
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    settings, log = out / "user.cfg", out / "freecad.log"
    sheet = f'<FCText Name="StyleSheet">{_dark_theme()}</FCText>' if dark else ""
    settings.write_text(_SETTINGS.replace("<!--theme-->", sheet), encoding="utf-8")
    done = subprocess.run(
        ["freecad", "-u", str(settings), "-s", str(out / "system.cfg"), "--log-file", str(log)]
        + _install(install, out)
        + [str(HERE / "scenario_runner.py")],
        env=_environment(name, out),
        cwd=out,
        capture_output=True,
        text=True,
        timeout=TIMEOUT_S,
        check=False,
    )
    verdict = out / "verdict.txt"
    told = verdict.read_text(encoding="utf-8") if verdict.exists() else "the scenario did not finish"
    assert done.returncode == 0 and told == "passed", f"{told}\n{done.stdout[-3000:]}\n{done.stderr[-3000:]}"
    _check_log(log.read_text(encoding="utf-8", errors="replace"), refusals)


def _dark_theme() -> str:
    import FreeCAD

    folder = pathlib.Path(FreeCAD.getResourceDir()) / "Gui" / "Stylesheets"
    return next(name for name in _DARK if (folder / name).exists())


def _install(how: str, out: pathlib.Path) -> Sequence[str]:
    if how == "option":
        return ["-M", str(ADDON)]
    mod = out / "home" / "Mod"  # where FreeCAD looks when FREECAD_USER_HOME names an existing folder
    mod.mkdir(parents=True)
    (mod / ADDON.name).symlink_to(ADDON)
    return []


def _environment(name: str, out: pathlib.Path) -> dict:
    home = out / "home"
    home.mkdir(exist_ok=True)
    environment = dict(os.environ)
    # The add-on must be found through FreeCAD's own ways, not through the path of the tests.
    environment.pop("PYTHONPATH", None)
    environment.update(
        HOME=str(home),
        FREECAD_USER_HOME=str(home),
        LIBGL_ALWAYS_SOFTWARE="1",
        # Each home is new: without a common place Matplotlib would search the fonts again for every scenario.
        MPLCONFIGDIR=str(OUT / "matplotlib"),
        QTWEBENGINE_DISABLE_SANDBOX="1",
        QTWEBENGINE_CHROMIUM_FLAGS="--no-sandbox",
        LAMINATE_OFFSET_GUI_SCENARIO=name,
        LAMINATE_OFFSET_GUI_OUT=str(out),
    )
    return environment


def _check_log(text: str, refusals: Sequence[str]) -> None:
    """Every error in FreeCAD's report view is one that was provoked, and every provoked one is there."""
    entries = re.split(r"\n(?=(?:Err|Wrn|Msg|Log): )", text)
    assert len(entries) > 10, "FreeCAD wrote no log"
    errors = [entry for entry in entries if entry.startswith("Err:")]
    for part in refusals:
        assert any(part in error for error in errors), f"{part!r} was not reported"
    # After a provoked error FreeCAD adds a line that names nothing.
    expected = list(refusals) + ["Recompute failed! Please check report view."] if refusals else []
    unexpected = [error for error in errors if not any(part in error for part in expected)]
    assert not unexpected, "FreeCAD reported:\n" + "\n".join(unexpected)
