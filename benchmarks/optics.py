"""Exact optics: processor time of one evaluation (layer x wavelength x angle x polarisation).

    python benchmarks/optics.py            # ours
    python benchmarks/optics.py --peers    # and other packages, and docs/benchmarks.md

The job: N bilayers of aragonite, 450 +- 40 nm, and protein, 20 nm; 401 wavelengths, 90 angles, both
polarisations. `--peers` installs other packages into a throw-away environment (one of them brings
PyTorch, some GB) and runs each, on one thread like ours, on as much of the job as takes a few
seconds; their mean reflectance must be ours. Nothing here is a test: machines differ.
"""

from __future__ import annotations

import json
import math
import os
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

from peers import PEERS, Stack, install

ROOT = Path(__file__).parent.parent
ONE_THREAD = {f"{name}_NUM_THREADS": "1" for name in ("RAYON", "OMP", "OPENBLAS", "MKL", "NUMEXPR")}
RUNS = 9

#: Multiplications and additions of the lossless kernel, fused ones counted once, per evaluation:
#: 14 for the phase and its pair and 2 x 16 for the fields, in 2 layers x 2 polarisations.
OPERATIONS = 46 / 4

Job = tuple[list[float], list[float], list[float]]


def job(bilayers: int, angles: int = 90, wavelengths: int = 401) -> Job:
    """(thickness_nm, angle_rad, wavelength_nm), the same in every process; parts spread evenly."""
    state, thickness_nm = 1, []
    for _ in range(bilayers):
        total = 0.0
        for _ in range(12):  # a sum of twelve is nearly a bell curve of spread 1
            state = state * 6364136223846793005 + 1442695040888963407 & (1 << 64) - 1
            total += (state >> 11) / (1 << 53)
        thickness_nm.append(450 + 40 * (total - 6))
    angle_rad = [math.radians(i * 90 / angles) for i in range(angles)]
    step_nm = 400 / max(wavelengths - 1, 1)
    return thickness_nm, angle_rad, [380 + step_nm * i for i in range(wavelengths)]


def evaluations(part: Job) -> int:
    thickness_nm, angle_rad, wavelength_nm = part
    return 2 * len(thickness_nm) * len(angle_rad) * len(wavelength_nm) * 2


def least_s(work: Callable[[], object], runs: int = RUNS) -> float:
    """Processor seconds of the best of some runs."""
    times = []
    for _ in range(runs):
        begin = time.process_time()
        work()
        times.append(time.process_time() - begin)
    return min(times)


# --- ours


def ours() -> dict[str, float]:
    """Nanoseconds per evaluation, and what else one process can say; run with one thread."""
    import nacreous as nc

    found: dict[str, float] = {}
    for bilayers in (20, 100, 400):
        part = job(bilayers)
        for name, aragonite, protein, precision in (
            ("lossless", 1.53, 1.43, "double"),
            ("uniaxial", (1.683, 1.53), 1.43, "double"),
            ("absorbing", 1.53 + 1e-4j, 1.43 + 0.01j, "double"),
            ("dispersive, uniaxial", "aragonite", "chitin", "double"),
            ("lossless, single", 1.53, 1.43, "single"),
        ):
            stack = nc.LayerStack(part[0], 20.0, aragonite, protein)
            work = partial(nc.optics.energies, stack, *part[1:], precision=precision)
            found[f"{name}, {bilayers}"] = least_s(work) / evaluations(part) * 1e9
        stack = nc.LayerStack(part[0])
        work = partial(nc.optics.illuminant, stack, *part[1:])
        found[f"illuminant model, {bilayers}"] = least_s(work) / evaluations(part) * 1e9
    return found


def peak() -> float:
    """Multiply-adds per ns that one core can do."""
    command = ["cargo", "bench", "--quiet", "--package", "nacreous-optics", "--bench", "peak"]
    done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True)
    return float(done.stdout.split()[-1])


def memory_mb() -> float:
    """What the job with 400 bilayers takes above the interpreter with its libraries loaded."""
    import resource

    import nacreous as nc

    thickness_nm, angle_rad, wavelength_nm = job(400)
    stack = nc.LayerStack(thickness_nm)
    before_kb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    nc.optics.energies(stack, angle_rad, wavelength_nm)
    return (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before_kb) / 1024


def mean_reflectance(part: Job) -> float:
    import nacreous as nc

    return float(nc.optics.reflectance(nc.LayerStack(part[0]), part[1], part[2]).mean())


def wall_s() -> float:
    """Of the job with 400 bilayers, with the threads that the environment allows."""
    import nacreous as nc

    thickness_nm, angle_rad, wavelength_nm = job(400)
    stack = nc.LayerStack(thickness_nm)
    times = []
    for _ in range(4 * RUNS):
        begin = time.perf_counter()
        nc.optics.energies(stack, angle_rad, wavelength_nm)
        times.append(time.perf_counter() - begin)
    return min(times)


# --- peers


def layers(part: Job) -> Stack:
    """(indices, thicknesses) from the ambient to the substrate."""
    thickness_nm = [nm for d in part[0] for nm in (d, 20.0)]
    return [1.0, *[1.53, 1.43] * len(part[0]), 1.53], [math.inf, *thickness_nm, math.inf]


