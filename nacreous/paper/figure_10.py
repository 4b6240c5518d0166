"""Figure 10: the interference component, and its hue from the centre to the rim."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.figure import figure
from nacreous.paper import hue
from nacreous.paper.component import alone
from nacreous.paper.exhibit import Exhibit, Plate, Quotation
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import LAMPS_DEG, Pictures
from nacreous.paper.sight import Sight

__all__ = ["exhibit", "measure"]

Array = NDArray[np.float64]

FILES = ("figure-10.png", "figure-10-hue.png")
#: What counts as bluish **(ours)**.
BLUISH = ("BG", "B", "PB")


def measure(layers: list[NDArray[np.float32]], sight: Sight) -> list[Measurement]:
    """What the paper's sentences ask of interference layers under different lamps.

    layers: linear RGB [row, column, 3] with one sample in the middle of each pixel.
    """
    profiles = [hue.profile(layer, sight)[1] for layer in layers]
    hues = [hue.hue_deg(rgb) for rgb in profiles]
    apart = max(float(np.nanmax(np.abs(other - hues[0]))) for other in hues[1:])
    whole = np.isfinite(sight.cos_view)
    disc = layers[0][whole].astype(np.float64)
    return [
        Measurement("largest hue difference between lamp directions", apart, "deg", None, 0.0),
        Measurement(
            "largest difference around any ring, over the ring's strongest channel",
            max(hue.ring_spread(layer, sight) for layer in layers),
            "",
            None,
            1e-6,
        ),
        Measurement(
            "hue families of Munsell's ten on the way from centre to rim",
            float(len(sequence(profiles[0]))),
            "",
            4,
        ),
        Measurement(
            "arc of the hue circle from centre to rim", hue.span_deg(profiles[0]), "deg", 90
        ),
        Measurement(
            f"share of the disc with a bluish hue ({', '.join(BLUISH)})",
            hue.family_share(disc, BLUISH),
            "",
            0.1,
        ),
        Measurement(
            "mean Munsell chroma of the component, as bright as in the picture", _mean_chroma(disc)
        ),
    ]


def sequence(rgb: Array) -> list[str]:
    """Hue families in the order in which they come along colours [n, 3], none twice in a row."""
    found = [family for family in hue.families(rgb) if family != "N"]
    return [family for i, family in enumerate(found) if i == 0 or family != found[i - 1]]


def exhibit(folder: Path, pictures: Pictures) -> Exhibit:
    """Save the component and the diagram in `folder`, and measure them."""
    path, curves = (folder / name for name in FILES)
    component, gain = alone(pictures.smooth, "interference")
    component.save(path)
    layers = [picture.layers["interference"] for picture in pictures.lamps]
    _draw(curves, layers, pictures.lamp_sight)
    distance, rgb = hue.profile(layers[0], pictures.lamp_sight)
    return Exhibit(
        "10",
        "干渉光成分",
        "An Interference image.",
        [
            Quotation(
                "真珠の干渉色は、光源と反対側の光が当たらない面にも現れ、かつ、常に球の中心から同心円状に変化する。",
                "The interference colours of a pearl appear even on the side turned away from the lamp, "
                "and always change in circles about the centre of the ball.",
                "3.1",
            ),
            Quotation(
                "図10に干渉光成分の画像例を示す。真珠の干渉色で最も美しいとされる青系の虹色の干渉色が観察される。",
                "Figure 10 shows an interference component. Bluish rainbow colours, held to be the most "
                "beautiful of a pearl, are seen.",
                "4.1",
            ),
        ],
        [
            Plate(path, "A disc of interference colour in concentric rings, on black."),
            Plate(
                curves,
                "Hue against distance from the centre for four lamp directions: the curves lie "
                "on top of one another. Above them, the colours in the same order.",
            ),
        ],
        measure(layers, pictures.lamp_sight),
        "nacreous render paper --set grain=0 -o layers.exr, layer interference",
        [
            f"Light shown times {gain:g} (the scene's own exposure aside).",
            f"From centre to rim: {_route(distance, rgb)} (Munsell, as bright as in the picture).",
        ],
    )


def _route(distance: Array, rgb: Array) -> str:
    """The first colour of each hue family on the way out, in Munsell notation."""
    notes = [str(note) for note in colour.munsell_notation(colour.hvc_from_rgb(rgb))]
    found = hue.families(rgb)
    firsts = [
        i for i in range(len(found)) if found[i] != "N" and (i == 0 or found[i] != found[i - 1])
    ]
    return " → ".join(f"{notes[i]} at {distance[i]:.2f} R" for i in firsts)


def _mean_chroma(rgb: Array) -> float:
    return float(colour.hvc_from_rgb(rgb)[..., 2].mean())


def _draw(path: Path, layers: list[NDArray[np.float32]], sight: Sight) -> None:
    """Curves of falling width, so that those below are seen beside those above."""
    names = ["its own place", *(f"{azimuth:g}°, {height:g}° up" for azimuth, height in LAMPS_DEG)]
    profiles = [hue.profile(layer, sight) for layer in layers]
    with figure(path, width_in=6.0, height_in=4.0) as axes:
        for i, (name, (distance, rgb)) in enumerate(zip(names, profiles, strict=True)):
            width, tint = 9.0 - 2.4 * i, f"C{i}"
            axes.plot(
                distance, hue.hue_deg(rgb), color=tint, linewidth=width, label=f"lamp: {name}"
            )
        low, high = axes.get_ylim()
        ticks = [
            (angle + turn, name)
            for angle, name in hue.family_ticks()
            for turn in (-720, -360, 0, 360, 720)
            if low <= angle + turn <= high
        ]
        axes.set_yticks([angle for angle, _ in ticks], [f"5{name}" for _, name in ticks])
        axes.set(xlim=(0, 1), ylim=(low, high))
        axes.set_xlabel("distance from the centre, radii")
        axes.set_ylabel("Munsell hue")
        axes.legend()
        strip = axes.inset_axes((0.0, 1.02, 1.0, 0.07))
        distance, rgb = profiles[0]
        even = np.stack(
            [np.interp(np.linspace(0, 1, 400), distance, channel) for channel in rgb.T], axis=1
        )
        bright = colour.map_to_gamut(even * (0.9 / max(float(even.max()), 1e-9)), "soft")
        strip.imshow(colour.encode(bright)[None], aspect="auto", extent=(0, 1, 0, 1))
        strip.set_axis_off()
