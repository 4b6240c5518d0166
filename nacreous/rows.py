"""Which pearl each place of a scene's rows names."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import count
from typing import NamedTuple

from nacreous.problem import InputError
from nacreous.spec import Pearl, Scene
from nacreous.spec.row import GIVEN

__all__ = ["Filled", "fill"]


class Filled(NamedTuple):
    """The pearls of a picture, each different one once, and the scene that names them by number.

    scene: with "*0", "*1" and so on for the pearls, so that pearls and scene alone, with no preset
    and no other file, make the same picture again.
    """

    pearls: list[Pearl]
    scene: Scene


def fill(given: Sequence[Pearl], scene: Scene) -> Filled:
    """Put the pearls given into the scene's rows.

    Each "*" takes the next of them, beginning again after the last; "*2" takes the third; a name
    is loaded. A scene without rows keeps what is given. Raises `InputError` for a place without a
    pearl and for pearls without a place.

    >>> from nacreous.spec import Row
    >>> rows = [Row(pearls=["akoya-rg", "*"]), Row(pearls=["*", "*"])]
    >>> filled = fill([Pearl(), Pearl(depth=0.1)], Scene(rows=rows))
    >>> [pearl.name for pearl in filled.pearls], [row.pearls for row in filled.scene.rows]
    (['akoya-rg', 'pearl', 'pearl'], [('*0', '*1'), ('*2', '*1')])
    """
    if not scene.rows:
        return Filled(list(given), scene)
    rows = _pearls(given, scene)
    numbers: dict[Pearl, int] = {}
    for pearl in (pearl for row in rows for pearl in row):
        numbers.setdefault(pearl, len(numbers))
    named = [
        written.replace(pearls=tuple(f"{GIVEN}{numbers[pearl]}" for pearl in row))
        for row, written in zip(rows, scene.rows, strict=True)
    ]
    return Filled(list(numbers), scene.replace(rows=tuple(named)))


def _pearls(given: Sequence[Pearl], scene: Scene) -> list[list[Pearl]]:
    """The pearls of each row."""
    names = [name for row in scene.rows for name in row.pearls]
    numbered = {int(name[1:]) for name in names if name.startswith(GIVEN) and name != GIVEN}
    if numbered and max(numbered) >= len(given):
        raise InputError(
            f'scene {scene.name}: a row has "{GIVEN}{max(numbered)}"; allowed: '
            f'"{GIVEN}0" to "{GIVEN}{len(given) - 1}", for {len(given)} given'
        )
    turns = names.count(GIVEN)
    idle = set(range(len(given))) - numbered - set(range(turns))
    if idle:
        raise InputError(
            f"scene {scene.name}: {len(given)} pearls given, {len(idle)} of them without a place; "
            f'its rows have {turns} "{GIVEN}"'
        )
    loaded: dict[str, Pearl] = {}
    turn = count()

    def pearl(name: str) -> Pearl:
        if name == GIVEN:
            return given[next(turn) % len(given)]
        if name.startswith(GIVEN):
            return given[int(name[1:])]
        if name not in loaded:
            loaded[name] = Pearl.load(name)
        return loaded[name]

    return [[pearl(name) for name in row.pearls] for row in scene.rows]
