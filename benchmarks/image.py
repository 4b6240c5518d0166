"""The main job, process start to PNG on disk: the preset paper, 512 x 512, 16 samples a pixel.

    ./just bench
    python benchmarks/image.py --peers    # and Mitsuba's pearl, and docs/benchmarks.md

Prints whole-process wall time, processor time and peak memory over several runs, of the main job,
of every preset scene, of shapes, of 24 to 400 pearls in one, of 4096 x 4096 pixels, the import of
the package
(which loads no room until asked) and of its last room (which brings NumPy and pydantic), and where
the time goes in the rooms; the main job by stages is in `main_job.py`. The budget of the main job
is 1.5 s on two cores, of the import 0.3 s, of memory 200 MB. `--peers` compares with Mitsuba 3, see
`reflection.py`. Nothing here is a test: machines differ.
"""

from __future__ import annotations

import os
import platform
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

RUNS = 9


def processor() -> str:
    """What /proc says of the machine, or Python's word for it."""
    lines = Path("/proc/cpuinfo").read_text().splitlines() if Path("/proc/cpuinfo").exists() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return f"{names[0] if names else platform.machine()}, {os.cpu_count()} processors"


def bytecode_kept() -> dict[str, str]:
    """The environment of a process that keeps compiled Python; imports else take twice as long."""
    return {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}


def whole_process(arguments: list[str]) -> tuple[float, float, float]:
    """Wall seconds, processor seconds and peak memory in MB of one run."""
    begin = time.perf_counter()
    process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL, env=bytecode_kept())
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    wall_s = time.perf_counter() - begin
    if process.returncode:
        raise SystemExit(f"{arguments} ended with {process.returncode}")
    return wall_s, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def report(name: str, arguments: list[str]) -> None:
    """Run once to warm up, then RUNS times, and print the medians."""
    whole_process(arguments)
    runs = [whole_process(arguments) for _ in range(RUNS)]
    wall_s, cpu_s, memory_mb = (statistics.median(column) for column in zip(*runs, strict=True))
    least_s = min(run[0] for run in runs)
    print(
        f"{name:24} wall {wall_s:.3f} s (least {least_s:.3f}), processors {cpu_s:.3f} s, "
        f"peak memory {memory_mb:.0f} MB"
    )


def timed(name: str, work: Callable[[], Any]) -> Any:
    """Do the work and print how long it took."""
    begin = time.perf_counter()
    result = work()
    print(f"  {name:22} {(time.perf_counter() - begin) * 1e3:7.1f} ms")
    return result


def break_down(folder: str) -> None:
    """The rooms of the main job, in the order of the data."""
    print("inside one process:")
    import nacreous as nc

    pearl, scene = nc.Pearl.load("paper"), nc.Scene.load("paper")
    timed("grow the layers", lambda: nc.nacre.stack_of(pearl))
    timed("draw the grain", lambda: nc.texture.texture_of(pearl))
    timed("rings and one pixel", lambda: nc.render(pearl, scene, size=1, samples=1))
    image = timed("whole render", lambda: nc.render(pearl, scene))
    timed("develop", image.develop)
    timed("develop, write PNG", lambda: image.save(Path(folder, "pearl.png")))
    timed("write EXR", lambda: image.save(Path(folder, "pearl.exr")))


#: Twelve masters above, twelve goods below, as on a sorter's tray.
TRAY = """
name = "tray"
[camera]
elevation_deg = 55.0
distance_mm = 400.0
[[rows]]
pearls = [{first}]
[[rows]]
pearls = [{second}]
[[rows]]
pearls = ["*", "*", "*", "*", "*", "*"]
[[rows]]
pearls = ["*", "*", "*", "*", "*", "*"]
[[windows]]
azimuth_deg = -40.0
elevation_deg = 45.0
spectrum = "6500K"
luminance = 6.0
[table]
kind = "cloth"
"""


