# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds FreeCAD's own Python modules, so that the package also works in a plain python3."""

import glob
import importlib
import importlib.util
import os
import sys
from typing import List

_HINT = (
    "laminate_offset needs FreeCAD's Python modules FreeCAD and Part, and {problem}. Put the folder with FreeCAD.so on "
    "PYTHONPATH (on Debian: PYTHONPATH=/usr/lib/freecad-python3/lib) or name it in the environment variable "
    "FREECAD_LIB; without FreeCAD: apt-get install freecad-python3."
)


def candidate_folders() -> List[str]:
    """Folders that may hold FreeCAD's modules, the user's own choice first."""
    chosen = os.environ.get("FREECAD_LIB")
    if chosen:
        return [chosen]
    usual = ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib", "/usr/local/lib/freecad/lib"]
    return usual + sorted(glob.glob("/usr/lib/*/freecad/lib")) + ["/usr/local/lib", "/opt/freecad/lib"]


def ensure_freecad() -> None:
    """Makes `import FreeCAD, Part` work, or raises an ImportError that says what to do.

    Inside FreeCAD, and where PYTHONPATH leads to it, nothing is changed; otherwise FreeCAD's folder joins the end of
    sys.path.
    """
    if not _importable("FreeCAD"):
        folders = candidate_folders()
        found = [folder for folder in folders if glob.glob(os.path.join(folder, "FreeCAD.*"))]
        if not found:
            raise ImportError(_HINT.format(problem="none were found in " + ", ".join(folders)))
        sys.path.append(found[0])
    for module in ("FreeCAD", "Part"):
        try:
            importlib.import_module(module)
        except ImportError as error:
            raise ImportError(_HINT.format(problem=f"{module} could not be loaded ({error})")) from error


def add_workbench_folders() -> None:
    """Lets a document load the modules of its objects: FreeCAD itself does so at start, a plain python3 does not."""
    import FreeCAD

    roots = (FreeCAD.getResourceDir(), FreeCAD.getHomePath(), FreeCAD.getUserAppDataDir())
    for root in roots:
        for folder in [os.path.join(root, "Mod"), *sorted(glob.glob(os.path.join(root, "Mod", "*")))]:
            if os.path.isdir(folder) and folder not in sys.path:
                sys.path.append(folder)


def _importable(module: str) -> bool:
    return module in sys.modules or importlib.util.find_spec(module) is not None
