"""A pearl's reflection of a panorama: processor time to a given noise, ours and Mitsuba 3's.

    python benchmarks/image.py --peers

One picture of 512 x 512: GGX facets over a film of nacre mirror a panorama in high range
(`panorama.py`). Noise is CIEDE2000 against Mitsuba's picture with 4096 samples, 95th percentile
over the pearl; each program gets the fewest samples with which it is under 0.5. Ours is chosen
under the same panorama in grey, where the two programs compute the same and nothing but sampling
and our net of knots can part them. Mitsuba (`mitsuba_pearl.py`) is given our table of the film's
reflectance, and only reflects; ours computes the table and the light from within, too. Nothing
here is a test: machines differ.
"""

from __future__ import annotations

import json
import platform
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
import panorama
from image import whole_process
from numpy.typing import NDArray
from optics import processor

import nacreous as nc
from nacreous.nacre import columns_of

ROOT = Path(__file__).parent.parent
SIZE = 512
ALPHA = 0.1
DIAMETER_MM = 8.0
FILM_UM = 20.0
CAMERA = {"distance_mm": 150.0, "field_mm": 9.0, "elevation_deg": 12.0}
#: CIEDE2000 that 95 % of the pearl's pixels stay under.
NOISE = 0.5
#: A search for the number of samples ends this close below it.
NEAR = 0.9
REFERENCE_SAMPLES = 4096
#: Its own choice where a scene names none, and the one with which it is quickest here.
SAMPLERS = ("independent", "multijitter")
#: Square root of the most samples that are tried.
LARGEST_SIDE = 80
RUNS = 9

Picture = NDArray[np.float64]


# --- the picture


def pearl() -> nc.Pearl:
    """Grown nacre under a rough surface, without grain."""
    return nc.Pearl.load(
        "akoya-rg",
        overrides=[
            ("diameter_mm", str(DIAMETER_MM)),
            ("grain", "0"),
            ("film.outer_um", str(FILM_UM)),
            ("surface.facets", '"ggx"'),
            ("surface.facet_spread_rad", str(ALPHA)),
        ],
    )


def scene(folder: Path) -> nc.Scene:
    """Nothing but the panorama."""
    return nc.Scene.model_validate(
        {
            "name": "panorama",
            "camera": {"projection": "perspective", "white": "D65", **CAMERA},
            "table": {"kind": "none"},
            "sky": {
                "kind": "panorama",
                "path": str(folder / "panorama.exr"),
                "intensity": 1.0,
            },
        }
    )


def table() -> Picture:
    """Reflectance of the film as linear RGB [cosine, 3], cosines evenly from 0 to 1."""
    angle_rad = np.arccos(np.linspace(0, 1, 1025))
    columns = columns_of(pearl(), FILM_UM)
    xyz = [nc.iridescence.exact(column)[0].at(angle_rad) for column in columns]
    return nc.colour.rgb_from_xyz(np.mean(xyz, axis=0))


def apart(first: Picture, second: Picture, where: NDArray[np.bool_]) -> Picture:
    """CIEDE2000 between pictures, at each pixel of the pearl."""
    white = nc.colour.white_xyz("D65")
    lab = (nc.colour.lab_from_xyz(nc.colour.xyz_from_rgb(p[where]), white) for p in (first, second))
    return nc.colour.delta_e_2000(*lab)


def noise(picture: Picture, reference: Picture, where: NDArray[np.bool_]) -> float:
    return float(np.percentile(apart(picture, reference, where), 95))


# --- ours


def ours(folder: Path, samples: int) -> tuple[Picture, NDArray[np.bool_]]:
    """What the surface mirrors, and where the pearl fills the pixel."""
    image = nc.render(pearl(), scene(folder), SIZE, samples)
    where = image.layers["coverage"][..., 0] > 1 - 1e-6
    return image.layers["mirror"].astype(np.float64), where


def ours_s(folder: Path, samples: int) -> float:
    """Processor seconds of the whole picture in a process that has made one before."""
    models = pearl(), scene(folder)
    times = []
    for _ in range(RUNS + 1):
        begin_s = time.process_time()
        nc.render(*models, SIZE, samples)
        times.append(time.process_time() - begin_s)
    return float(np.median(times[1:]))


def ours_least(folder: Path, reference: Picture, where: NDArray[np.bool_]) -> dict[str, Any]:
    """The fewest samples that do (the last tried, if none), noise, processor seconds, memory.

    reference: Mitsuba's picture of the grey panorama in `folder`/grey.
    """
    for side in (1, 2, 3, 4, 6, 8):
        found = noise(ours(folder / "grey", side * side)[0], reference, where)
        if found < NOISE:
            break
    samples = side * side
    (folder / "pearl.toml").write_text(pearl().to_toml())
    (folder / "scene.toml").write_text(scene(folder).to_toml())
    command = [sys.executable, "-m", "nacreous", "render", str(folder / "pearl.toml")]
    options = ["--scene", str(folder / "scene.toml"), "--samples", str(samples)]
    _, whole_s, memory_mb = whole_process([*command, *options, "-o", str(folder / "ours.exr")])
    row = {"samples": samples, "noise": found, "whole_s": whole_s, "memory_mb": memory_mb}
    return {**row, "s": ours_s(folder, samples)}


# --- Mitsuba


