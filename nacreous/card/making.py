"""How cards are made again, and what a pearl's file says beyond defaults."""

from __future__ import annotations

import shlex
from collections.abc import Sequence
from typing import TYPE_CHECKING

from nacreous.problem import InputError
from nacreous.spec.toml import written
from nacreous.stream import STREAM
from nacreous.toml_text import flat

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
    words += [part for word in first.words for part in ("--word", word)]
    words += [part for setting in first.overrides for part in ("--set", setting)]
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
    r"""The keys of a pearl that are not at their defaults, each as key = value.

    >>> from nacreous.spec import Pearl
    >>> own_keys(Pearl(name='my "best"', body={"nacre_mm": 0.5}))
    ['name = "my \\"best\\""', 'body.nacre_mm = 0.5']
    """
    given = pearl.model_dump(mode="json", exclude_defaults=True, exclude_none=True)
    return [f"{path} = {_shown(value)}" for path, value in flat(given)]


def _shown(value: object) -> str:
    if isinstance(value, list) and len(value) > 4:
        return f"[{written(value[0])}, ..., {written(value[-1])}]"
    return written(value)
