"""What the trade calls stimuli: the table's words for the numbers that they were made from."""

from __future__ import annotations

from collections.abc import Mapping

from nacreous.problem import InputError
from nacreous.scaling.report.called import Called
from nacreous.spec import Pearl
from nacreous.study.design.manifest import Frozen, FrozenStimulus
from nacreous.trade import Word, factors, stated
from nacreous.trade.word import Language

__all__ = ["called", "called_stimuli"]


def called_stimuli(frozen: Frozen) -> dict[str, tuple[Called, ...]]:
    """Words by label, of stimuli that were rendered from a pearl of their own; none of others.

    Of a pearl whose keys this version does not know any more nothing is said.
    """
    found = {stimulus.label: _called(stimulus) for stimulus in frozen.stimuli}
    return {label: each for label, each in found.items() if each}


def _called(stimulus: FrozenStimulus) -> tuple[Called, ...]:
    toml = (stimulus.recipe or {}).get("pearl")
    if toml is None:
        return ()
    try:
        pearl = Pearl.from_toml(toml)
    except InputError:
        return ()
    return tuple(called(one.word, {one.quantity: one.value}) for one in stated(pearl))


def called(word: Word, values: Mapping[str, float]) -> Called:
    """A word of the table for values by quantity, as a report takes it."""
    japanese = next(one.ja for one in factors() if one.name == word.factor)
    ranges = [one for one in word.ranges if one.quantity in values]
    said = [f"{one.quantity} {values[one.quantity]:.3g} {one.unit}".rstrip() for one in ranges]
    bounds = [f"{one.quantity} {one.text}" for one in ranges]

    def sources(language: Language) -> str:
        return "; ".join(dict.fromkeys(one.said_by(language) for one in ranges))

    return Called(
        (word.factor, japanese),
        (word.en, word.ja),
        ", ".join(said),
        ", ".join(bounds),
        (sources("en"), sources("ja")),
    )
