"""The main job by stages, from the process's start to its end: `nacreous render paper`.

    python benchmarks/main_job.py

Each run is a process of its own, timed from outside and, between the stages, from inside. Prints
wall time and processor time of all cores: the median, and in brackets the least, which on a machine
that others use is nearer the truth. Compiled Python lies on the disk, as it does from a program's
second start on. Wanted: 0.45 s on two cores. Nothing here is a test: machines differ.
"""

from __future__ import annotations

import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from image import bytecode_kept, processor

RUNS = 21
STOPWATCH = Path(__file__).with_name("stopwatch.py")

STAGES = {
    "interpreter": "Python itself",
    "imports": "imports",
    "reading": "the recipe",
    "rendering": "rendering",
    "writing": "development, PNG",
    "rest": "command line, the line printed",
    "end": "end of the process",
}


def run_once(folder: str) -> dict[str, list[float]]:
    """Wall and processor seconds by stage, and of the whole, of one process."""
    output, record = str(Path(folder, "pearl.png")), str(Path(folder, "record.json"))
    begin_s = time.perf_counter()
    process = subprocess.Popen(
        [sys.executable, str(STOPWATCH), str(begin_s), output, record],
        stdout=subprocess.DEVNULL,
        env=bytecode_kept(),
    )
    _, status, used = os.wait4(process.pid, 0)
    whole_s = [time.perf_counter() - begin_s, used.ru_utime + used.ru_stime]
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode:
        raise SystemExit(f"the main job ended with {process.returncode}")
    spent_s, last_s = json.loads(Path(record).read_text())
    spent_s["end"] = [begin_s + whole_s[0] - last_s[0], whole_s[1] - last_s[1]]
    return {**spent_s, "whole": whole_s}


def report() -> None:
    """Print a row for each stage, and one for the whole."""
    with tempfile.TemporaryDirectory() as folder:
        run_once(folder)
        runs = [run_once(folder) for _ in range(RUNS)]
    print(
        f"{processor()}; {platform.platform()}; Python {platform.python_version()}; {RUNS} runs\n"
    )
    print("| `nacreous render paper`, in ms | wall | processors |\n|---|---|---|")
    for stage, meaning in {**STAGES, "whole": "all together"}.items():
        cells = []
        for kind in (0, 1):
            spent_ms = [1e3 * run[stage][kind] for run in runs]
            cells.append(f"{statistics.median(spent_ms):.0f} ({min(spent_ms):.0f})")
        print(f"| {meaning} | {cells[0]} | {cells[1]} |")


if __name__ == "__main__":
    report()
