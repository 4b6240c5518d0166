"""Which growths the paper of 1996 allows, and how bluish the colours are that they give.

    python benchmarks/paper_growth.py                  # the shares of docs/model.md, minutes
    python benchmarks/paper_growth.py --finalists 24   # the criteria of `nacreous paper` too
    python benchmarks/paper_growth.py --finalists 8 --sheet sheet.png

Half of the candidates are drawn evenly over `RANGES`, half near the best so far. Each gets one row
of a table in target/; a run that was stopped goes on where it ended, and the same seed and count
give the same table. Figure 10 is measured: the interference component in white light, as the screen
shows it. A point of the disc is bluish where its Lab hue is 170 to 290 degrees and its chroma is 5
or more. Finalists are the best two of each 5 nm of winter thickness; figures 10 and 14 (a) of these
in the paper's scene are measured too, with what is bluish or violet (170 to 330 degrees) and green
(100 to 170); `--sheet` shows both figures, one above the other.
"""

from __future__ import annotations

import argparse
import csv
import datetime as dt
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from nacreous import _core, colour, optics
from nacreous.image import Image, render
from nacreous.nacre import diary, stack_of
from nacreous.paper import component, make, pictures
from nacreous.spec import Growth, Pearl

Array = NDArray[np.float64]
Row = tuple[float, ...]

BLUISH_DEG = (170.0, 290.0)
#: What is told of the presets and the finalists beside: to violet, and green.
VIOLET_DEG = (170.0, 330.0)
GREEN_DEG = (100.0, 170.0)
LEAST_CHROMA = 5.0
WHITE_XYZ = colour.xyz_from_rgb([1.0, 1.0, 1.0])
RINGS = 128
#: Each growth is measured as the mean of pearls with these seeds; the preset has the first.
SEEDS = (1, 2, 3)
#: How many of the best the second half of the candidates is drawn near to.
NEAREST = 24
SIZE_PX = 256


class Range(NamedTuple):
    """What a key of growth may be, in steps that a preset can be written in."""

    least: float
    most: float
    step: float
    source: str


RANGES = {
    "thickness_winter_nm": Range(400, 500, 1, "paper 3.2.1: 400 to 700 nm, late layers under 500"),
    "thickness_summer_nm": Range(400, 700, 1, "paper 3.2.1: 400 to 700 nm, in summer the most"),
    "layers_winter": Range(1, 3, 0.1, "paper 3.2.1: 1 to 3 a day"),
    "layers_summer": Range(1, 3, 0.1, "paper 3.2.1: 1 to 3 a day, in summer the most"),
    "season_days": Range(20, 90, 1, "(ours); paper 3.2.1: a normal density"),
    "thickness_noise_nm": Range(5, 40, 1, "(ours); paper 3.2.1: uniform random numbers, not none"),
    "layers_noise": Range(0, 1, 0.05, "(ours); paper 3.2.1: uniform random numbers"),
    "peak": Range(172, 265, 1, "paper 3.2.1: summer, 21 June to 22 September"),
    "harvest": Range(335, 365, 1, "paper 3.2.1: about December"),
}
COLUMNS = (*RANGES, "allowed", "bluish", "chroma", "arc_deg")
#: From this day on every layer is a late one, under 500 nm (paper 3.2.1, autumn to winter) (ours).
LATE, LATE_NM = dt.date(2001, 11, 1), 500.0
#: Late layers are even (paper 3.2.1): the standard deviation in the outer 10 um, which is reported
#: of pearls of strong teri as 10 to 20 nm (Pearl Science Laboratory).
EVEN_NM = 20.0


def growth(values: Array | Row, seed: int = 1) -> Growth:
    """The growth of one candidate; days of the year become dates."""
    keys = dict(zip(RANGES, map(float, values), strict=True))
    peak, harvest = (_date(keys.pop(key)) for key in ("peak", "harvest"))
    return Growth.model_validate(
        {"preset": "paper-green", "seed": seed, "peak": peak, "harvest": harvest, **keys}
    )


def _date(day: float) -> str:
    return f"{dt.date(2001, 1, 1) + dt.timedelta(days=day - 1):%m-%d}"


