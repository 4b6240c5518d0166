"""What `--set` was given and no picture can show, for what it belongs to is not there."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping

from nacreous.spec.override import parse

__all__ = ["idle_note"]

_BLEMISHES = tuple(
    f"blemishes.{kind}" for kind in ("pits", "bumps", "scratches", "wrinkles", "chalky_spots")
)
#: Keys that say how something is, and those that say how much of it there is.
_BELONGS: Mapping[str, tuple[str, ...]] = {
    "blemishes.area": _BLEMISHES,
    "blemishes.size_mm": _BLEMISHES,
    "blemishes.depth_um": _BLEMISHES,
    "blemishes.seed": _BLEMISHES,
    "coat.patch_mm": ("coat.thickness_spread",),
    "coat.liveliness": ("coat.thickness_spread",),
    "coat.banding": ("coat.thickness_spread", "coat.hammering_rad", "coat.terrace_um"),
    "coat.dent_mm": ("coat.hammering_rad",),
    "coat.terrace_step_nm": ("coat.terrace_um",),
    "shape.lump_mm": ("shape.lumps",),
    "shape.circle_depth": ("shape.circles",),
    "shape.drill_wear_mm": ("shape.drill_mm",),
    "body.nucleus_band_mm": ("body.nucleus_bands",),
}


def idle_note(recipe: str, settings: Iterable[str]) -> str:
    """A line for each key that was set and changes no pearl of a recipe; "" of none.

    recipe: the JSON of `nacreous.recipe.Recipe`. settings: key=value, as `--set` has them.
    """
    pearls = json.loads(recipe)["pearls"]
    lines = []
    for key, value in map(parse, settings):
        needed = _BELONGS.get(key, ())
        if not needed or value in ("0", "0.0") or any(_of(one, needed) for one in pearls):
            continue
        lines.append(
            f"note: {key} is {value} and changes nothing, for {', '.join(needed)} "
            f"{'is' if len(needed) == 1 else 'are'} 0"
        )
    return "\n".join(lines)


def _of(pearl: Mapping[str, Mapping[str, float]], keys: Iterable[str]) -> bool:
    """Whether a pearl has any of these."""
    paths = (key.partition(".") for key in keys)
    return any(pearl.get(section, {}).get(name) for section, _, name in paths)
