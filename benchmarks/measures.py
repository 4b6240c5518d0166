"""How measures follow the knob that they are for, and what else moves them.

    python benchmarks/measures.py

Each knob is swept in five steps at random settings of the others. Each cell holds two medians over
the settings: Spearman's rank correlation of knob and measure, and how far the measure goes over
the sweep, in percent of its mean. Settings at which a measure is refused at a step are left out of
its medians; how many pictures were refused as a whole stands at the end. docs/measure.md has the
table. It takes about an hour at 30 settings.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

import nacreous as nc
from nacreous.measure import Measures, measure

STEPS = 5
SCENES = ("paper", "north-window-black", "booth")
NACRE = ("akoya-r-1.0", "akoya-rg-1.0", "akoya-g-1.0")
PIGMENTS = ("none", "white", "cream", "pink")
FIELD_MM = 14.0
#: Blemishes on the whole pearl, of the kind that is swept, elsewhere at each setting.
SPOTS = 24
BLEMISHES = ("chalky_spots", "pits", "bumps")

#: By name: the least and the greatest of each knob. Roundness: pictures are stretched, or the pearl
#: itself is out of round, seen along its axis; elsewhere it is not. Spots, pits and bumps are swept
#: by `blemishes.area`.
KNOBS = {
    "diameter_mm": (5.0, 10.0),
    "roundness": (0.0, 0.045),
    "facet_spread_rad": (0.03, 0.14),
    "disorder_nm": (5.0, 50.0),
    "chalky_spots": (0.0, 0.1),
    "pits": (0.0, 0.1),
    "depth": (0.2, 0.9),
    "grain": (0.0, 1.0),
    "waviness_rad": (0.0, 0.15),
    "out_of_round": (0.0, 0.1),
    "bumps": (0.0, 0.1),
    "depth_um": (20.0, 80.0),
}
#: At random only: how deep blemishes of 0.3 mm are; it goes with their size.
UNSWEPT = ("depth_um",)
#: There are none where they are not swept.
NONE = dict.fromkeys((*BLEMISHES, "out_of_round"), 0.0)

MEASURES: dict[str, Callable[[Measures], float]] = {
    "diameter": lambda found: found.size.mean.value,
    "roundness": lambda found: found.roundness.value if found.roundness else np.nan,
    "half-width": lambda found: found.lamp.half_width_deg.value if found.lamp else np.nan,
    "peak": lambda found: found.lamp.peak if found.lamp else np.nan,
    "gloss": lambda found: found.lamp.contrast_gloss.value if found.lamp else np.nan,
    "haze": lambda found: found.lamp.haze.value if found.lamp and found.lamp.haze else np.nan,
    "chroma": lambda found: found.interference.chroma.value if found.interference else np.nan,
    "orient": lambda found: found.interference.orient.value if found.interference else np.nan,
    "blemishes": lambda found: found.blemishes.area.value if found.blemishes else np.nan,
}


def picture(
    setting: dict[str, float], scene: str, nacre: str, pigment: str, size: int
) -> Measures | None:
    """What is measured in the picture of one setting; None where the picture is refused."""
    kinds = [kind for kind in BLEMISHES if setting[kind] > 0]
    overrides = [("camera.field_mm", str(FIELD_MM)), ("table.kind", "plain")]
    place = nc.Scene.load(scene, overrides)
    pearl = nc.Pearl(
        blemishes={
            "area": sum(setting[kind] for kind in kinds),
            "depth_um": setting["depth_um"],
            "seed": int(setting["seed"]),
        }
        | dict.fromkeys(kinds, SPOTS),
        diameter_mm=setting["diameter_mm"],
        depth=setting["depth"],
        grain=setting["grain"],
        nacre={"preset": nacre},
        film={"column_spread_nm": setting["disorder_nm"], "outer_um": 50.0},
        body={"pigment": pigment, "nacre_mm": 0.5},
        surface={
            "facet_spread_rad": setting["facet_spread_rad"],
            "waviness_rad": setting["waviness_rad"],
        },
        shape={"out_of_round": setting["out_of_round"]},
        pose={"tilt_deg": 90.0 - place.camera.elevation_deg},
    )
    linear = nc.render(pearl, place, size=size, samples=4).linear
    linear = stretched(linear, setting["roundness"])
    try:
        return measure(linear, mm_per_pixel=FIELD_MM / size)
    except nc.InputError:
        return None


def stretched(linear: NDArray[np.float32], roundness: float) -> NDArray[np.float32]:
    """A picture made wider, by linear interpolation: (d_max - d_min) / d_mean is `roundness`."""
    factor = (1 + roundness / 2) / (1 - roundness / 2)
    size = linear.shape[1]
    middle = 0.5 * (size - 1)
    place = np.clip(middle + (np.arange(size) - middle) / factor, 0, size - 1.001)
    left = place.astype(int)
    part = (place - left)[None, :, None]
    return ((1 - part) * linear[:, left] + part * linear[:, left + 1]).astype(np.float32)


def rank_correlation(knob: NDArray[np.float64], found: NDArray[np.float64]) -> float:
    """Spearman's; NaN where a measure is refused, 0 where it never moves: it tells nothing then."""
    if not np.isfinite(found).all():
        return float("nan")
    if np.ptp(found) == 0:
        return 0.0
    return float(np.corrcoef(ranks(knob), ranks(found))[0, 1])


