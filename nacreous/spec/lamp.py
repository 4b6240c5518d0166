"""The [[lamps]] of a scene."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Annotated

from pydantic import Field

from nacreous.spec.complaint import Contradiction, shown
from nacreous.spec.key import key, quantity
from nacreous.spec.section import Section
from nacreous.spec.texts import SPECTRUM, SPECTRUM_EXAMPLES, Spectrum

#: Lamps stay clear of the largest pearl (radius 15 mm).
_NEAREST_LAMP_MM = 20.0

_Coordinate = Annotated[float, Field(ge=-100_000, le=100_000)]


class Lamp(Section):
    """A round lamp, given by its direction from the pearl or by its position.

    >>> Lamp(azimuth_deg=-30, elevation_deg=45).spectrum
    'D65'
    """

    azimuth_deg: float | None = quantity(
        None,
        "Direction seen from the pearl, from the z axis to the right; with elevation_deg.",
        least=-360,
        most=360,
        unit="degrees",
        source="**(ours)**; the paper's lamp stands at 45 degrees to the line of sight",
        left_out="position_mm is given instead",
    )
    elevation_deg: float | None = quantity(
        None,
        "Height above the horizon, seen from the pearl; with azimuth_deg.",
        least=-90,
        most=90,
        unit="degrees",
        source="**(ours)**",
        left_out="position_mm is given instead",
    )
    position_mm: tuple[_Coordinate, _Coordinate, _Coordinate] | None = key(
        None,
        "Position [x, y, z] from the pearl's centre: x right, y up, z towards the viewer.",
        allowed="three numbers from -100000 to 100000 mm",
        left_out="azimuth_deg and elevation_deg are given instead",
        unit="mm",
        source="**(ours)**",
        strict=False,
    )
    angular_radius_deg: float = quantity(
        3.0,
        "Radius of the lamp as seen from the pearl.",
        least=0.05,
        most=30,
        unit="degrees",
        source="**(ours)**",
    )
    spectrum: Spectrum = key(
        "D65",
        "The lamp's light; a spectrum's path is relative to this file.",
        allowed=SPECTRUM,
        source="CIE illuminants",
        examples=SPECTRUM_EXAMPLES,
    )
    intensity: float = quantity(
        1.0,
        "Irradiance at the pearl on a surface facing the lamp, relative.",
        least=0,
        most=1_000_000,
        source="**(ours)**",
    )

    def contradictions(self) -> Iterator[Contradiction]:
        """A lamp in no place or in two, with half a direction, or inside the pearl."""
        angles = {"azimuth_deg": self.azimuth_deg, "elevation_deg": self.elevation_deg}
        given = [name for name, angle in angles.items() if angle is not None]
        if self.position_mm is None:
            if len(given) < 2:
                missing, other = sorted(angles, key=lambda name: name in given)
                verdict = "is missing: give it together with {other}, or give position_mm"
                yield Contradiction(missing, verdict, other)
            return
        for name in given:
            yield Contradiction(
                name, "cannot stand beside {other}: a lamp has one place", "position_mm"
            )
        if math.hypot(*self.position_mm) <= _NEAREST_LAMP_MM:
            yield Contradiction(
                "position_mm",
                f"is {shown(self.position_mm)}, {math.hypot(*self.position_mm):.3g} mm from the "
                f"centre; allowed: more than {_NEAREST_LAMP_MM:g} mm, clear of any pearl",
            )
