# SPDX-License-Identifier: LGPL-2.1-or-later
"""Batches: a table of jobs, one offset or ply stack a row, carried out by several processes.

jobs.py reads the table, records.py says what is done already, work.py carries out one job, worker.py is the process that
does so, runner.py hands the jobs to the processes, summary.py writes the summary.
"""

from .jobs import Job, JobsError, read_jobs
from .runner import Outcome, run_batch

__all__ = ["Job", "JobsError", "Outcome", "read_jobs", "run_batch"]