def allowed(grown: Growth) -> bool:
    """Whether summer has the thicker layers and the more, and late layers are thin and even."""
    days = diary(grown)
    late = np.array([date >= LATE for date in days.date])
    _, _, spread_nm = stack_of(pearl(grown)).outer(10)
    bells = (
        grown.thickness_summer_nm >= grown.thickness_winter_nm
        and grown.layers_summer >= grown.layers_winter
    )
    thin = late.any() and days.thickness_nm[late].max() < LATE_NM
    return bool(bells and thin and spread_nm <= EVEN_NM)


def pearl(grown: Growth) -> Pearl:
    """The paper's pearl without grain, of another growth."""
    return Pearl.load("paper", pictures.overrides("a")).replace(nacre=grown)


def rings(grown: Growth) -> Array:
    """Linear RGB of the interference component on rings of equal area, the middle first.

    As figure 10 shows it: white light, seen from afar, the strongest channel at 0.9.
    """
    shown = pearl(grown)
    how, at_rad = shown.interference, np.arcsin(np.sqrt((np.arange(RINGS) + 0.5) / RINGS))
    loss = _core.resolved_keys(shown.model_dump_json())["interference.diffuse_loss"]
    light = optics.illuminant(
        stack_of(shown), at_rad, colour.WAVELENGTH_NM, how.coherence_nm, how.threshold, loss
    )
    xyz = colour.xyz_from_spectrum(light, colour.illuminant("E"))
    rgb = colour.rgb_from_xyz(colour.adapt(xyz, colour.white_xyz("E"), WHITE_XYZ))
    return np.asarray(0.9 * rgb / np.quantile(rgb.max(axis=1), 0.995))


def share(lab: Array, between_deg: tuple[float, float] = BLUISH_DEG) -> float:
    """Of Lab colours [n, 3], how many have a hue within bounds."""
    hue, chroma = _hue_and_chroma(lab)
    least, most = between_deg
    return float(np.mean((hue >= least) & (hue <= most) & (chroma >= LEAST_CHROMA)))


def _hue_and_chroma(lab: Array) -> tuple[Array, Array]:
    _, a, b = lab.T
    return np.degrees(np.arctan2(b, a)) % 360, np.hypot(a, b)


def measured(grown: Growth) -> Row:
    """Of figure 10: share of the disc that is bluish, median chroma, arc of the hue circle met."""
    seen = colour.map_to_gamut(rings(grown), "soft")
    lab = colour.lab_from_xyz(colour.xyz_from_rgb(seen), WHITE_XYZ)
    hue, chroma = _hue_and_chroma(lab)
    met = np.sort(hue[chroma >= LEAST_CHROMA])
    arc = 360 - np.diff(met, append=met[0] + 360).max() if met.size else 0.0
    return share(lab), float(np.median(chroma)), float(arc)


def over_seeds(grown: Growth) -> Row:
    """What `measured` finds, as the mean over `SEEDS`."""
    each = [measured(grown.replace(seed=seed)) for seed in SEEDS]
    return tuple(float(mean) for mean in np.mean(each, axis=0))


def drawn(k: int, count: int, seed: int, rows: list[Row]) -> Array:
    """Candidate k of `count`: anywhere, then near the best of `rows`."""
    least, most, step = (np.array([span[i] for span in RANGES.values()]) for i in range(3))
    random = np.random.default_rng((seed, k))
    best = _best(rows)[:NEAREST]
    if 2 * k < count or not best:
        found = random.uniform(least, most)
    else:
        near = np.array(best[random.integers(len(best))][: len(RANGES)])
        moved = random.random(len(RANGES)) < 0.5
        found = near + moved * random.normal(0, 0.12, len(RANGES)) * (most - least)
    found = np.clip(found, least, most)
    for winter, summer in ((0, 1), (2, 3)):
        found[[winter, summer]] = np.sort(found[[winter, summer]])
    return np.asarray(np.round(np.round(found / step) * step, 4))


def _best(rows: list[Row]) -> list[Row]:
    """Those that are allowed, the most bluish first."""
    right = COLUMNS.index("allowed")
    return sorted((row for row in rows if row[right]), key=lambda row: -row[right + 1])


