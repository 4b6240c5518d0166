"""Overrides: single keys set from outside the file, as in `--set nacre.seed=9`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from nacreous import toml_text
from nacreous.problem import InputError
from nacreous.spec.complaint import shown

#: A key with dots and the text of its value; from Python also the value itself.
Override = tuple[str, Any]
#: What Python may give in place of a list of them: a dict, or `key=value` as in `--set`.
Overrides = Mapping[str, Any] | str | Iterable[Override | str]


class Worded(str):
    """The text of a value that a word of the trade sets, for messages to name that word.

    word: as `--word` has it, "surface=clean".
    """

    word: str
    __slots__ = ("word",)

    def __new__(cls, text: str, word: str) -> Worded:
        """The text, and its word."""
        made = super().__new__(cls, text)
        made.word = word
        return made


def parse(setting: str) -> tuple[str, str]:
    """Split `key=value`; the value keeps the word that it is from.

    >>> parse("nacre.seed=9")
    ('nacre.seed', '9')
    """
    key, equals, value = setting.partition("=")
    if not (key.strip() and equals):
        raise InputError(f"--set {shown(setting)}: wanted: key=value, such as nacre.seed=9")
    text = value.strip()
    return key.strip(), Worded(text, setting.word) if isinstance(setting, Worded) else text


def once(settings: Iterable[str]) -> list[str]:
    """The settings `key=value`, of which no two set the same key. Raises `InputError`.

    >>> once(["depth=0.7", "depth=0.8"])
    Traceback (most recent call last):
    nacreous.problem.InputError: --set "depth=0.8": sets depth, as "depth=0.7" does; allowed: once
    """
    said: dict[str, str] = {}
    for setting in settings:
        key = parse(setting)[0]
        if key in said:
            raise InputError(
                f"--set {shown(setting)}: sets {key}, as {shown(said[key])} does; allowed: once"
            )
        said[key] = setting
    return list(said.values())


def value_of(text: str) -> Any:
    """The TOML value that the text spells; text that is no TOML stands for itself.

    >>> value_of("9"), value_of("[1.5, 2]"), value_of("akoya-r"), value_of("#f3ede4")
    (9, [1.5, 2], 'akoya-r', '#f3ede4')
    """
    if "\n" in text:
        return text
    try:
        return toml_text.loads(f"value = {text}")["value"]
    except ValueError:
        return text


def pairs_of(overrides: Overrides) -> Iterator[Override]:
    """Overrides as pairs, in whichever form they were given.

    >>> forms = [{"depth": 0.7}, "depth=0.7", ["depth=0.7"], [("depth", "0.7")]]
    >>> [list(pairs_of(form)) for form in forms]
    [[('depth', 0.7)], [('depth', '0.7')], [('depth', '0.7')], [('depth', '0.7')]]
    """
    if isinstance(overrides, Mapping):
        overrides = list(overrides.items())
    if not isinstance(overrides, Iterable) or isinstance(overrides, bytes):
        raise _no_override(overrides)
    for given in [overrides] if isinstance(overrides, str) else overrides:
        if isinstance(given, str) and "=" in given:
            yield parse(given)
        elif isinstance(given, tuple | list) and len(given) == 2 and isinstance(given[0], str):
            yield given[0], given[1]
        else:
            raise _no_override(given)


def _no_override(given: object) -> InputError:
    wanted = 'pairs such as [("depth", 0.7)], {"depth": 0.7} or "depth=0.7"'
    return InputError(f"overrides: {shown(given)} is none; wanted: {wanted}")


def apply(values: dict[str, Any], overrides: Overrides) -> dict[str, str]:
    """Set each key in `values` and give back the keys that were set, with what set each.

    >>> scene = {"lamps": [{"intensity": 1.0}]}
    >>> sorted(apply(scene, [("lamps.0.intensity", "2.5"), ("table.kind", "cloth")]))
    ['lamps.0.intensity', 'table.kind']
    >>> apply({}, [("depth", Worded("0.5", "luster=Fair"))])
    {'depth': '--word "luster=Fair"'}
    >>> scene
    {'lamps': [{'intensity': 2.5}], 'table': {'kind': 'cloth'}}
    """
    done: dict[str, str] = {}
    problems: list[str] = []
    for key, value in pairs_of(overrides):
        try:
            _set(values, key, value_of(str(value)) if isinstance(value, str) else value)
            is_word = isinstance(value, Worded)
            done[key] = f"--word {shown(value.word)}" if is_word else "--set"
        except InputError as problem:
            problems.append(str(problem))
    if problems:
        raise InputError("\n".join(problems))
    return done


def _set(values: dict[str, Any], key: str, value: Any) -> None:
    *steps, last = key.split(".")
    if not all((*steps, last)):
        raise InputError(f"--set {shown(key)}: a part of the key is empty")
    target: Any = values
    for depth, step in enumerate(steps):
        if isinstance(target, dict):
            target = target.setdefault(step, {})
        else:
            target = target[_index(target, step, key, ".".join(steps[:depth]))]
    if isinstance(target, dict):
        target[last] = value
    else:
        target[_index(target, last, key, ".".join(steps))] = value


def _index(target: Any, step: str, key: str, path: str) -> int:
    """The place in a list, counted from 0."""
    if not isinstance(target, list):
        problem = f"{path} is not a table"
    elif not target:
        problem = f"{path} is an empty list; there is no entry to change"
    elif not (step.isdecimal() and int(step[:9]) < len(target)):
        problem = f"{path} is a list; allowed: {path}.0 to {path}.{len(target) - 1}"
    else:
        return int(step)
    raise InputError(f"--set {shown(key)}: {problem}")
