# SPDX-License-Identifier: LGPL-2.1-or-later
"""The progress bar of the command line."""

from typing import Any, TextIO

from ..api import Progress
from ..each_face import FaceOutcome


class Bar:
    """A progress bar on a terminal, where tqdm is installed; otherwise nothing is drawn."""

    def __init__(self, total: int, stream: TextIO, name: str = "offset") -> None:
        self._bar: Any = None
        if stream.isatty():
            try:
                from tqdm import tqdm
            except ImportError:
                return
            form = "{l_bar}{bar}| {elapsed}<{remaining}"
            self._bar = tqdm(total=float(total), file=stream, leave=False, desc=name, bar_format=form)

    def __enter__(self) -> "Bar":
        return self

    def __exit__(self, *_exception: object) -> None:
        if self._bar is not None:
            self._bar.close()

    def progress_after(self, done: int) -> Progress:
        """The callback for the part that follows `done` finished ones."""

        def show(fraction: float) -> None:
            self.show(done + fraction)

        return show

    def show(self, done: float) -> None:
        """Draws how much of the total is done."""
        if self._bar is not None:
            self._bar.n = done
            self._bar.refresh()

    def write(self, line: str, stream: TextIO) -> None:
        """Prints a line without tearing the bar."""
        if self._bar is not None:
            self._bar.clear()
        print(line, file=stream, flush=True)

    def tell(self, outcome: FaceOutcome, out: TextIO, err: TextIO) -> None:
        """Prints one line on a face: the result's figures on `out`, or the reason of its refusal on `err`."""
        if outcome.shape is None:
            self.write(f"laminate-offset: {outcome.reason}", err)
        else:
            self.write(f"face {outcome.number}: {outcome.report.summary()}", out)