def scan(path: Path, count: int, seed: int) -> list[Row]:
    """All candidates, from the file as far as it goes."""
    rows = _read(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("a", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        if not rows:
            table.writerow(COLUMNS)
        for k in range(len(rows), count):
            values = drawn(k, count, seed, rows)
            grown = growth(values)
            right = allowed(grown)
            found = over_seeds(grown) if right else (0.0, 0.0, 0.0)
            rows.append((*values, float(right), *(round(number, 4) for number in found)))
            table.writerow([f"{number:g}" for number in rows[-1]])
            file.flush()
            if (k + 1) % 50 == 0:
                print(f"\r{k + 1} of {count}", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    return rows


def _read(path: Path) -> list[Row]:
    if not path.exists():
        return []
    with path.open(encoding="utf-8", newline="") as file:
        return [tuple(map(float, row)) for row in list(csv.reader(file))[1:]]


def finalists(rows: list[Row], count: int) -> list[Row]:
    """The best two of each 5 nm of winter thickness, the most bluish first."""
    taken: dict[int, list[Row]] = {}
    for row in _best(rows):
        taken.setdefault(int(row[0] // 5), []).append(row)
    return _best([row for found in taken.values() for row in found[:2]])[:count]


def shown(grown: Growth) -> tuple[Image, Image]:
    """Figure 10 and figure 14 (a) of a growth."""
    picture = render(pearl(grown), "paper", SIZE_PX, 16)
    return component.alone(picture, "interference")[0], picture


def criteria(grown: Growth) -> str:
    """How many criteria of `nacreous paper` hold, of how many, and which do not."""
    other = [(f"nacre.{key}", value) for key, value in grown.model_dump().items()]
    with tempfile.TemporaryDirectory() as folder:
        paper = make.make(Path(folder) / "paper", SIZE_PX, growth=other)
    asked = [(figure.number, one) for figure in paper.exhibits for one in figure.asked]
    missed = [f"{number}: {one.quantity} {one.shown}" for number, one in asked if not one.holds]
    return "; ".join([f"{len(asked) - len(missed)} of {len(asked)}", *missed])


def tell(name: str, grown: Growth, with_criteria: bool) -> tuple[Image, Image]:
    """Print one line of a growth; the pictures behind it."""
    pictured = shown(grown)
    disc = pictured[1].layers["coverage"][..., 0] >= 0.5
    told = []
    for number, picture in zip(("10", "14 (a)"), pictured, strict=True):
        lab = component.lab(picture)[disc]
        shares = (f"{100 * share(lab, hue):.0f}" for hue in (BLUISH_DEG, VIOLET_DEG, GREEN_DEG))
        told.append(f"figure {number}: {', '.join(shares)} %")
    line = f"{name:12}{100 * over_seeds(grown)[0]:4.0f} %; {'; '.join(told)}"
    print(f"{line}  {criteria(grown) if with_criteria else ''}".rstrip(), flush=True)
    return pictured


def sheet(path: str, pairs: list[tuple[Image, Image]]) -> None:
    """Figures 10 above figures 14 (a), side by side."""
    columns = [np.concatenate([one.linear for one in pair]) for pair in pairs]
    Image(np.concatenate(columns, axis=1), {}, {}).save(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--candidates", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--finalists", type=int, default=0, help="how many to try the criteria on")
    parser.add_argument("--sheet", help="a picture of the presets and the finalists")
    args = parser.parse_args()
    path = Path(f"target/paper-growth-{args.seed}-{args.candidates}.csv")
    rows = scan(path, args.candidates, args.seed)
    best = _best(rows)
    print(f"{path}: {len(best)} of {len(rows)} are allowed; share of figure 10 that is bluish:")
    print(
        f"median {100 * np.median([row[-3] for row in best]):.1f} %, most {100 * best[0][-3]:.1f} %"
    )
    before = Growth(preset="paper-green")
    print("winter thickness alone:", end="")
    for winter_nm in range(400, 500, 10):
        bluish = over_seeds(before.replace(thickness_winter_nm=float(winter_nm)))[0]
        print(f"  {winter_nm} nm {100 * bluish:.0f} %", end="")
    print()
    names = ("paper", "paper-green")
    pairs = [tell(name, Growth(preset=name), args.finalists > 0) for name in names]
    for row in finalists(rows, args.finalists):
        print(", ".join(f"{key} {value:g}" for key, value in zip(RANGES, row, strict=False)))
        pairs.append(tell("", growth(row[: len(RANGES)]), True))
    if args.sheet:
        sheet(args.sheet, pairs)


if __name__ == "__main__":
    main()
