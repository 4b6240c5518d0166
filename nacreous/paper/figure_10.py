"""Figure 10: the interference component, and its hue from the centre to the rim."""

from __future__ import annotations

from itertools import groupby
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.figure import figure
from nacreous.paper import hue
from nacreous.paper.component import alone
from nacreous.paper.exhibit import Exhibit, Plate
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import LAMPS_DEG, Pictures
from nacreous.paper.sight import Sight

__all__ = ["BLUISH", "FILES", "exhibit", "measure"]

Array = NDArray[np.float64]

FILES = ("figure-10.png", "figure-10-hue.png")
#: Munsell's hue families that count as bluish **(ours)**.
BLUISH = ("BG", "B", "PB")


def measure(layers: list[NDArray[np.float32]], sight: Sight) -> list[Measurement]:
    """What the paper's sentences ask of interference layers under different lamps.

    layers: linear RGB [row, column, 3] with one sample in the middle of each pixel.
    """
    profiles = [hue.profile(layer, sight)[1] for layer in layers]
    hues = [hue.hue_deg(rgb) for rgb in profiles]
    apart = max(_largest(np.abs(other - hues[0])) for other in hues[1:])
    uneven = max(hue.ring_spread(layer, sight) for layer in layers)
    disc = layers[0][np.isfinite(sight.cos_view)].astype(np.float64)
    met = float(len(_route(profiles[0])))
    arc, bluish = hue.span_deg(profiles[0]), hue.family_share(disc, BLUISH)
    chroma = float(colour.hvc_from_rgb(disc)[..., 2].mean())
    families = ", ".join(BLUISH)
    return [
        Measurement("largest hue difference between lamp directions", apart, "°", least=0, most=0),
        Measurement("largest relative difference of colour around a ring", uneven, most=1e-6),
        Measurement("Munsell hue families met from centre to rim, of ten", met, least=4),
        Measurement("arc of the hue circle passed on the way", arc, "°", least=90),
        Measurement(f"share of the disc with a bluish hue ({families})", bluish, least=0.1),
        Measurement("mean Munsell chroma, as bright as in the picture", chroma),
    ]


def exhibit(folder: Path, pictures: Pictures) -> Exhibit:
    """Save the component and the diagram in `folder`, and measure them."""
    path, curves = (folder / name for name in FILES)
    component, gain = alone(pictures.smooth, "interference")
    component.save(path)
    layers = [picture.layers["interference"] for picture in pictures.lamps]
    profiles = [hue.profile(layer, pictures.lamp_sight) for layer in layers]
    _draw(curves, profiles)
    distance, rgb = profiles[0]
    notes = colour.munsell_notation(colour.hvc_from_rgb(rgb))
    way = ", ".join(f"{notes[i]} at {distance[i]:.2f}" for i in _route(rgb))
    return Exhibit(
        "10",
        [Plate(path), Plate(curves)],
        measure(layers, pictures.lamp_sight),
        "nacreous render paper --set grain=0 -o layers.exr (layer interference)",
        [
            f"The component is shown {gain:g} times as bright as in figure 14 (a).",
            f"Munsell notation from the centre (0) to the rim (1), where each hue begins: {way}.",
        ],
    )


def _largest(values: Array) -> float:
    """The largest, where there is any: grey has no hue."""
    known = values[np.isfinite(values)]
    return float(known.max()) if known.size else float("nan")


def _route(rgb: Array) -> list[int]:
    """Where, along colours [n, 3], each hue family begins; greys are passed over."""
    found = hue.families(rgb)
    coloured = [i for i, family in enumerate(found) if family != "N"]
    return [next(run) for _, run in groupby(coloured, key=lambda i: found[i])]


def _draw(path: Path, profiles: list[tuple[Array, Array]]) -> None:
    """Curves of falling width, so that those below are seen beside those above."""
    names = [
        "as in 14 (a)",
        *(f"{round_deg:g}°, {up_deg:g}° up" for round_deg, up_deg in LAMPS_DEG),
    ]
    with figure(path, width_in=6.0, height_in=4.0) as axes:
        for i, (name, (distance, rgb)) in enumerate(zip(names, profiles, strict=True)):
            width, label = 9.0 - 2.4 * i, f"lamp {name}"
            axes.plot(distance, hue.hue_deg(rgb), color=f"C{i}", linewidth=width, label=label)
        low, high = axes.get_ylim()
        turns = [(angle + turn, name) for angle, name in hue.middles_deg() for turn in _TURNS_DEG]
        ticks = [(angle, name) for angle, name in turns if low <= angle <= high]
        axes.set_yticks([angle for angle, _ in ticks], [f"5{name}" for _, name in ticks])
        axes.set(xlim=(0, 1), ylim=(low, high))
        axes.set_xlabel("distance from the centre, radii")
        axes.set_ylabel("Munsell hue")
        axes.legend()
        strip = axes.inset_axes((0.0, 1.02, 1.0, 0.07))
        strip.imshow(_strip(*profiles[0])[None], aspect="auto", extent=(0, 1, 0, 1))
        strip.set_axis_off()


_TURNS_DEG = (-720, -360, 0, 360, 720)


def _strip(distance: Array, rgb: Array) -> Array:
    """The colours from centre to rim as codes [n, 3] of a screen, as bright as it can."""
    places = np.linspace(0, 1, 400)
    even = np.stack([np.interp(places, distance, channel) for channel in rgb.T], axis=1)
    bright = even * (0.9 / max(float(even.max()), 1e-9))
    return colour.encode(colour.map_to_gamut(bright, "soft"))
