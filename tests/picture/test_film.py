"""The film that a picture shows is the one of exact optics."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import nacreous as nc
from nacreous.nacre import columns_of
from nacreous.spec import Pearl, Scene

Array = NDArray[np.float64]

WHITE = nc.colour.white_xyz("D65")
NM = nc.colour.WAVELENGTH_NM
LOSSLESS: list[tuple[str, object]] = [("body.pigment", "none"), ("body.nucleus", "#ffffff")]
EVEN = Scene(
    sky={"kind": "constant", "intensity": 1.0},
    table={"kind": "none"},
    camera={"exposure": 1.0, "white": "D65", "elevation_deg": 0.0},
)
ANGLES_RAD = np.radians(np.arange(0.0, 91.0, 2.5))
#: Rings by angle in degrees. Beyond 80, where R rises steeply, the lean of the smoothest facets,
#: 0.7 degrees, counts.
RINGS_DEG = np.arange(2.5, 80.0, 5.0)


def reflected(pearl: Pearl, columns: int) -> Array:
    """XYZ [angle, 3] of R by exact optics every nanometre, the mean over columns by energy."""
    film = pearl.film.replace(columns=columns)
    outer_um = film.outer_um
    assert outer_um is not None
    stacks = columns_of(pearl.replace(film=film), outer_um)
    each = [nc.optics.energies(stack, ANGLES_RAD, NM, precision="single").R for stack in stacks]
    return nc.colour.xyz_from_spectrum(np.mean(each, axis=0), "D65")


def mirrored(pearl: Pearl, exact: Array) -> tuple[Array, Array]:
    """XYZ [ring, 3] of what a picture in even white light mirrors, and of the same rings by R."""
    image = nc.render(pearl, EVEN, size=192)
    coverage = image.layers["coverage"][..., 0].astype(float)
    row, column = np.indices(coverage.shape)
    down = row - np.average(row, weights=coverage)
    right = column - np.average(column, weights=coverage)
    radius = np.hypot(down, right) / np.sqrt(coverage.sum() / np.pi)
    angle_rad = np.arcsin(radius.clip(0.0, 1.0))
    seen = nc.colour.xyz_from_rgb(image.layers["mirror"].astype(float))
    wanted = np.stack([np.interp(angle_rad, ANGLES_RAD, part) for part in exact.T], axis=-1)
    rings = [
        (coverage > 0.999) & (np.abs(np.degrees(angle_rad) - ring) < 2.5) for ring in RINGS_DEG
    ]
    of_rings = (np.array([of[ring].mean(axis=0) for ring in rings]) for of in (seen, wanted))
    first, second = of_rings
    return first, second


@pytest.mark.parametrize("family", ["r", "rg", "g"])
def test_a_smooth_pearl_in_even_light_mirrors_the_film_of_a_thousand_columns(family: str) -> None:
    """64 columns, in four groups every fourth nanometre, against 1024 every nanometre.

    R to 0.007 in each of RGB, of which white has 1; T to 0.5 of CIEDE2000.
    """
    name = f"akoya-{family}-1.0"
    level = ("surface.waviness_rad", 0.0)
    pearl = Pearl.load(name, [("shininess", 1.0), ("grain", 0.0), level, *LOSSLESS])
    assert pearl.film.columns == 64
    seen, wanted = mirrored(pearl, reflected(pearl, 1024))
    off = nc.colour.rgb_from_xyz(seen) - nc.colour.rgb_from_xyz(wanted)
    assert seen.max() > 0.2
    assert np.abs(off).max() < 0.007
    through = [nc.colour.lab_from_xyz(WHITE - xyz, WHITE) for xyz in (seen, wanted)]
    assert nc.colour.delta_e_2000(*through).max() < 0.5
