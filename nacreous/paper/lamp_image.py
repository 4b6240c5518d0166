"""The lamp's image in a pearl: how bright it is, how wide, and how soft its edge."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nacreous.linear_light import luminance
from nacreous.paper.sight import Sight

__all__ = ["LampImage"]

Array = NDArray[np.float64]

#: Width of the rings, in degrees, over which brightness is averaged around the peak.
_RING_DEG = 0.5


@dataclass(frozen=True)
class LampImage:
    """The lamp's image as a bell in the mirrored component.

    Angles are those of the surface's normal: a mirror that leans by 1 degree turns light by 2.
    """

    peak: float
    """Luminance above the floor; a white matt surface facing the lamp has 1, times the exposure."""
    half_width_deg: float
    """From the middle to where half of the peak is left."""
    edge_deg: float
    """From where 9 tenths of the peak are left to where 1 tenth is."""
    away_deg: Array
    """Angle of each pixel's normal from that of the image's middle, [row, column]."""
    share: Array
    """Luminance above the floor over the peak's, [row, column]; 0 outside the pearl."""

    @classmethod
    def of(cls, mirror: NDArray[np.float32], sight: Sight) -> LampImage:
        """Find the image in the mirrored component, linear RGB [row, column, 3].

        The floor is the median over the pearl: what the surroundings mirrored there have.
        """
        light = np.where(np.isfinite(sight.cos_view), luminance(mirror), np.nan)
        floor = float(np.nanmedian(light))
        peak = float(np.nanmax(light)) - floor
        share = np.nan_to_num((light - floor) / max(peak, 1e-12))
        # The middle of what is at least half as bright, as an image may be flat on top.
        middle = sight.normal[share >= 0.5].sum(axis=0) if peak > 0 else np.array([0.0, 0.0, 1.0])
        cosine = sight.normal @ (middle / np.linalg.norm(middle))
        away_deg = np.degrees(np.arccos(np.clip(cosine, -1, 1)))
        reach = {level: _reach_deg(share, away_deg, level) for level in (0.9, 0.5, 0.1)}
        return cls(peak, reach[0.5], reach[0.1] - reach[0.9], away_deg, share)

    @property
    def inside(self) -> NDArray[np.bool_]:
        """The pixels of the image, out to the end of its edge: a tenth of the peak and more."""
        return np.asarray((self.share >= 0.1) & (self.away_deg <= 4 * self.half_width_deg))


def _reach_deg(share: Array, away_deg: Array, level: float) -> float:
    """Angle from the middle at which the mean over a ring falls to `level`; NaN if never."""
    rings = np.round(away_deg / _RING_DEG)
    inside = np.isfinite(rings)
    ring = rings[inside].astype(int)
    count = np.bincount(ring)
    held = np.flatnonzero(count)
    mean = np.bincount(ring, share[inside])[held] / count[held]
    at_deg = np.bincount(ring, away_deg[inside])[held] / count[held]
    below = np.flatnonzero(mean < level)
    if not below.size or below[0] == 0:
        return float("nan")
    outer = int(below[0])
    fall = (mean[outer - 1] - level) / (mean[outer - 1] - mean[outer])
    return float(at_deg[outer - 1] + fall * (at_deg[outer] - at_deg[outer - 1]))
