"""Exact optics of short stacks at few angles or few wavelengths: what a call costs, beside others.

    python benchmarks/short_stacks.py      # ours and the other packages, and docs/benchmarks.md

The job: natural light, and a bare film of aragonite or bilayers of aragonite and protein as in
`optics.py`. Each package sits in a process of its own, with one thread, and the processes take
turns, so that all have the same machine. Arrays are ready before the clock runs, and mean
reflectances must agree. Installs other packages into throw-away environments (one of them brings
PyTorch, some GB).
"""

from __future__ import annotations

import json
import math
import platform
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from optics import ROOT, in_another_process, job, processor
from peers import PEERS, Stack, Work, install

LAYERS = (1, 2, 4, 10, 20)
#: Angles and wavelengths.
TABLES = ((900, 1), (1, 900), (90, 1), (1, 1))
ROUNDS = 3
#: Seconds of one process for one table.
PATIENCE_S = 0.2

TITLE = "## Exact optics of short stacks"

Question = tuple[Stack, list[float], list[float]]


def question(layers: int, angles: int, wavelengths: int) -> Question:
    """One angle alone is 0.5, one wavelength alone 550 nm."""
    aragonite_nm, angle_rad, wavelength_nm = job(max(layers // 2, 1), angles, wavelengths)
    each = [nm for d in aragonite_nm for nm in (d, 20.0)][:layers]
    n = [1.0, *([1.53, 1.43] * len(each))[:layers], 1.53 if layers > 1 else 1.43]
    angle_rad = angle_rad if angles > 1 else [0.5]
    return (n, [math.inf, *each, math.inf]), angle_rad, wavelength_nm if wavelengths > 1 else [550]


def ours(stack: Stack, angle_rad: list[float], wavelength_nm: list[float]) -> Work:
    import numpy as np

    import nacreous as nc

    n, d = stack
    protein_nm = 20.0 if len(d) > 3 else 0.0
    nacre = nc.LayerStack(d[1:-1:2], protein_nm, 1.53, 1.43, n[0], n[-1])
    angle, nm = np.array(angle_rad), np.array(wavelength_nm, float)
    return lambda: float(nc.optics.energies(nacre, angle, nm).R.mean())


def floor(stack: Stack, angle_rad: list[float], wavelength_nm: list[float]) -> Work:
    """What no package can do without: a table is made and filled, and the mean of R is taken."""
    import numpy as np

    shape = (3, len(angle_rad), len(wavelength_nm))
    return lambda: float(np.full(shape, 0.5)[0].mean())


def timed(ready: Callable[[Stack, list[float], list[float]], Work]) -> dict[str, float]:
    """Least microseconds and mean reflectance of every table."""
    found: dict[str, float] = {}
    for layers in LAYERS:
        for table in TABLES:
            work = ready(*question(layers, *table))
            found[f"R {layers} {table}"] = work()
            least, end = math.inf, time.perf_counter() + PATIENCE_S
            while time.perf_counter() < end:
                begin = time.perf_counter()
                work()
                least = min(least, time.perf_counter() - begin)
            found[f"us {layers} {table}"] = 1e6 * least
    return found


def measured() -> dict[str, dict[str, float]]:
    """Of each package that installs, the least of some rounds."""
    best: dict[str, dict[str, float]] = {}
    with tempfile.TemporaryDirectory() as folder:
        pythons: dict[str, str | Path] = {"ours": sys.executable, "floor": sys.executable}
        for name in PEERS:
            if installed := install(name, f"{folder}/{name}"):
                pythons[name] = installed
        for _ in range(ROUNDS):
            for name, python in pythons.items():
                found = in_another_process(python, "--one", name, script=__file__)
                before = best.setdefault(name, found)
                best[name] = {key: min(before[key], found[key]) for key in found}
    return {name: found for name, found in best.items() if found}


def page(best: dict[str, dict[str, float]]) -> str:
    """The section of docs/benchmarks.md."""
    peers = [name for name in best if name in PEERS]
    rows = [row(best, peers, layers, *table) for layers in LAYERS for table in TABLES]
    return "\n".join(
        [
            TITLE,
            "",
            "Microseconds of one call from Python, natural light, one thread, the least of "
            f"{ROUNDS} rounds of {PATIENCE_S:g} s in which the packages",
            "took turns (`python benchmarks/short_stacks.py`;",
            f"{processor()}, Python {platform.python_version()}).",
            'Every call takes the mean of R too; "floor" is that mean and a table of R, T and A '
            "that NumPy makes and fills.",
            "",
            f"| layers | angles x wavelengths | floor | ours | {' | '.join(peers)} | times ours |",
            "|---|---|---|---|" + "---|" * len(peers) + "---|",
            *rows,
            "",
            "One value alone shows what a call costs at least: arguments are checked, and the "
            "result is made unchangeable.",
            "tmm_faster does neither, and is ahead there; a table of 90 values is not ten "
            "times ahead in stacks of under 10 layers.",
            "",
        ]
    )


def row(
    best: dict[str, dict[str, float]], peers: list[str], layers: int, angles: int, wavelengths: int
) -> str:
    """Microseconds of each, and how many times ours the fastest of the others takes."""
    table = f"{layers} {(angles, wavelengths)}"
    for name in peers:
        apart = abs(best[name][f"R {table}"] - best["ours"][f"R {table}"])
        if apart > 1e-6:
            print(f"{name}, {table}: mean R apart by {apart:.1e}", file=sys.stderr)
    us = {name: found[f"us {table}"] for name, found in best.items()}
    cells = [
        f"{layers} | {angles} x {wavelengths}",
        f"{us['floor']:.1f} | {us['ours']:.1f}",
        *(f"{us[name]:,.0f}" for name in peers),
        f"{min(us[name] for name in peers) / us['ours']:.1f}",
    ]
    return f"| {' | '.join(cells)} |"


def main() -> None:
    section = page(measured())
    print(section)
    document = ROOT / "docs" / "benchmarks.md"
    before, _, after = document.read_text(encoding="utf-8").partition(TITLE)
    rest = after.partition("\n## ")[1:]
    document.write_text(f"{before.rstrip()}\n\n{section}{''.join(rest)}", encoding="utf-8")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--one"]:
        kinds = {"ours": ours, "floor": floor, **PEERS}
        print(json.dumps(timed(kinds[sys.argv[2]])))
    else:
        main()
