"""Hue around and across the rings of interference colour."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous import colour
from nacreous.paper.sight import Sight

__all__ = [
    "FAMILIES",
    "families",
    "family_share",
    "profile",
    "ring_spread",
    "span_deg",
]

Array = NDArray[np.float64]

#: Munsell's ten hue families, in his order.
FAMILIES = ("R", "YR", "Y", "GY", "G", "BG", "B", "PB", "P", "RP")
_GREY_CHROMA = 0.5


def profile(layer: NDArray[np.float32], sight: Sight, rings: int = 48) -> tuple[Array, Array]:
    """Distance from the centre in radii, and mean linear RGB of each ring, [ring, 3].

    Rings are as wide as each other; those that hold no middle of a pixel are left out.
    """
    away = sight.circle.distance(layer.shape)
    whole = np.isfinite(sight.cos_view)
    ring = np.minimum((away[whole] * rings).astype(int), rings - 1)
    count = np.bincount(ring, minlength=rings)
    held = count > 0
    mean = [np.bincount(ring, weights, rings) for weights in (away[whole], *layer[whole].T)]
    distance, *rgb = (sums[held] / count[held] for sums in mean)
    return distance, np.stack(rgb, axis=1)


def hue_deg(rgb: Array) -> Array:
    """Munsell hue as an angle in degrees, continuous along the colours [n, 3]; grey has NaN."""
    hue, _, chroma = np.moveaxis(colour.hvc_from_rgb(rgb), -1, 0)
    turned = np.where(chroma >= _GREY_CHROMA, hue, np.nan)
    known = np.isfinite(turned)
    turned[known] = np.unwrap(turned[known])
    return np.degrees(turned)


def ring_spread(layer: NDArray[np.float32], sight: Sight) -> float:
    """Largest difference of a channel around a ring, over the ring's strongest channel.

    A ring is all pixels whose middles are exactly as far from the centre as each other, three
    pixels or more within the rim, next to which pixels are seen in lines, not from their middles;
    the picture must have one sample a pixel.
    """
    size = layer.shape[0]
    step = 2 * np.arange(size) + 1 - size
    square = step[:, None] ** 2 + step[None, :] ** 2
    whole = sight.circle.distance(layer.shape) < 1 - 3 / sight.circle.radius_px
    order = np.argsort(square[whole], kind="stable")
    starts = np.flatnonzero(np.diff(square[whole][order], prepend=-1))
    colours = layer[whole][order].astype(np.float64)
    high = np.maximum.reduceat(colours, starts)
    low = np.minimum.reduceat(colours, starts)
    strongest = np.abs(high).max(axis=1)
    return float(((high - low).max(axis=1) / np.maximum(strongest, 1e-12)).max())


def families(rgb: Array) -> list[str]:
    """Munsell's hue family of each colour [n, 3]; "N" for grey.

    >>> families(np.array([[0.5, 0.1, 0.1], [0.1, 0.3, 0.5], [0.2, 0.2, 0.2]]))
    ['R', 'PB', 'N']
    """
    notations = colour.munsell_notation(colour.hvc_from_rgb(rgb))
    return [_family(note) for note in notations]


def family_share(rgb: Array, wanted: tuple[str, ...]) -> float:
    """Share of the colours [n, 3] whose hue belongs to one of the families."""
    found = np.array(families(rgb))
    return float(np.isin(found, wanted).mean()) if found.size else float("nan")


def span_deg(rgb: Array) -> float:
    """The arc of the hue circle that holds all colours [n, 3]: 360 degrees less the widest gap."""
    hue, _, chroma = np.moveaxis(colour.hvc_from_rgb(rgb), -1, 0)
    angles = np.sort(np.degrees(hue[chroma >= _GREY_CHROMA]))
    if angles.size < 2:
        return 0.0
    gaps = np.diff(angles, append=angles[0] + 360)
    return float(360 - gaps.max())


def middles_deg() -> list[tuple[float, str]]:
    """The hue angle, -180 to 180 degrees, in the middle of each family, such as 5R, and its name.

    >>> [name for _, name in middles_deg()][:3]
    ['R', 'YR', 'Y']
    """
    turn = np.radians(np.arange(-180, 180, 0.5))
    circle = np.stack([turn, np.full_like(turn, 5.0), np.full_like(turn, 6.0)], axis=1)
    names = np.array([_family(note) for note in colour.munsell_notation(circle)])
    means = [np.exp(1j * turn[names == family]).mean() for family in FAMILIES]
    return [
        (float(np.degrees(np.angle(mean))), family)
        for mean, family in zip(means, FAMILIES, strict=True)
    ]


def _family(notation: str) -> str:
    """The letters of a notation's hue: 5.2PB 3/4 gives PB, N 5/ gives N."""
    return str(notation).split()[0].lstrip("0123456789.")
