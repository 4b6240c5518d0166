"""How long a photographer of white pearls would expose a scene."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from nacreous.image import render
from nacreous.linear_light import luminance
from nacreous.problem import InputError
from nacreous.spec import Scene

__all__ = ["metered_exposure"]

#: A plain white pearl, of no colour family.
METER = "akoya-rg-0.0"

#: Share of its disc that stays below a screen's white: all but the lamps' images, which take 8 to
#: 12 % of it in the scenes that come with the package, and their edges **(ours)**.
BELOW_WHITE = 0.85

#: Pixels a side: twice as many move no scene's exposure by more than 1 %.
_SIZE_PX = 128


def metered_exposure(scene: str | Path | Scene) -> float:
    """`camera.exposure` with which white pearls look white in a scene and keep their shape.

    As photographers of white things do, it exposes as long as nothing but lamps' images burns
    out: 85 % of the disc of a plain white pearl, alone in the scene, stays below a screen's
    white. The scene's own exposure does not count, and neither do the pearls that it will show: a
    dark pearl stays dark, and all pearls of a study are exposed alike. scene: a model, a file or a
    preset's name. Raises `InputError` for a scene without light.

    >>> round(metered_exposure("booth"), 1)
    1.5
    """
    given = scene if isinstance(scene, Scene) else Scene.load(scene)
    camera = given.camera.replace(exposure=1.0, field_mm=None)
    image = render(METER, given.replace(camera=camera, rows=()), size=_SIZE_PX)
    disc = image.layers["coverage"][..., 0] > 0.999
    brightest = float(np.quantile(luminance(image.linear[disc]), BELOW_WHITE))
    if brightest <= 0:
        raise InputError("the scene sends no light to a pearl; allowed: a lamp, a window or a sky")
    return 1 / brightest
