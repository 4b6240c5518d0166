"""The lamp's image on a pearl, measured in a picture: its half-width and its contrast."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

import nacreous as nc
from nacreous.spec import Camera, Lamp, Pearl, Scene, Sky, Table

SIZE_PX, DIAMETERS_SHOWN = 192, 1.5


class LampImage(NamedTuple):
    """half_width_deg: of reflected directions. contrast: peak over the body's median beside it."""

    half_width_deg: float
    contrast: float


def measured(facet_spread_rad: float, lamp_radius_deg: float) -> LampImage:
    """On akoya-rg without waves and grain, by one lamp at 45 degrees to the line of sight."""
    keys = {"surface.waviness_rad": 0.0, "grain": 0.0, "surface.facet_spread_rad": facet_spread_rad}
    lamp = Lamp(azimuth_deg=0.0, elevation_deg=45.0, angular_radius_deg=lamp_radius_deg)
    scene = Scene(
        camera=Camera(elevation_deg=0.0, glare=0.0),
        lamps=(lamp,),
        table=Table(kind="none"),
        sky=Sky(intensity=0.0),
    )
    light = nc.render(Pearl.load("akoya-rg", keys), scene, SIZE_PX, 16).linear[..., 1]
    radius_px = 0.5 * SIZE_PX / DIAMETERS_SHOWN
    across = (np.arange(SIZE_PX) - 0.5 * (SIZE_PX - 1)) / radius_px
    x, y = np.meshgrid(across, -across)
    z = np.sqrt(np.clip(1 - x**2 - y**2, 0, 1))
    normal, on_pearl = np.stack([x, y, z], axis=-1), z > 0.3
    peak = np.unravel_index((light * on_pearl).argmax(), light.shape)
    away_deg = np.degrees(np.arccos(np.clip(normal @ normal[peak], -1, 1)))
    body = np.median(light[on_pearl & (away_deg > 30) & (away_deg < 45)])
    bright = on_pearl & (light - body > 0.5 * (light[peak] - body))
    # A cap of half-angle t covers 2 pi (1 - cos t); a mirrored direction turns twice as far.
    solid_angle = (radius_px**-2 / z[bright]).sum()
    cap_deg = np.degrees(np.arccos(1 - solid_angle / (2 * np.pi)))
    return LampImage(float(2 * cap_deg), float(light[peak] / body))


def main() -> None:
    """Print what docs/words.md says of a lamp's image, at each bound between two words."""
    from nacreous.trade import words

    for word in words("luster")[:-1]:
        spread_rad = word.ranges[0].upper
        sharp, clear = measured(spread_rad, 1.0), measured(spread_rad, 6.0)
        print(
            f"{spread_rad:g} rad: {sharp.half_width_deg:.1f} degrees, contrast {clear.contrast:.1f}"
        )


if __name__ == "__main__":
    main()
