"""Words that set keys of a pearl file, as in `--word luster=Excellent`."""

from __future__ import annotations

from collections.abc import Iterable

from nacreous.problem import InputError
from nacreous.spec.complaint import shown
from nacreous.spec.override import Worded, once
from nacreous.trade.table import factor_of, factors, word_named
from nacreous.trade.word import Factor

__all__ = ["overrides_of", "with_words"]


def with_words(words: Iterable[str], settings: Iterable[str]) -> list[str]:
    """What `--word` and `--set` say, as `key=value`; where both set a key, the latter counts.

    Raises `InputError` as `overrides_of`, for two words that set the same key, and for a key that
    is set twice.

    >>> with_words(["luster=fair"], ["shininess=0.5"])
    ['surface.facet_spread_rad=0.116', 'shininess=0.253', 'shininess=0.5']
    """
    said: dict[str, str] = {}
    lines: list[str] = []
    for word in words:
        for key, value in overrides_of(word):
            if key in said:
                raise InputError(
                    f"--word {shown(word)}: sets {key}, as {shown(said[key])} does; "
                    "allowed: one word for a key"
                )
            said[key] = word
            lines.append(Worded(f"{key}={value}", word))
    return [*lines, *once(settings)]


def overrides_of(setting: str) -> list[tuple[str, str]]:
    """The keys that `factor=word` sets, with their values as `--set` takes them.

    Raises `InputError` for a factor or a word that is not in the table, with what was probably
    meant, and for a factor that no key of a pearl file has yet.

    >>> overrides_of("luster=excellent")
    [('surface.facet_spread_rad', '0.018'), ('shininess', '0.866')]
    >>> overrides_of("size=7.0-7.5 mm")
    [('diameter_mm', '7.25')]
    """
    name, equals, word = setting.partition("=")
    if not (name.strip() and equals):
        raise InputError(f"--word {shown(setting)}: wanted: factor=word, such as luster=Excellent")
    try:
        factor = factor_of(name.strip())
        if not _sets(factor):
            settable = ", ".join(one.name for one in factors() if _sets(one))
            raise InputError(f"{factor.name} sets no key of a pearl file; allowed: {settable}")
        ranges = word_named(factor.name, word).ranges
    except InputError as problem:
        raise InputError(f"--word {shown(setting)}: {problem}") from None
    return [(one.key, f"{one.sets:g}") for one in ranges if one.key]


def _sets(factor: Factor) -> bool:
    return any(one.key for word in factor.words for one in word.ranges)
