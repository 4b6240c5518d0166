"""Changes of a picture that its measures should not follow, and how far they do.

    python -m tests.measure.changes

prints the table of docs/measure.md, in a few minutes.
"""

import io
from collections.abc import Callable
from itertools import product

import numpy as np
from PIL import Image

import nacreous as nc
from nacreous.measure import Measures, measure
from tests.measure.synthetic import Light

#: The white under which pictures are turned: illuminant A, against D65.
THERE, D65 = np.array([1.0985, 1.0, 0.3558]), np.array([0.95047, 1.0, 1.08883])
PEARLS = ("tahitian", "akoya-rg", "south-sea-gold")
SCENES = ("paper", "north-window-black")
SIZES = (192, 384)
#: Kinds of blemishes whose area is followed, and how deep they are: 24, over 6 % of the pearl.
SPOTS = {"chalky_spots": 20, "pits": 60}
#: Light is made darker by this, so that no code ends before it does.
DARKER = 0.25


def numbers(found: Measures) -> dict[str, float]:
    """What must not change with the picture's making; without what was refused."""
    numbers = {"diameter": found.size.mean.value}
    for number, ring in enumerate(found.rings or ()):
        if ring.colour is not None and ring.share > 0.5:
            numbers[f"ring {number}"] = ring.colour.chroma.value
    if (lamp := found.lamp) is not None:
        numbers |= {
            "half-width": lamp.half_width_deg.value,
            "peak": lamp.peak,
            "gloss": lamp.contrast_gloss.value,
        }
        if lamp.haze is not None:
            numbers["haze"] = lamp.haze.value
    if (colours := found.interference) is not None:
        numbers |= {
            "chroma": colours.chroma.value,
            "orient": colours.orient.value,
            "score": colours.score.value,
        }
    return numbers


def area(found: Measures) -> dict[str, float]:
    """The blemished area where one is measured, and whether it is told to be unsure."""
    if found.blemishes is None:
        return {}
    is_unsure = "blemishes.relief" in found.refused
    return {"area": found.blemishes.area.value, "is unsure": float(is_unsure)}


def picture(pearl: str, scene: str, size: int, spots: str | None) -> Light:
    """A pearl's light, with blemishes of a kind where one is given."""
    keys = {} if spots is None else {spots: 24, "area": 0.06, "depth_um": SPOTS[spots]}
    sets = [(f"blemishes.{key}", str(value)) for key, value in keys.items()]
    light = nc.render(nc.Pearl.load(pearl, sets), scene, size=size, samples=4).linear
    return (DARKER * light).astype(np.float32)


def jpeg(linear: Light) -> Light:
    stream = io.BytesIO()
    codes = np.rint(255 * nc.colour.encode(np.clip(linear, 0, 1))).astype(np.uint8)
    Image.fromarray(codes).save(stream, "JPEG", quality=90)
    read = np.asarray(Image.open(stream), float) / 255
    return nc.colour.decode(read).astype(np.float32)


def halved(linear: Light) -> Light:
    side = len(linear) // 2
    return linear.reshape(side, 2, side, 2, 3).mean((1, 3), dtype=np.float32)


def shifted(linear: Light) -> Light:
    """By 3.4 pixels to the left and 1.7 down, the border going on."""
    rows, columns = np.clip(np.arange(len(linear)) - 1.7, 0, None), np.arange(len(linear)) + 3.4
    for axis, place in ((0, rows), (1, np.clip(columns, 0, len(linear) - 1.01))):
        first = place.astype(int)
        part = (place - first).reshape((-1, 1, 1) if axis == 0 else (1, -1, 1))
        linear = (1 - part) * linear.take(first, axis) + part * linear.take(first + 1, axis)
    return linear.astype(np.float32)


def turned(linear: Light) -> Light:
    """As illuminant A would show it."""
    xyz = nc.colour.xyz_from_rgb(linear.astype(float))
    return nc.colour.rgb_from_xyz(nc.colour.adapt(xyz, D65, THERE)).astype(np.float32)


#: By name: the change, what it makes of lengths, and of the white.
CHANGES: dict[str, tuple[Callable[[Light], Light], float, bool]] = {
    "jpeg": (jpeg, 1.0, False),
    "half size": (halved, 0.5, False),
    "shift": (shifted, 1.0, False),
    "white": (turned, 1.0, True),
}


#: 5 % of this is what a measure may move by, where it is smaller: 0.6 of a chroma, for JPEG keeps
#: colour in whole codes, of which a half is 0.9 to 1.8 in CIELAB here; and a point of the score,
#: which counts by chroma. A grey has no chroma to keep a share of.
LEAST = {"ring": 12.0, "chroma": 12.0, "orient": 12.0, "score": 20.0}


def least(name: str) -> float:
    """What a smaller measure counts as, when it is said by which share it moved."""
    return LEAST.get(name.split(" ")[0], 1e-3)


#: What the command line takes for clipped in a file of 8 bits.
CLIPPED = 0.97


def moved(
    linear: Light,
    change: str,
    white: float = 1.0,
    told: Callable[[Measures], dict[str, float]] = numbers,
) -> dict[str, tuple[float, float]]:
    """What is told before and after a change, lengths scaled alike; nan where refused after."""
    made, length, is_turned = CHANGES[change]
    before = told(measure(linear, white=(white,) * 3))
    other = np.maximum(white * nc.colour.rgb_from_xyz(THERE), 1e-3) if is_turned else [white] * 3
    ends = CLIPPED if change == "jpeg" else None
    after = told(measure(made(linear), white=other, clipped_at=ends))
    if "diameter" in before:
        before["diameter"] *= length
    return {name: (value, after.get(name, np.nan)) for name, value in before.items()}


def main() -> None:
    print(
        "| measure |",
        " | ".join(f"{change}, {size} px" for size in SIZES for change in CHANGES),
        "|",
    )
    print("|---" * (1 + len(CHANGES) * len(SIZES)) + "|")
    most: dict[str, dict[tuple[int, str], float]] = {}
    refused = []
    for size, pearl, scene, spots in product(SIZES, PEARLS, SCENES, (None, *SPOTS)):
        linear = picture(pearl, scene, size, spots)
        for change in CHANGES:
            try:
                found = moved(linear, change, DARKER, numbers if spots is None else area)
            except nc.InputError:
                refused.append(f"{pearl} on {scene}, {change}, {size} px")
                continue
            is_unsure = any(found.pop("is unsure", ()))
            for name, (before, after) in found.items():
                kind = "a ring's chroma" if name.startswith("ring") else name
                kind = f"{kind} of {spots.replace('_', ' ')}" if spots else kind
                kind += ", named as unsure" * is_unsure
                off = 100 * abs(after - before) / max(abs(before), least(name))
                row = most.setdefault(kind, {})
                if not np.isnan(off):
                    row[size, change] = max(row.get((size, change), 0.0), off)
    for name, row in most.items():
        columns = ((size, change) for size in SIZES for change in CHANGES)
        cells = (f"{row[one]:.1f}" if one in row else "-" for one in columns)
        print(f"| {name} |", " | ".join(cells), "|")
    print("Refused:", "; ".join(refused) or "none")


if __name__ == "__main__":
    main()
