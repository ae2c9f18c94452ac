# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of laminate-offset, one file each: `add_to` describes its arguments, `run` carries it out.

A command returns one of the exit codes below; what ends it early is raised: FileError and ValueError for bad usage,
KeyboardInterrupt for Ctrl-C.
"""

DONE, REFUSED, BAD_USAGE, CANCELLED = 0, 1, 2, 130