#: Angles and wavelengths that take a peer a few seconds with 400 bilayers.
PARTS = {
    "cuda-thinfilm": (10, 401),
    "tmm_faster": (10, 401),
    "tmm_fast": (4, 201),
    "PyMoosh": (2, 101),
    "tmm": (2, 11),
}


def peer(name: str) -> dict[str, float]:
    """Nanoseconds per evaluation with 400 bilayers, mean reflectance; in the peer's environment."""
    part = job(400, *PARTS[name])
    work = PEERS[name](layers(part), *part[1:])
    return {"mean": work(), "ns": least_s(work, 3) / evaluations(part) * 1e9}


def in_another_process(
    python: str | Path, *arguments: str, threads: str = "1", script: str = __file__
) -> dict[str, float]:
    environment = {**os.environ, **ONE_THREAD, "RAYON_NUM_THREADS": threads}
    done = subprocess.run(
        [python, script, *arguments], env=environment, stdout=subprocess.PIPE, text=True
    )
    if done.returncode:
        return {}
    found: dict[str, float] = json.loads(done.stdout.splitlines()[-1])
    return found


def compare(nanoseconds: float) -> list[str]:
    """A line of the table for each peer that installs and agrees."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name in PEERS:
            python = install(name, folder)
            found = in_another_process(python, "--peer", name) if python else {}
            if not found:
                rows.append(f"| {name} | did not run here | |")
                continue
            expected = mean_reflectance(job(400, *PARTS[name]))
            agrees = "" if abs(found["mean"] - expected) < 1e-6 else " (another answer)"
            ns = found["ns"]
            rows.append(f"| {name}{agrees} | {ns:,.1f} | {ns / nanoseconds:,.0f} |")
            print(rows[-1], flush=True)
    return rows


def page(found: dict[str, float], walls: dict[str, float], peers: list[str]) -> str:
    """The section of docs/benchmarks.md."""
    kinds = (
        "lossless",
        "uniaxial",
        "dispersive, uniaxial",
        "absorbing",
        "lossless, single",
        "illuminant model",
    )
    table = [
        f"| {kind} | " + " | ".join(f"{found[f'{kind}, {n}']:.2f}" for n in (20, 100, 400)) + " |"
        for kind in kinds
    ]
    share = OPERATIONS / found["lossless, 400"] / found["peak"]
    return "\n".join(
        [
            "## Exact optics",
            "",
            "Processor time in ns per layer x wavelength x angle x polarisation, one thread, "
            f"best of {RUNS};",
            "401 wavelengths, 90 angles, both polarisations, by number of bilayers "
            "(`python benchmarks/optics.py --peers`;",
            f"{processor()}, Python {platform.python_version()}):",
            "",
            "| layers | 20 | 100 | 400 |",
            "|---|---|---|---|",
            *table,
            "",
            f"The job of 400 bilayers takes {walls['1'] * 1e3:.1f} ms on one thread, "
            f"{walls['2'] * 1e3:.1f} ms on two: {walls['1'] / walls['2']:.2f} times as fast, and "
            f"{found['memory']:.1f} MB above the interpreter.",
            f"Its {OPERATIONS:.1f} multiply-adds per evaluation are {share:.0%} of what the core "
            f"can do ({found['peak']:.1f} per ns, `benchmarks/peak.rs`).",
            "",
            *(
                [
                    "Others on the same job of 400 bilayers (a part of it where they are slow), "
                    "one thread, best of 3:",
                    "",
                    "| package | ns | times ours |",
                    "|---|---|---|",
                    *peers,
                    "",
                ]
                if peers
                else []
            ),
        ]
    )


def processor() -> str:
    """What /proc says of the machine, or Python's word for it."""
    info = Path("/proc/cpuinfo")
    lines = info.read_text().splitlines() if info.exists() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    wide = any("avx512f" in line for line in lines if line.startswith("flags"))
    name = names[0] if names else platform.machine()
    return f"{name}{', AVX-512' if wide else ''}, {os.cpu_count()} processors"


def main() -> None:
    found = in_another_process(sys.executable, "--ours")
    found["memory"] = in_another_process(sys.executable, "--memory", threads="2")["mb"]
    found["peak"] = peak()
    walls = {n: in_another_process(sys.executable, "--wall", threads=n)["s"] for n in "12"}
    peers = compare(found["lossless, 400"]) if "--peers" in sys.argv else []
    section = page(found, walls, peers)
    print(section)
    if peers:
        document = ROOT / "docs" / "benchmarks.md"
        text = document.read_text(encoding="utf-8")
        before, _, after = text.partition("## Exact optics\n")
        after = after.partition("\n## ")[2]
        document.write_text(f"{before}{section}\n" + (f"## {after}" if after else ""))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--ours"]:
        print(json.dumps(ours()))
    elif sys.argv[1:2] == ["--memory"]:
        print(json.dumps({"mb": memory_mb()}))
    elif sys.argv[1:2] == ["--wall"]:
        print(json.dumps({"s": wall_s()}))
    elif sys.argv[1:2] == ["--peer"]:
        print(json.dumps(peer(sys.argv[2])))
    else:
        main()
