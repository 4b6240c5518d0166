"""Figure 14: the parts put together, and what each knob does."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.image import Image
from nacreous.paper.component import beside, chroma, lab
from nacreous.paper.exhibit import Exhibit, Plate, Quotation
from nacreous.paper.lamp_image import LampImage
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import KNOB_SHARES, SAMPLES, Pictures, overrides
from nacreous.paper.sight import Sight, direction_of
from nacreous.paper.table_image import contrast
from nacreous.spec import Scene

__all__ = ["exhibits", "measure_a", "measure_b", "measure_c", "measure_d"]

Array = NDArray[np.float64]

#: Distance of the part of the table whose mirrored contrast is compared.
_NEAR_MM = (0.0, 8.0)


def measure_a(picture: Image, scene: Scene) -> list[Measurement]:
    """What the paper says of the synthesised image."""
    names = ("interference", "diffuse", "mirror", "surroundings")
    parts = [picture.layers[name].astype(np.float64) for name in names]
    rest = float(np.abs(sum(parts) - picture.linear).max())
    cosine = float(direction_of(scene.camera) @ direction_of(scene.lamps[0]))
    angle_deg = float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))
    whole = picture.layers["coverage"][..., 0] == 1
    shares = [float(part[whole].mean()) for part in parts[:3]]
    return [
        Measurement("angle between light source and line of sight", angle_deg, "deg", 44.9, 45.1),
        Measurement("largest difference from the sum of the components", rest, "", None, 1e-5),
        *(
            Measurement(
                f"share of the {name} component in the pearl's light", share / sum(shares), "", 0.01
            )
            for name, share in zip(names, shares, strict=False)
        ),
    ]


def measure_b(picture: Image, weak: Image, strip: list[Image], sight: Sight) -> list[Measurement]:
    """What a weaker depth does to the colours; `strip` goes from none to all of it."""
    full, less = (float(np.mean(chroma(one)[_clear(one, sight)])) for one in (picture, weak))
    return [
        Measurement("mean Munsell chroma of (a), lamp's image apart", full),
        Measurement("mean Munsell chroma of (b)", less),
        Measurement("chroma of (b) over that of (a)", less / full, "", None, 0.7),
        Measurement(
            "least growth of the colour difference CIEDE2000 from none, step to step of the knob",
            float(np.diff(along).min()),
            "",
            0.0,
        ),
    ]


def measure_c(picture: Image, weak: Image, sight: Sight, check_mm: float) -> list[Measurement]:
    """What a weaker shininess does to what is mirrored."""
    sharp, soft = (LampImage.of(one.layers["mirror"], sight) for one in (picture, weak))
    clear, dim = (contrast(one.linear, sight, check_mm, *_NEAR_MM) for one in (picture, weak))
    return [
        Measurement(
            "peak of the lamp's image, (c) over (a)", soft.peak / sharp.peak, "", None, 0.5
        ),
        Measurement("half width of the lamp's image in (a)", sharp.half_width_deg, "deg"),
        Measurement(
            "half width in (c) over that in (a)",
            soft.half_width_deg / sharp.half_width_deg,
            "",
            1.5,
        ),
        Measurement("contrast of the mirrored table in (a), seen among all light", clear),
        Measurement("that contrast in (c) over (a)", dim / clear, "", None, 0.8),
    ]


def measure_d(picture: Image, grained: Image, strip: list[Image]) -> list[Measurement]:
    """What grain does to the colours; `strip` goes from none to all of it."""
    whole = picture.layers["coverage"][..., 0] == 1
    apart = colour.delta_e_2000(lab(picture), lab(grained))[whole]
    return [
        Measurement(
            "mean colour difference CIEDE2000 from (a): small, but there",
            float(apart.mean()),
            "",
            0.1,
            3.0,
        ),
        Measurement(
            "95 of 100 pixels differ by at most", float(np.quantile(apart, 0.95)), "", None, 6.0
        ),
        Measurement(
            "least rise of that difference from step to step of the knob",
            float(np.diff(along).min()),
            "",
            1e-6,
        ),
    ]


def _least_growth(strip: list[Image]) -> float:
    """Least growth, step to step, of the mean colour difference CIEDE2000 from the first picture."""
    first = lab(strip[0])
    inside = strip[0].layers["coverage"][..., 0] == 1
    along = [float(colour.delta_e_2000(first, lab(one))[inside].mean()) for one in strip]
    return float(np.diff(along).min())


def exhibits(folder: Path, pictures: Pictures) -> list[Exhibit]:
    """Save the four pictures and the knobs' strips in `folder`, and measure them."""
    sight, knobs = pictures.sight, pictures.knobs
    check_mm = pictures.scene.table.check_mm
    shown = [pictures.smooth, pictures.shallow, pictures.dull, pictures.grained]
    measured = [
        measure_a(pictures.smooth, pictures.scene),
        measure_b(pictures.smooth, pictures.shallow, knobs["depth"], sight),
        measure_c(pictures.smooth, pictures.dull, sight, check_mm),
        measure_d(pictures.smooth, pictures.grained, knobs["grain"]),
    ]
    return [
        _exhibit(folder, letter, picture, measurements, pictures)
        for letter, picture, measurements in zip("abcd", shown, measured, strict=True)
    ]


