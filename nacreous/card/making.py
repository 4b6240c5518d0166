"""How cards are made again, and what a pearl's file says beyond defaults."""

from __future__ import annotations

import shlex
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from nacreous.problem import InputError
from nacreous.stream import STREAM

if TYPE_CHECKING:
    from nacreous.card.card import Card
    from nacreous.spec import Pearl

__all__ = ["command", "own_keys"]

_SIZE, _SAMPLES = 512, 16


def command(cards: Sequence[Card], language: str, output: str) -> str | None:
    """The command that makes the page again; None where a pearl or the scene has no file.

    Raises `InputError` where there is no card.
    """
    if not cards:
        raise InputError("there is no card; wanted: at least one")
    first = cards[0]
    nowhere = (None, STREAM)
    if first.scene in nowhere or any(card.given in nowhere for card in cards):
        return None
    words = ["nacreous", "card", *(str(card.given) for card in cards)]
    words += ["--scene", str(first.scene)]
    if first.culture is not None:
        words += ["--type", first.culture]
    if language != "en":
        words += ["--language", language]
    if first.size != _SIZE:
        words += ["--size", str(first.size)]
    if first.samples != _SAMPLES:
        words += ["--samples", str(first.samples)]
    return shlex.join([*words, "-o", output])


def own_keys(pearl: Pearl) -> list[str]:
    """The keys of a pearl that are not at their defaults, each as key = value.

    >>> from nacreous.spec import Pearl
    >>> own_keys(Pearl(depth=0.7, body={"nacre_mm": 0.5}))
    ['depth = 0.7', 'body.nacre_mm = 0.5']
    """
    given = pearl.model_dump(mode="json", exclude_defaults=True, exclude_none=True)
    return [f"{path} = {_shown(value)}" for path, value in _flat(given, "")]


def _flat(table: Mapping[str, object], prefix: str) -> Iterator[tuple[str, object]]:
    for key, value in table.items():
        if isinstance(value, Mapping):
            yield from _flat(value, f"{prefix}{key}.")
        else:
            yield prefix + key, value


def _shown(value: object) -> str:
    if isinstance(value, list) and len(value) > 4:
        return f"[{value[0]}, ..., {value[-1]}]"
    return f'"{value}"' if isinstance(value, str) else str(value)
