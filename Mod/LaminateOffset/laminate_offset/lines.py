# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line's own lines on the standard streams, whatever those are connected to."""

import io
import os
import sys
from typing import TextIO, Tuple, cast


class Lines(io.TextIOBase):
    """Text to a file descriptor, at once. What its reader no longer wants is dropped: the files still count."""

    encoding = "utf-8"

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor

    def fileno(self) -> int:
        """The file descriptor."""
        return self._descriptor

    def isatty(self) -> bool:
        """Whether a person looks at it."""
        return os.isatty(self._descriptor)

    def writable(self) -> bool:
        """Yes, though in vain once the reader has gone."""
        return True

    def write(self, text: str) -> int:
        """Writes the text, or drops it when nobody reads it any more."""
        rest = text.encode(self.encoding, errors="backslashreplace")
        try:
            while rest:
                rest = rest[os.write(self._descriptor, rest) :]
        except BrokenPipeError:
            pass
        return len(text)


def take_over() -> Tuple[TextIO, TextIO]:
    """Streams to standard output and standard error for our own use.

    Whatever else is printed to standard output from now on is dropped: the geometry kernel and FreeCAD chatter there.
    """
    sys.stdout.flush()
    out = os.dup(1)
    with open(os.devnull, "wb") as nowhere:
        os.dup2(nowhere.fileno(), 1)
    return cast(TextIO, Lines(out)), cast(TextIO, Lines(2))