def ranks(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Ranks from 0; equal values share the mean of theirs, so that order alone makes none."""
    below = (values[None, :] < values[:, None]).sum(axis=1)
    equal = (values[None, :] == values[:, None]).sum(axis=1)
    return below + 0.5 * (equal - 1.0)


def change(found: NDArray[np.float64]) -> float:
    """How far a measure goes, in percent of its mean."""
    return float(100 * np.ptp(found) / abs(found.mean())) if found.any() else 0.0


def sweep(knob: str, settings: int, size: int) -> tuple[NDArray[np.float64], int]:
    """Rank correlation of one knob with each measure, and its change, [setting, measure, 2].

    And how many pictures were refused.
    """
    random = np.random.default_rng(list(KNOBS).index(knob))
    rows, refused = [], 0
    for number in range(settings):
        setting = {name: random.uniform(*ends) for name, ends in KNOBS.items()}
        words = [str(random.choice(choices)) for choices in (SCENES, NACRE, PIGMENTS)]
        setting |= NONE | {"seed": number}
        if knob == "out_of_round":  # stretching would undo or double it
            setting["roundness"] = 0.0
        values = np.linspace(*KNOBS[knob], STEPS)
        found = [picture(setting | {knob: value}, *words, size) for value in values]
        refused += found.count(None)
        columns = [
            np.array([np.nan if one is None else of(one) for one in found])
            for of in MEASURES.values()
        ]
        rows.append([(rank_correlation(values, column), change(column)) for column in columns])
    return np.array(rows), refused


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--settings", type=int, default=30)
    parser.add_argument("--size", type=int, default=256)
    parser.add_argument("--only", action="append")
    args = parser.parse_args()
    begin, refused = time.monotonic(), 0
    print("| knob |", " | ".join(MEASURES), "|")
    print("|---" * (len(MEASURES) + 1) + "|")
    knobs = args.only or [knob for knob in KNOBS if knob not in UNSWEPT]
    for knob in knobs:
        found, without = sweep(knob, args.settings, args.size)
        refused += without
        told = [
            f"{rank:.2f} ({moved:.0f})" if np.isfinite(rank) else "-"
            for rank, moved in (np.nanmedian(column, axis=0) for column in found.swapaxes(0, 1))
        ]
        print(f"| {knob} |", " | ".join(told), "|", flush=True)
    pictures = args.settings * STEPS * len(knobs)
    print(
        f"{args.settings} settings, {args.size} px, {refused} of {pictures} pictures refused, "
        f"{time.monotonic() - begin:.0f} s"
    )


if __name__ == "__main__":
    main()
