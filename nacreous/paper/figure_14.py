"""Figure 14: the parts put together, and what each knob does."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.image import Image
from nacreous.paper.component import beside, chroma, lab
from nacreous.paper.exhibit import Exhibit, Plate
from nacreous.paper.lamp_image import LampImage
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import CLOSE_UP_MM, KNOB_SHARES, SAMPLES, WEAK, Pictures, overrides
from nacreous.paper.sight import Sight, direction_of
from nacreous.paper.table_image import contrast
from nacreous.spec import Scene

__all__ = ["FILES", "exhibits", "measure_a", "measure_b", "measure_c", "measure_d"]

Array = NDArray[np.float64]

#: The knob that each part turns.
_KNOBS = {"b": "depth", "c": "shininess", "d": "grain"}
FILES = (
    *(f"figure-14{part}.png" for part in "abcd"),
    *(f"figure-14{part}-{knob}.png" for part, knob in _KNOBS.items()),
)
#: How far away the part of the table lies whose mirrored contrast is compared.
_NEAR_MM = (0.0, 8.0)


def measure_a(picture: Image, scene: Scene) -> list[Measurement]:
    """What the paper says of the synthesised image."""
    names = ("interference", "diffuse", "mirror", "surroundings")
    parts = [picture.layers[name].astype(np.float64) for name in names]
    rest = float(np.abs(sum(parts) - picture.linear).max())
    cosine = float(direction_of(scene.camera) @ direction_of(scene.lamps[0]))
    angle_deg = float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))
    whole = _whole(picture)
    means = [float(part[whole].mean()) for part in parts[:3]]
    return [
        Measurement("lamp and line of sight, angle between", angle_deg, "°", least=44.9, most=45.1),
        Measurement("largest difference from the sum of the components", rest, most=1e-5),
        *(
            Measurement(
                f"share of the {name} component in the light", mean / sum(means), least=0.01
            )
            for name, mean in zip(names, means, strict=False)
        ),
    ]


def measure_b(picture: Image, weak: Image, strip: list[Image], sight: Sight) -> list[Measurement]:
    """What a weaker depth does to the colours; `strip` goes from none of it to all."""
    full, less = (_mean_chroma(one, sight) for one in (picture, weak))
    return [
        Measurement("mean Munsell chroma of (a), lamp's image apart", full),
        Measurement("mean Munsell chroma of (b)", less),
        Measurement("chroma of (b) over that of (a)", less / max(full, 1e-12), most=0.7),
        Measurement(_GROWTH, _least_growth(strip), least=1e-6),
    ]


def measure_c(
    picture: Image, weak: Image, strip: list[Image], sight: Sight, check_mm: float
) -> list[Measurement]:
    """What a weaker shininess does to what is mirrored; `strip` goes from none of it to all."""
    sharp, soft = (LampImage.of(one.layers["mirror"], sight) for one in (picture, weak))
    wider = soft.half_width_deg / sharp.half_width_deg
    clear, dim = (contrast(one.linear, sight, check_mm, *_NEAR_MM) for one in (picture, weak))
    return [
        Measurement("half width of the lamp's image in (a)", sharp.half_width_deg, "°"),
        Measurement("half width in (c) over that", wider, least=1.5),
        Measurement("peak of the lamp's image, (c) over (a)", soft.peak / sharp.peak, most=0.5),
        Measurement("contrast of the mirrored table in (a), in all the light", clear),
        Measurement("contrast in (c) over that", dim / clear, most=0.8),
        Measurement(_GROWTH, _least_growth(strip), least=1e-6),
    ]


def measure_d(picture: Image, grained: Image, strip: list[Image]) -> list[Measurement]:
    """What grain does to the colours; `strip` goes from none of it to all."""
    apart = colour.delta_e_2000(lab(picture), lab(grained))[_whole(picture)]
    mean, most = float(apart.mean()), float(np.quantile(apart, 0.95))
    return [
        Measurement("mean colour difference CIEDE2000 to (a)", mean, least=0.1, most=3.0),
        Measurement("difference that 95 of 100 pixels stay under", most, most=6.0),
        Measurement(_GROWTH, _least_growth(strip), least=1e-6),
    ]


def exhibits(folder: Path, pictures: Pictures) -> list[Exhibit]:
    """Save the four pictures and the knobs' strips in `folder`, and measure them."""
    smooth, sight, knobs = pictures.smooth, pictures.sight, pictures.knobs
    check_mm = pictures.scene.table.check_mm
    weak = f"Weak is {WEAK:g} of the knob (ours): the paper gives no numbers."
    stand_in = "The grain is a procedural stand-in, as in figure 13."
    measured = {
        "a": measure_a(smooth, pictures.scene),
        "b": measure_b(smooth, pictures.shallow, knobs["depth"], sight),
        "c": measure_c(smooth, pictures.dull, knobs["shininess"], sight, check_mm),
        "d": measure_d(smooth, pictures.grained, knobs["grain"]),
    }
    shown = {"a": smooth, "b": pictures.shallow, "c": pictures.dull, "d": pictures.grained}
    remarks = {"a": [], "b": [weak], "c": [weak], "d": [stand_in]}
    return [
        Exhibit(
            f"14 ({part})",
            _plates(folder, part, shown[part], pictures),
            measured[part],
            _command(part, pictures.size_px),
            remarks[part],
        )
        for part in "abcd"
    ]


def _plates(folder: Path, part: str, picture: Image, pictures: Pictures) -> list[Plate]:
    path = folder / f"figure-14{part}.png"
    picture.save(path)
    knob = _KNOBS.get(part)
    if knob is None:
        return [Plate(path)]
    strip = folder / f"figure-14{part}-{knob}.png"
    beside(pictures.knobs[knob], knob, KNOB_SHARES).save(strip)
    steps = ", ".join(f"{share:g}" for share in KNOB_SHARES)
    close = f"; the middle {CLOSE_UP_MM:g} mm" if knob == "grain" else ""
    return [Plate(path), Plate(strip, f"{knob} {steps}{close}")]


def _command(part: str, size_px: int) -> str:
    """The command that makes this very file, byte by byte."""
    sets = "".join(f" --set {key}={value}" for key, value in overrides(part))
    size = f" --size {size_px} --samples {SAMPLES}"
    return f"nacreous render paper{sets}{size} -o figure-14{part}.png"


_GROWTH = "least growth, from one step of the knob to the next, of CIEDE2000 to none"


def _least_growth(strip: list[Image]) -> float:
    """Least growth, step to step, of the mean colour difference CIEDE2000 to the first picture."""
    first, whole = lab(strip[0]), _whole(strip[0])
    along = [float(colour.delta_e_2000(first, lab(one))[whole].mean()) for one in strip]
    return float(np.diff(along).min())


def _mean_chroma(picture: Image, sight: Sight) -> float:
    """Mean Munsell chroma of the pearl on the screen, clear of the lamp's image."""
    image = LampImage.of(picture.layers["mirror"], sight)
    return float(chroma(picture)[_whole(picture) & ~image.inside].mean())


def _whole(picture: Image) -> NDArray[np.bool_]:
    """The pixels that see nothing but the pearl."""
    return np.asarray(picture.layers["coverage"][..., 0] == 1)
