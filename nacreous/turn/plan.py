"""The frames of a turn, each as the recipe of its picture; all arguments are checked here."""

from __future__ import annotations

import hashlib
import json
import math
from pathlib import Path
from typing import NamedTuple

from nacreous import __version__
from nacreous.named_files import hashes
from nacreous.number import number_of, whole_of
from nacreous.problem import InputError
from nacreous.recipe import Recipe, loaded, recipe
from nacreous.spec import Pearl, Scene
from nacreous.turn.motion import check, turned

#: The most frames **(ours)**: a minute and a half of film.
MOST_FRAMES = 2000
#: The most degrees either way **(ours)**: ten times round.
MOST_DEG = 3600.0


class Plan(NamedTuple):
    """A turn: what goes round, how far, and the recipe of each frame."""

    pearl: str
    scene: str
    what: str
    degrees: float
    size: int
    samples: int
    recipes: list[Recipe]

    @property
    def digest(self) -> str:
        """The SHA-256 of all that the frames are made from: recipes, files, version."""
        made = [one.json for one in self.recipes]
        held = hashes(made[0])
        return hashlib.sha256(json.dumps([__version__, made, held]).encode()).hexdigest()


def plan(
    pearl: str | Path | Pearl,
    scene: str | Path | Scene,
    count: int,
    what: str,
    degrees: float,
    size: int,
    samples: int,
) -> Plan:
    """Check everything and lay out the frames; arguments as for `nacreous.turn.frames`.

    >>> [made.size for made in plan("akoya-rg", "booth", 3, "pearl", 360, 8, 1).recipes]
    [8, 8, 8]
    """
    count = whole_of("frames", count, 2, MOST_FRAMES)
    degrees = number_of("degrees", degrees)
    if not 0 < abs(degrees) <= MOST_DEG:  # NaN is none either
        raise InputError(
            f"degrees is {degrees:g}; allowed: -{MOST_DEG:g} to {MOST_DEG:g}, and not 0"
        )
    shown, around = loaded(Pearl, pearl), loaded(Scene, scene)
    check(what, shown, around)
    # After whole turns the first frame follows the last one; of a part, the last shows its end.
    steps = count if math.fmod(degrees, 360.0) == 0 else count - 1
    recipes = [
        recipe(*turned(what, shown, around, degrees * number / steps), size, samples)
        for number in range(count)
    ]
    size = recipes[0].size
    samples = int(json.loads(recipes[0].json)["samples"])
    return Plan(shown.name, around.name, what, degrees, size, samples, recipes)