def report_scenes(render: list[str], folder: str) -> None:
    """Every preset scene in 1024 x 1024, then 24 different pearls in one; budgets 2 s and 6 s."""
    from nacreous.spec import preset

    output = ["--size", "1024", "-o", str(Path(folder, "scene.png"))]
    for scene in preset.names("scene"):
        report(scene, [*render, "akoya-rg-1.0", "--scene", scene, *output])
    steps = ("1.0", "0.7", "0.4", "0.0")
    masters = [f'"akoya-{family}-{step}"' for family in ("r", "rg", "g") for step in steps]
    first, second = (", ".join(masters[part : part + 6]) for part in (0, 6))
    tray = Path(folder, "tray.toml")
    tray.write_text(TRAY.format(first=first, second=second))
    goods = []
    for seed in range(12):
        goods.append(str(Path(folder, f"good-{seed}.toml")))
        Path(goods[-1]).write_text(f'[nacre]\npreset = "akoya-rg-0.7"\nseed = {seed}\n')
    report("24 pearls", [*render, *goods, "--scene", str(tray), *output])


#: Pearls in a square of rows, from above.
FIELD = """
name = "field"
[camera]
elevation_deg = 45.0
distance_mm = 800.0
{rows}
[[windows]]
azimuth_deg = -40.0
elevation_deg = 45.0
spectrum = "6500K"
luminance = 6.0
[table]
kind = "cloth"
"""


#: A pearl with each thing that makes one dearer to render.
EVERYTHING = {
    "body.nucleus_bands": 0.3,
    "coat.thickness_spread": 0.03,
    "coat.banding": 0.5,
    "coat.hammering_rad": 0.03,
    "coat.terrace_um": 100,
    "blemishes.pits": 5,
    "blemishes.bumps": 5,
    "blemishes.scratches": 3,
    "blemishes.wrinkles": 3,
    "blemishes.chalky_spots": 3,
}
SHAPES = {
    "round": {},
    "oval": {"shape.length": 1.3},
    "baroque": {"shape.lumps": 0.06, "shape.lump_mm": 5},
    "small lumps": {"shape.lumps": 0.06, "shape.lump_mm": 2},
}


def report_shapes(render: list[str], folder: str) -> None:
    """Shapes, plain and with everything on, in 1024 x 1024; wanted: 2.5 s."""
    output = ["--size", "1024", "-o", str(Path(folder, "shape.png"))]
    for word, more in {"plain": {}, "everything on": EVERYTHING}.items():
        for shape, keys in SHAPES.items():
            sets = [f"--set={key}={value}" for key, value in {**keys, **more}.items()]
            arguments = [*render, "akoya-rg", *sets, "--scene", "north-window-white", *output]
            report(f"{shape}, {word}", arguments)


STAR = '"*"'


def report_fields(render: list[str], folder: str) -> None:
    """25, 100 and 400 pearls in 512 x 512; wanted: 8 s, and a time linear in their number."""
    output = ["--size", "512", "-o", str(Path(folder, "field.png"))]
    pearls = ("akoya-rg", "akoya-r-1.0", "akoya-g-0.0")
    for side in (5, 10, 20):
        row = f"[[rows]]\npearls = [{', '.join([STAR] * side)}]"
        field = Path(folder, f"field-{side}.toml")
        field.write_text(FIELD.format(rows="\n".join([row] * side)))
        report(f"{side * side} pearls", [*render, *pearls, "--scene", str(field), *output])


def report_large(render: list[str], folder: str) -> None:
    """One pearl in 4096 x 4096; wanted: 15 s of processor time."""
    output = ["--size", "4096", "-o", str(Path(folder, "large.png"))]
    report("4096 x 4096", [*render, "akoya-rg", "--scene", "north-window-white", *output])


def main() -> None:
    """Print everything."""
    print(f"{processor()}; {platform.platform()}; Python {platform.python_version()}; {RUNS} runs")
    nacreous = [sys.executable, "-m", "nacreous"]
    with tempfile.TemporaryDirectory() as folder:
        output = str(Path(folder, "pearl.png"))
        report("main job, 512 x 512", [*nacreous, "render", "paper", "-o", output])
        larger = ["--size", "1024", "-o", output]
        report("the same, 1024 x 1024", [*nacreous, "render", "paper", *larger])
        report_scenes([*nacreous, "render"], folder)
        report_shapes([*nacreous, "render"], folder)
        report_fields([*nacreous, "render"], folder)
        report_large([*nacreous, "render"], folder)
        report("import nacreous", [sys.executable, "-c", "import nacreous"])
        report("import nacreous.image", [sys.executable, "-c", "import nacreous.image"])
        report("Python alone", [sys.executable, "-c", "pass"])
        break_down(folder)
    if "--peers" in sys.argv:
        import reflection  # which imports this file

        reflection.compare()


if __name__ == "__main__":
    main()
