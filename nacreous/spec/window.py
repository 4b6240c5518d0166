"""The [[windows]] of a scene."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated, NamedTuple

from pydantic import Field

from nacreous.spec.complaint import Contradiction, shown
from nacreous.spec.key import key, quantity
from nacreous.spec.section import Section
from nacreous.spec.texts import SPECTRUM, SPECTRUM_EXAMPLES, Spectrum

#: Windows stay clear of the largest pearl (radius 15 mm), as lamps do.
_NEAREST_MM = 20.0
#: Where a window stands whose distance is left out.
_FAR_MM = 1000.0

Vector = tuple[float, float, float]
_Coordinate = Annotated[float, Field(ge=-100_000, le=100_000)]


class Frame(NamedTuple):
    """Where a window is: its middle, and from there to its right and its upper edge, in mm.

    It shines along right x up.
    """

    centre_mm: Vector
    right_mm: Vector
    up_mm: Vector

    def distance_mm(self, point: Vector) -> float:
        """Distance from a point to the nearest point of the window.

        >>> Frame((0, 0, -9), (3, 0, 0), (0, 2, 0)).distance_mm((7, 0, -6))
        5.0
        """
        away = tuple(a - b for a, b in zip(point, self.centre_mm, strict=True))
        for edge in (self.right_mm, self.up_mm):
            length = math.hypot(*edge)
            along = sum(a * b for a, b in zip(away, edge, strict=True)) / length
            share = max(-length, min(length, along)) / length
            away = tuple(a - share * b for a, b in zip(away, edge, strict=True))
        return math.hypot(*away)


class Window(Section):
    """A rectangle of even light, on one side: a window, a softbox, a lit plate.

    >>> Window(azimuth_deg=-40, elevation_deg=30).width_mm
    300.0
    """

    azimuth_deg: float | None = quantity(
        None,
        "Direction seen from the pearl, which the window faces; with elevation_deg.",
        least=-360,
        most=360,
        unit="degrees",
        source="**(ours)**",
        left_out="position_mm or below_mm is given instead",
    )
    elevation_deg: float | None = quantity(
        None,
        "Height above the horizon, seen from the pearl; with azimuth_deg.",
        least=-90,
        most=90,
        unit="degrees",
        source="**(ours)**",
        left_out="position_mm or below_mm is given instead",
    )
    distance_mm: float | None = quantity(
        None,
        "Distance of its middle from the pearl's centre; with azimuth_deg and elevation_deg.",
        least=_NEAREST_MM,
        most=100_000,
        unit="mm",
        source="**(ours)**",
        left_out="1000 mm, or position_mm or below_mm is given instead",
    )
    position_mm: tuple[_Coordinate, _Coordinate, _Coordinate] | None = key(
        None,
        "Position [x, y, z] of its middle from the pearl's centre.",
        allowed="three numbers from -100000 to 100000 mm",
        left_out="azimuth_deg and elevation_deg, or below_mm, are given instead",
        unit="mm",
        source="**(ours)**",
        strict=False,
    )
    facing: tuple[_Coordinate, _Coordinate, _Coordinate] | None = key(
        None,
        "Direction [x, y, z] in which the window shines; with position_mm.",
        allowed="three numbers from -100000 to 100000, not all 0",
        left_out="towards the pearl",
        source="**(ours)**",
        strict=False,
    )
    below_mm: float | None = quantity(
        None,
        "The window lies flat and shines upward, this far below the pearls' lowest point.",
        least=0.01,
        most=1000,
        unit="mm",
        source="**(ours)**; Aurora viewer, the pearl touches its light",
        left_out="azimuth_deg and elevation_deg, or position_mm, are given instead",
    )
    width_mm: float = quantity(
        300.0,
        "Width: level, or along x for a window that lies flat.",
        least=0.1,
        most=100_000,
        unit="mm",
        source="**(ours)**",
    )
    height_mm: float = quantity(
        300.0,
        "Height: at right angles to the width.",
        least=0.1,
        most=100_000,
        unit="mm",
        source="**(ours)**",
    )
    spectrum: Spectrum = key(
        "D65",
        "The window's light; a spectrum's path is relative to this file.",
        allowed=SPECTRUM,
        source="CIE illuminants",
        examples=SPECTRUM_EXAMPLES,
    )
    luminance: float = quantity(
        1.0,
        "Radiance, in units of white paper facing a lamp of intensity 1.",
        least=0,
        most=1_000_000,
        source="**(ours)**",
    )

    def contradictions(self) -> Iterator[Contradiction]:
        """A window in no place or in two, inside the pearl, or that faces nowhere."""
        ways = [
            [name for name in way if getattr(self, name) is not None]
            for way in (("azimuth_deg", "elevation_deg", "distance_mm"), ("position_mm",))
        ]
        ways.append(["below_mm"] if self.below_mm is not None else [])
        used = [way for way in ways if way]
        if not used:
            yield Contradiction(
                "azimuth_deg", "is missing: give it, or give position_mm or below_mm"
            )
        for way in used[1:]:
            verdict = "cannot stand beside {other}: a window has one place"
            yield Contradiction(way[0], verdict, used[0][0])
        if ways[0] and len(used) == 1:
            for name in ("azimuth_deg", "elevation_deg"):
                if name not in ways[0]:
                    verdict = "is missing: give it together with {other}"
                    yield Contradiction(name, verdict, ways[0][0])
        yield from self._direction()

    def _direction(self) -> Iterator[Contradiction]:
        if self.facing is not None and self.position_mm is None:
            yield Contradiction("facing", "is of use only with position_mm, which is missing")
        if self.facing is not None and math.hypot(*self.facing) < 1e-9:
            yield Contradiction(
                "facing", f"is {shown(self.facing)}; allowed: three numbers, not all 0"
            )
        if self.position_mm is not None and math.hypot(*self.position_mm) < _NEAREST_MM:
            yield Contradiction(
                "position_mm",
                f"is {shown(self.position_mm)}, {math.hypot(*self.position_mm):.3g} mm from the "
                f"centre; allowed: at least {_NEAREST_MM:g} mm, clear of any pearl",
            )

    def frame(self, lowest_mm: float) -> Frame:
        """Where the window is, given the height of the pearls' lowest point.

        >>> window = Window(azimuth_deg=0, elevation_deg=0, distance_mm=50, width_mm=8)
        >>> [round(x, 9) for x in window.frame(-4.0).right_mm]
        [-4.0, 0.0, 0.0]
        """
        half = (0.5 * self.width_mm, 0.5 * self.height_mm)
        if self.below_mm is not None:
            return _framed((0.0, lowest_mm - self.below_mm, 0.0), (0.0, 1.0, 0.0), *half)
        if self.position_mm is not None:
            return _framed(self.position_mm, self.facing or _scaled(self.position_mm, -1.0), *half)
        azimuth = math.radians(self.azimuth_deg or 0.0)
        elevation = math.radians(self.elevation_deg or 0.0)
        flat = math.cos(elevation)
        toward = (math.sin(azimuth) * flat, math.sin(elevation), math.cos(azimuth) * flat)
        return _framed(_scaled(toward, self.distance_mm or _FAR_MM), _scaled(toward, -1.0), *half)


def _scaled(vector: Vector, factor: float) -> Vector:
    x, y, z = vector
    return factor * x, factor * y, factor * z


def _framed(centre: Vector, facing: Vector, half_width_mm: float, half_height_mm: float) -> Frame:
    """A level width, and a height at right angles to it and to the direction of the light."""
    x, y, z = (part / math.hypot(*facing) for part in facing)
    level = math.hypot(x, z)
    # A window that lies flat has its width along x.
    right = (z / level, 0.0, -x / level) if level > 1e-9 else (1.0, 0.0, 0.0)
    a, _, c = right
    up = (y * c, z * a - x * c, -y * a)
    return Frame(centre, _scaled(right, half_width_mm), _scaled(up, half_height_mm))
