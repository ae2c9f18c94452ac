# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that carries out jobs: one JSON object a line on its standard input, one record a line on its output.

It ends when its input ends. Ctrl-C (SIGINT) ends it early: what it was writing is removed.
"""

import json
import os
import queue
import signal
import sys
import threading

from .. import _core
from ..lines import take_over
from .work import carry_out

# What a worker runs; the package is found on PYTHONPATH. Until `main` is there, Ctrl-C ends it without a word.
COMMAND = (
    "import signal; signal.signal(signal.SIGINT, signal.SIG_DFL); "
    "signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT}); "
    "from laminate_offset.batch.worker import main; main()"
)
READY = "ready\n"


def main() -> None:
    """Works until there are no more jobs, with at most as many threads as the first argument says."""
    out, _ = take_over()
    _core.limit_threads(int(sys.argv[1]))
    orders: "queue.Queue[str]" = queue.Queue()
    threading.Thread(target=_listen, args=(orders,), daemon=True).start()
    try:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        out.write(READY)
        while True:
            order = json.loads(orders.get())
            record = carry_out(order["task"], order["paths"], order["digests"])
            print(json.dumps({name: record[name] for name in ("state", "reason", "figures")}), file=out)
    except KeyboardInterrupt:
        os._exit(130)  # nothing of ours is left to be closed, and a listening thread would keep the process


def _listen(orders: "queue.Queue[str]") -> None:
    """Passes on the jobs. The end of the input means that nobody waits for results: whoever sent the jobs is gone."""
    for line in sys.stdin:
        orders.put(line)
    os._exit(0)