class Mitsuba:
    """Mitsuba in an environment of its own, and the files that it is given."""

    def __init__(self, folder: Path) -> None:
        environment = folder / "environment"
        subprocess.run([sys.executable, "-m", "venv", environment], check=True)
        self.python = str(environment / "bin" / "python")
        install = [self.python, "-m", "pip", "install", "--quiet", "mitsuba", "numpy"]
        subprocess.run(install, check=True, stdout=subprocess.DEVNULL)
        self.version = ""
        self.under(folder)

    def under(self, folder: Path) -> None:
        """From now on, the panorama in this folder."""
        self.folder = folder
        np.save(folder / "table.npy", table())
        np.save(folder / "panorama.npy", nc.file.read_panorama(folder / "panorama.exr"))

    def render(self, sampler: str, samples: int, seed: int) -> tuple[Picture, dict[str, Any]]:
        """The picture; processor seconds `s` of it, `whole_s` of the process; its peak memory."""
        job = {"size": SIZE, "alpha": ALPHA, "diameter_mm": DIAMETER_MM, "sampler": sampler}
        (self.folder / "job.json").write_text(json.dumps({**job, **CAMERA}))
        script = str(ROOT / "benchmarks" / "mitsuba_pearl.py")
        used = whole_process([self.python, script, str(self.folder), str(samples), str(seed)])
        answer = json.loads((self.folder / "answer.json").read_text())
        self.version = answer["version"]
        picture = np.load(self.folder / "mitsuba.npy").astype(np.float64)
        return picture, {"s": answer["s"], "whole_s": used[1], "memory_mb": used[2]}

    def least(self, sampler: str, reference: Picture, where: NDArray[np.bool_]) -> dict[str, Any]:
        """The fewest samples that do, searched for from two tries on."""
        side, tried = 8, []
        while True:
            picture, took = self.render(sampler, side * side, seed=1)
            found = noise(picture, reference, where)
            print(f"  {sampler}, {side * side} samples: {found:.3f}, {took['s']:.1f} s", flush=True)
            tried.append((side, found))
            if NEAR * NOISE < found < NOISE or len(tried) == 7:
                break
            side = 16 if len(tried) == 1 else next_side(*tried[-2:])
        return {"samples": side * side, "noise": found, **took}


def next_side(before: tuple[int, float], last: tuple[int, float]) -> int:
    """Where the noise should be just low enough, on a straight line in logarithms."""
    (x0, y0), (x1, y1) = np.log(before), np.log(last)
    aim = np.log(0.5 * (1 + NEAR) * NOISE)
    side = round(float(np.exp(x1 + (aim - y1) * (x1 - x0) / (y1 - y0))))
    return min(max(side, 2), LARGEST_SIDE)


# --- the table


def section(version: str, rows: dict[str, dict[str, Any]], median: float, most: float) -> str:
    """The section of docs/benchmarks.md."""
    us = rows["ours"]
    lines = [
        f"| {name} | {row['samples']} | {row['noise']:.2f} | {row['s']:.2f} "
        f"| {row['s'] / us['s']:,.0f} | {row['whole_s']:.1f} | {row['memory_mb']:.0f} MB |"
        for name, row in rows.items()
    ]
    return "\n".join(
        [
            TITLE,
            "",
            f"A pearl that mirrors a panorama, {SIZE} x {SIZE}, GGX facets of alpha {ALPHA}: "
            "processor time of all cores together,",
            f"with the fewest samples whose noise is under CIEDE2000 {NOISE}: 95th percentile over "
            f"the pearl, against {REFERENCE_SAMPLES} samples",
            "of Mitsuba's; ours under the panorama in grey, where the two compute the same "
            f"(`python benchmarks/image.py --peers`; Mitsuba {version},",
            "llvm_ad_rgb, our film's table in a BSDF of its own; "
            f"{processor()}, Python {platform.python_version()}).",
            "Imports and compiling are in the whole process alone. Our time has the growth of the "
            "film, its table and the light",
            "from inside in it, Mitsuba's has the reflection alone.",
            "",
            "| | samples | noise | seconds | times ours | whole process, s | peak memory |",
            "|---|---|---|---|---|---|---|",
            *lines,
            "",
            f"In colour the reflections, ours with these samples and Mitsuba's with "
            f"{REFERENCE_SAMPLES}, are apart by",
            f"CIEDE2000 {median:.2f} at the median, {most:.2f} at the 95th percentile.",
            "",
        ]
    )


TITLE = "## Reflections"


def write(text: str) -> None:
    """Put the section in the place of the one of the same title, or before the exact optics."""
    document = ROOT / "docs" / "benchmarks.md"
    before, _, after = document.read_text(encoding="utf-8").partition(TITLE)
    if after:
        after = after[after.index("\n## ") + 1 :]
    else:
        before, title, rest = before.partition("## Exact optics")
        after = title + rest
    document.write_text(f"{before.rstrip()}\n\n{text}\n{after}", encoding="utf-8")


def compare() -> None:
    """Do it all, print it and write it down."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "grey").mkdir()
        panorama.write(folder / "panorama.exr")
        panorama.write(folder / "grey" / "panorama.exr", grey=True)
        peer = Mitsuba(folder)
        reference, _ = peer.render("multijitter", REFERENCE_SAMPLES, seed=7)
        peer.under(folder / "grey")
        grey, _ = peer.render("multijitter", REFERENCE_SAMPLES, seed=7)
        peer.under(folder)
        _, where = ours(folder, 1)
        rows = {"ours": ours_least(folder, grey, where)}
        print(rows, flush=True)
        picture, _ = ours(folder, rows["ours"]["samples"])
        median, most = np.percentile(apart(picture, reference, where), (50, 95))
        print(f"apart {median:.3f} at the median, {most:.3f} at the 95th percentile", flush=True)
        for sampler in SAMPLERS:
            rows[f"Mitsuba, {sampler}"] = peer.least(sampler, reference, where)
    text = section(peer.version, rows, median, most)
    print(text)
    write(text)
