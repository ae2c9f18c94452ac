# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all our objects have in common: how they tell the outcome of a recompute, and the version of their properties.

A refusal keeps the last good shape, marked as out of date: FreeCAD marks the object as invalid and shows the message.
"""

import json
from typing import Any, Callable, Dict, Mapping, Sequence

import FreeCAD as App

import laminate_offset as lo

from .. import messages
from .properties import HIDDEN, READ_ONLY, Property, add_missing
from .stateless import StatelessProxy

PROPERTIES = (
    Property("App::PropertyString", "Status", "Report", "ok, or the refusal's name", "", READ_ONLY),
    Property(
        "App::PropertyString", "Message", "Report", "What was made, or why not and what would work", "", READ_ONLY
    ),
    Property("App::PropertyStringList", "Warnings", "Report", "What is right but hardly wanted", [], READ_ONLY),
    Property(
        "App::PropertyBool",
        "OutOfDate",
        "Report",
        "The last recompute was refused: what is shown is the last good result",
        False,
        READ_ONLY,
    ),
    Property("App::PropertyVectorList", "RefusedAt", "Report", "The place of the refusal", [], READ_ONLY | HIDDEN),
    Property("App::PropertyVectorList", "FoldPoints", "Report", "Where the offset folds", [], READ_ONLY | HIDDEN),
    Property("App::PropertyIntegerList", "FoldCorners", "Report", "Three points a triangle", [], READ_ONLY | HIDDEN),
    Property("App::PropertyString", "ReportJson", "Report", "The report as JSON", "", READ_ONLY | HIDDEN),
    Property("App::PropertyInteger", "SchemaVersion", "Report", "Version of the properties", 0, READ_ONLY | HIDDEN),
)


class Feature(StatelessProxy):
    """Proxy of a document object. A kind states its properties and their version, and computes in compute()."""

    #: The kind's own properties.
    PROPERTIES: Sequence[Property] = ()
    #: Counts up with every change of the properties that needs upgrade().
    SCHEMA = 1
    #: Module and class of the view provider.
    VIEW_PROVIDER: Any = None

    def __init__(self, obj: Any):
        obj.Proxy = self
        self._prepare(obj)
        obj.SchemaVersion = self.SCHEMA

    def compute(self, obj: Any) -> None:
        """Computes results and report; raises on a refusal, before anything of the object is changed."""
        raise NotImplementedError

    def refused(self, obj: Any) -> None:
        """Takes back the figures that do not hold after a refusal."""

    def upgrade(self, obj: Any, version: int) -> None:
        """Turns what an older version of the properties held into today's; called once they are all there."""

    def execute(self, obj: Any) -> None:
        """Called by FreeCAD to recompute. RuntimeError carries the message of a refusal."""
        try:
            self.compute(obj)
        except Exception as error:  # also a defect must not leave the old result looking valid; it is raised again
            _refuse(obj, error)
            self.refused(obj)
            raise RuntimeError(obj.Message) from error
        obj.OutOfDate = False
        obj.RefusedAt = []
        _mark_fold(obj, None)

    def onDocumentRestored(self, obj: Any) -> None:
        """Adds what an older version, or a document saved without the GUI, does not have."""
        version = getattr(obj, "SchemaVersion", 0)
        self._prepare(obj)
        if version > self.SCHEMA:
            App.Console.PrintWarning(
                f"{obj.Label} was made by a newer version of LaminateOffset; update the add-on before you change it.\n"
            )
        elif version < self.SCHEMA:
            self.upgrade(obj, version)
            obj.SchemaVersion = self.SCHEMA
        if App.GuiUp:
            from ..gui.view_providers import restored

            restored(obj.ViewObject, self.VIEW_PROVIDER)

    @classmethod
    def attach_view_provider(cls, obj: Any) -> None:
        """Where the GUI is up, gives the object the view provider that it does not have yet."""
        if App.GuiUp:
            from ..gui.view_providers import attach_missing

            attach_missing(obj.ViewObject, cls.VIEW_PROVIDER)

    def _prepare(self, obj: Any) -> None:
        add_missing(obj, [*self.PROPERTIES, *PROPERTIES])
        if hasattr(obj, "Placement"):
            # The base decides where the result is; a placement of its own would break the distance.
            obj.setEditorMode("Placement", READ_ONLY)


def add_feature(doc: Any, kind: Callable[[Any], Feature], name: str, type_name: str = "Part::FeaturePython") -> Any:
    """Adds an object of a kind to the document. Works with and without the GUI."""
    obj = doc.addObject(type_name, name)
    kind(obj).attach_view_provider(obj)
    return obj


def accept(obj: Any, message: str, reports: Sequence[Mapping[str, Any]], warnings: Sequence[str] = ()) -> None:
    """Writes down a success; the warnings are the message's last lines."""
    obj.Status = "ok"
    obj.Message = "\n".join([message, *warnings])
    obj.Warnings = list(warnings)
    obj.ReportJson = json.dumps(list(reports))


def _refuse(obj: Any, error: Exception) -> None:
    obj.Status = status_of(error)
    obj.Message = messages.refusal(error, getattr(error, "face", ""))
    obj.Warnings = []
    obj.OutOfDate = has_result(obj)
    where = getattr(error, "where", None)
    _mark_fold(obj, getattr(error, "fold_region", None))
    obj.RefusedAt = [App.Vector(where["x"], where["y"], where["z"])] if where else []
    obj.ReportJson = json.dumps([_refusal_report(obj, error)])


def _mark_fold(obj: Any, region: Any) -> None:
    """Writes down where an offset folds, a features.fold_region.FoldRegion; None: nowhere, or not known."""
    points = [] if region is None else [App.Vector(*point) for point in region.points]
    if points or obj.FoldPoints:
        obj.FoldPoints = points
        obj.FoldCorners = [] if region is None else region.triangles.ravel().tolist()


def has_result(obj: Any) -> bool:
    """Whether there is a result to look at."""
    shape = getattr(obj, "Shape", None)
    return shape is not None and not shape.isNull()


def is_good(obj: Any) -> bool:
    """Whether the last recompute made a result. One that FreeCAD ends itself, for an expression without a value, leaves the
    status of the one before."""
    return obj.Status == "ok" and "Invalid" not in obj.State


def status_of(error: Exception) -> str:
    """The refusal's name; other errors are wrong layups, bad options or the kernel's."""
    if isinstance(error, lo.LayupError):
        return "invalid-layup"
    bad_argument = "invalid-option" if isinstance(error, ValueError) else "kernel-error"
    return str(getattr(error, "status", bad_argument))


def _refusal_report(obj: Any, error: Exception) -> Dict[str, Any]:
    if isinstance(error, lo.OffsetError):
        return dict(error.report.to_dict())
    return {"status": obj.Status, "stage": getattr(error, "stage", "options"), "message": obj.Message}