def _exhibit(
    folder: Path, letter: str, picture: Image, measurements: list[Measurement], pictures: Pictures
) -> Exhibit:
    japanese, english, alt, quotation, knob = _PARTS[letter]
    path = folder / f"figure-14{letter}.png"
    picture.save(path)
    plates = [Plate(path, alt)]
    if knob:
        strip = folder / f"figure-14{letter}-{knob}.png"
        beside(pictures.knobs[knob], knob, KNOB_SHARES).save(strip)
        steps = ", ".join(f"{share:g}" for share in KNOB_SHARES)
        plates.append(Plate(strip, f"Five pearls side by side, {knob} rising.", f"{knob} {steps}"))
    sets = "".join(f" --set {key}={value}" for key, value in overrides(letter))
    command = (
        f"nacreous render paper{sets} --size {pictures.size_px} --samples {SAMPLES} -o {path.name}"
    )
    return Exhibit(
        f"14 ({letter})",
        japanese,
        english,
        [quotation],
        plates,
        measurements,
        command,
        _REMARKS[letter],
    )


def _clear(picture: Image, sight: Sight) -> NDArray[np.bool_]:
    """The pixels of the pearl that lie clear of the lamp's image."""
    image = LampImage.of(picture.layers["mirror"], sight)
    return np.asarray((picture.layers["coverage"][..., 0] == 1) & (image.share < 0.05))


_REMARKS = {
    "a": [],
    "b": ["How weak is weak is (ours): the paper gives no numbers."],
    "c": ["How weak is weak is (ours): the paper gives no numbers."],
    "d": ["The grain is a procedural stand-in, as in figure 13."],
}

#: Captions, what is to be seen, the paper's sentence, and the knob that changes.
_PARTS = {
    "a": (
        "合成画像",
        "A synthesized image.",
        "A pearl on a checkered table: rings of interference colour, the lamp's image at the upper left, "
        "the table mirrored below.",
        Quotation(
            "(a)は干渉光成分、拡散光成分、および映り込み成分を合成したものである。光源方向は視線方向と45°の角度を成しており、"
            "干渉色は光源方向と独立に色計算がされているが、矛盾を感じないばかりか、まさに真珠の干渉現象が表現できている。",
            "(a) puts together the interference, diffuse and mirrored components. The light source stands "
            "at 45° to the line of sight, and although the interference colours are computed without "
            "regard to it, nothing looks wrong; on the contrary, it is the interference of a pearl.",
            "4.4",
        ),
        "",
    ),
    "b": (
        "画像例 (深み感が弱い)",
        "Simulation of a feeling of depth (weak).",
        "The same pearl, pale: hardly any interference colour.",
        Quotation(
            "(b)は干渉光画像と拡散光画像との合成比を変えることにより、深み感の違いを出している。",
            "(b) shows another feeling of depth, by changing the ratio in which the interference and the "
            "diffuse image are mixed.",
            "4.4",
        ),
        "depth",
    ),
    "c": (
        "画像例 (輝き感が弱い)",
        "Simulation of a feeling of shininess (weak).",
        "The same pearl, satin: the lamp's image is wide and soft, the table hardly mirrored.",
        Quotation(
            "(c)は映り込み画像のパラメータを変え、(a)に対して輝き感の違いを出した。",
            "(c) differs from (a) in shininess, by changed parameters of the mirrored image.",
            "4.4",
        ),
        "shininess",
    ),
    "d": (
        "きめ感の表現",
        "A synthesized image with texture.",
        "The pearl of (a) with a fine grain.",
        Quotation(
            "(d)は(a)にテクスチャを付加したものである。わずかな色変化であるが、表面のきめ感とリアルさが向上することが"
            "真珠の専門家らによって確認されている。",
            "(d) is (a) with the texture added. The change of colour is small, yet experts on pearls have "
            "confirmed that the grain of the surface and its realism gain.",
            "4.4",
        ),
        "grain",
    ),
}

FILES = (
    *(f"figure-14{letter}.png" for letter in "abcd"),
    *(f"figure-14{letter}-{part[-1]}.png" for letter, part in _PARTS.items() if part[-1]),
)
