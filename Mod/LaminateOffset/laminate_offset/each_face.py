# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several faces, each worked on by itself: one that is refused does not stop the others."""

from dataclasses import dataclass
from typing import Any, Callable, Iterator, List, Optional, Sequence, Tuple, Union

from .api import ExtensionResult, OffsetResult, Progress, offset_face
from .errors import OffsetError
from .replacing import FileError
from .report import ExtensionReport, OffsetReport

Numbered = Tuple[int, Any]
Result = Union[OffsetResult, ExtensionResult]


@dataclass(frozen=True)
class OffsetRequest:
    """The arguments of offset_face that are the same for every face."""

    distance: float
    tolerance: float = 1e-3
    method: str = "same-parameter"
    extension: float = 0.0
    max_degree: Optional[int] = None


@dataclass(frozen=True)
class FaceOutcome:
    """What became of one face.

    Attributes:
        number: the face's number in its file, from 1.
        shape: the new face, or shell; None when it was refused.
        report: the result's report, or the refusal's.
        reason: one line that says why it was refused; "" when it was not.
    """

    number: int
    shape: Any
    report: Union[OffsetReport, ExtensionReport]
    reason: str


def choose(faces: Sequence[Any], number: Optional[int], source: str) -> List[Numbered]:
    """The numbered faces that are meant; None: all. Raises FileError where the file has no face of that number."""
    numbered = list(enumerate(faces, start=1))
    if number is None:
        return numbered
    if number > len(faces):
        raise FileError(f"{source}: there is no face {number}; it has {len(faces)}.")
    return [numbered[number - 1]]


def offset_each(
    chosen: Sequence[Numbered], request: OffsetRequest, show: Callable[[float], Optional[bool]]
) -> Iterator[FaceOutcome]:
    """Offsets face by face. show is told how many are done, with the fraction of the one at work."""
    for done, (number, face) in enumerate(chosen):
        yield outcome(number, lambda: _offset(face, request, lambda fraction: show(done + fraction)))


def outcome(number: int, work: Callable[[], Result]) -> FaceOutcome:
    """What becomes of one face when `work` is done on it."""
    try:
        result = work()
    except OffsetError as refusal:
        return _refused(number, refusal)
    except (RuntimeError, MemoryError) as error:
        return _refused(number, kernel_error(error))
    return FaceOutcome(number, result.face, result.report, "")


def kernel_error(error: BaseException) -> OffsetError:
    """The refusal that stands for an error of the geometry kernel."""
    return OffsetError("kernel-error", "input", f"The face could not be processed: {error}")


def refusal_line(number: Optional[int], refusal: OffsetError) -> str:
    """One line that says why a face was refused."""
    return f"face {number} refused at {refusal.stage}: {refusal}"


def _refused(number: int, refusal: OffsetError) -> FaceOutcome:
    return FaceOutcome(number, None, refusal.report, refusal_line(number, refusal))


def _offset(face: Any, request: OffsetRequest, progress: Progress) -> OffsetResult:
    return offset_face(
        face,
        request.distance,
        request.tolerance,
        request.method,
        request.extension,
        request.max_degree,
        progress,
    )
