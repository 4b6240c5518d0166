"""The [[rows]] of a scene."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, Field

from nacreous.spec import preset
from nacreous.spec.key import FilePath, key
from nacreous.spec.section import Section
from nacreous.spec.texts import NAME, Name, ending

#: The most pearls in one scene.
MOST_PEARLS = 400

#: Stands for a pearl given to render: each the next one, or with a number that one, counted from 0.
GIVEN = "*"

_LINKS = (".toml",)


def _known(name: str) -> str:
    other = name.startswith(GIVEN) or FilePath(_LINKS).names_file(name)
    if not other and name not in preset.names("pearl"):
        raise ValueError("no such preset")
    return name


_Pearl = Annotated[
    str,
    Field(pattern=f"^([*][0-9]{{0,3}}|[a-z0-9][a-z0-9.-]*|{ending(*_LINKS)})$"),
    AfterValidator(_known),
]


class Row(Section):
    """A row of pearls from left to right; the first row is the farthest from a camera at azimuth 0.

    >>> Row(pearls=["akoya-rg", "*"]).pearls
    ('akoya-rg', '*')
    """

    pearls: Annotated[
        tuple[_Pearl, ...], Field(min_length=1, max_length=MOST_PEARLS), FilePath(_LINKS)
    ] = key(
        (GIVEN,),
        'The pearls: presets, files relative to this one, "*" for the next of the pearls given to '
        'render, or "*0", "*1" and so on for one of them.',
        allowed=f'1 to {MOST_PEARLS} pearl presets, paths ending in .toml, "*" or "*0" to "*999"',
        source="**(ours)**",
        examples=[GIVEN, *preset.names("pearl")],
        strict=False,
    )
    form: Literal["line", "neck"] = key(
        "line",
        'How they lie: side by side on a line, or around a neck ("neck"), each touching the next, '
        "in the only row of its scene.",
        allowed='"line" or "neck"',
        source="trade: strands are shown around a bust; the ellipse is **(ours)**",
    )
    label: Name | None = key(
        None,
        "What the row is, for people who read the file.",
        allowed=NAME,
        left_out="no label",
        source="trade: masters above, goods below",
    )
