"""What a column `chosen` means: labels, words for the sides, or the codes of programs."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.buttons import are_buttons, refuse_buttons_as_labels
from nacreous.scaling.data.column import check_labels, codes_of, text_column
from nacreous.scaling.data.fault import Faults, listed, quoted
from nacreous.scaling.data.likeness import number_of
from nacreous.scaling.data.nothing import NOTHING, refuse_errors
from nacreous.scaling.data.roles import WORDS, Names
from nacreous.scaling.data.table import Table
from nacreous.scaling.data.truth import TIED

_LEFT, _RIGHT, _TIE, _UNKNOWN = -2, -3, -4, -5

#: Words for the sides and for neither, in small letters: as people and keyboards say them.
SIDES = {
    **dict.fromkeys(("left", "l", "arrowleft", "{leftarrow}", "左"), _LEFT),
    **dict.fromkeys(("right", "r", "arrowright", "{rightarrow}", "右"), _RIGHT),
    **dict.fromkeys(TIED, _TIE),
}
#: What words of other languages, and numbers of keys, probably mean; only guessed at, in messages.
_GUESSES = {
    "left_word": {"links", "gauche", "izquierda", "sinistra", "esquerda", "first", "erste", "37"},
    "right_word": {"rechts", "droite", "derecha", "destra", "direita", "second", "zweite", "39"},
    "tie": {
        *("equal", "same", "=", "gleich", "égal", "igual", "uguale", "both", "neither"),
        *("no difference", "unentschieden", "égalité", "empate", "同じ", "差なし"),
    },
}
_EITHER = (("yes", "no"), ("true", "false"), ("y", "n"), ("f", "j"))
_CODE = re.compile(r"\+?(-?[0-2])(?:\.0*)?")
#: A list of one name several times: one thing was clicked again.
_SAME = re.compile(r"""\[\s*('[^']*'|"[^"]*")(?:\s*,\s*\1)+\s*\]""")
#: A list of one, as PsychoPy writes keys and clicked names.
_LIST = re.compile(r"""\[\s*(?:'([^']*)'|"([^"]*)"|([^\[\],'"]*))\s*\]""")


def unlisted(cell: str) -> str:
    """The one thing in a list of one, or of the same again; any other text as it is.

    >>> unlisted("['left']"), unlisted("['left', 'left']")
    ('left', 'left')
    """
    several = _SAME.fullmatch(cell)
    cell = f"[{several[1]}]" if several else cell
    one = _LIST.fullmatch(cell)
    return next(part for part in one.groups() if part is not None) if one else cell


def is_unanswered(cell: str | None, labels: frozenset[str], names: Names) -> bool:
    """Whether a cell of `chosen` says that nobody answered.

    The words for nothing count only where no stimulus bears them as its name.
    """
    words = {names.get("tie"), names.get("left_word"), names.get("right_word")}
    if cell is None:
        return True
    return cell not in labels and cell not in words and unlisted(cell).lower() in {*NOTHING, ""}


def outcomes_of(
    table: Table,
    name: str,
    names: Names,
    labels: tuple[str, ...],
    left: NDArray[np.int64],
    right: NDArray[np.int64],
    faults: Faults,
) -> NDArray[np.int8]:
    """1 where the left one was chosen, -1 the right one, 0 neither.

    Words and codes count only where no stimulus bears them as its name.
    """
    text = text_column(table, name)
    check_labels(table, name, text, faults)
    faults.stop()
    found, code = codes_of(text)
    said: Any = names
    refuse_errors(name, found, code, faults, {*labels, *(said.get(role) for role in WORDS)})
    faults.stop()
    _check_given(name, names, found, labels, faults)
    meanings = _meanings(table, name, names, found, labels, (code, left, right), faults)
    faults.stop()
    meaning = np.array(meanings, np.int64)[code]
    outcome = np.zeros(table.rows, np.int8)
    is_left, is_right = (
        (meaning == left) | (meaning == _LEFT),
        (meaning == right) | (meaning == _RIGHT),
    )
    outcome[is_left], outcome[is_right] = 1, -1
    unknown = [cell for cell, each in zip(found, meanings, strict=True) if each == _UNKNOWN]

    def allowed(row: int) -> str:
        pair = f"{quoted(labels[left[row]])} or {quoted(labels[right[row]])}"
        return f"allowed: {pair}, left, right or {names.get('tie', 'tie')}"

    faults.say_of_rows(
        np.flatnonzero(~(is_left | is_right | (meaning == _TIE) | (meaning == _UNKNOWN))),
        lambda row: f"{name} is {quoted(found[code[row]])}; {allowed(row)}",
    )
    holds = "holds" if len(unknown) > 1 else "is"
    faults.say_of_column(
        np.flatnonzero(meaning == _UNKNOWN),
        lambda row: f"{name} {holds} {listed(unknown)}; {allowed(row)}, or {_named(unknown)}",
    )
    return outcome


def _check_given(
    name: str, names: Names, found: tuple[str, ...], labels: tuple[str, ...], faults: Faults
) -> None:
    """Note words for the sides and ties that could have no effect."""
    said: Any = names
    sides = {role: str(said[role]) for role in ("left_word", "right_word") if role in said}
    given = sides | ({"tie": names["tie"]} if names.get("tie", "tie") != "tie" else {})
    for role, word in given.items():
        if word in labels or _same_number(word, labels):
            faults.say(f"{role}={word!r} is the label of a stimulus; allowed: another word")
    held = {each for cell in found for each in (cell, unlisted(cell))}
    held |= {word for word in sides.values() if _same_number(word, held)}
    if sides and not held & set(sides.values()):
        words = " and ".join(f"{role}={word!r}" for role, word in sides.items())
        faults.say(f"{words} is given; allowed: words in {name}, which holds {listed(found)}")


def _named(cells: list[str]) -> str:
    """The arguments that say what words mean, guessed where a word is common, to be filled in."""
    words = list(dict.fromkeys(map(unlisted, cells)))
    for pair in _EITHER:
        here = {word.casefold(): word for word in words}
        if here.keys() <= {*pair}:
            one, other = (here.get(word, word) for word in pair)
            return f"left_word={one!r}, right_word={other!r} or the other way round"
    guess = {
        role: word for word in words for role, known in _GUESSES.items() if word.casefold() in known
    }
    given = [f"{role}={guess[role]!r}" for role in WORDS if role in guess]
    return ", ".join(given or ["left_word=WORD, right_word=WORD, tie=WORD"])


def _same_number(word: str, cells: Iterable[str]) -> bool:
    """Whether a word is a number and one of the cells the same one, as 1 and 1.0 are."""
    number = number_of(word)
    return number is not None and any(number == number_of(cell) for cell in cells)


def _meanings(
    table: Table,
    name: str,
    names: Names,
    found: tuple[str, ...],
    labels: tuple[str, ...],
    shown: tuple[NDArray[np.int64], ...],
    faults: Faults,
) -> list[int]:
    """For each value an index into labels, a side, a tie, or that it means nothing.

    shown: for each row its value, and indices into labels of the left and the right one.
    """
    known = _known(names, labels)
    named = {label.casefold() for label in labels}
    words = {word: side for word, side in SIDES.items() if word not in named}
    numbers = {number: known[word] for word in known if (number := number_of(word))}
    meanings = [_meaning(cell, known, numbers, words) for cell in found]
    refuse_buttons_as_labels(table, name, found, meanings, shown, faults)
    codes = {
        cell: code[1].replace("-0", "0")
        for cell, meaning in zip(found, meanings, strict=True)
        if meaning == _UNKNOWN and (code := _CODE.fullmatch(unlisted(cell)))
    }
    if not codes or "left_word" in names or "right_word" in names:
        return meanings
    grades = {
        unlisted(cell): float(number)
        for cell, meaning in zip(found, meanings, strict=True)
        if meaning == _UNKNOWN and (number := number_of(unlisted(cell)))
    }
    if len(grades) > len(codes):
        held = _both(sorted(grades, key=lambda cell: grades[cell]))
        faults.say(
            f"{name} holds {held}, as grades do; allowed: the "
            "label of the chosen one, or left, right or tie, in place of each grade"
        )
        return meanings
    buttons = are_buttons(table, np.isin(shown[0], [found.index(cell) for cell in codes]))
    sides = _sides_of(set(codes.values()), buttons)
    if sides is None:
        faults.say(f"{name} holds {_asked(set(codes.values()), buttons)}")
        return meanings
    numbered = _number_in(codes, found, labels, shown)
    if numbered and not buttons:
        faults.say(
            f"{name} holds {_both(sorted(codes.values()))}, which may be sides or stimuli such as "
            f"{quoted(numbered)}; allowed: labels, left and right, or left_word='1', right_word='2'"
        )
        return meanings
    return [
        sides[codes[cell]] if cell in codes else meaning
        for cell, meaning in zip(found, meanings, strict=True)
    ]


def _known(names: Names, labels: tuple[str, ...]) -> dict[str, int]:
    """What given words and labels mean; labels come last, and count more."""
    words = {
        names.get("left_word"): _LEFT,
        names.get("right_word"): _RIGHT,
        names.get("tie", "tie"): _TIE,
    }
    known = {word: meaning for word, meaning in words.items() if word is not None}
    return known | {label: index for index, label in enumerate(labels)}


def _meaning(
    cell: str, known: dict[str, int], numbers: dict[str, int], words: dict[str, int]
) -> int:
    """An index into labels, a side or a tie; numbers are compared as numbers, 1.0 with 1.

    words: in small letters, those that are no label in letters of any size.
    """
    for each in dict.fromkeys((cell, unlisted(cell))):
        if each in known:
            return known[each]
        number = number_of(each)
        if number is not None and number in numbers:
            return numbers[number]
        if each.casefold() in words:
            return words[each.casefold()]
    return _UNKNOWN


def _number_in(
    codes: dict[str, str],
    found: tuple[str, ...],
    labels: tuple[str, ...],
    shown: tuple[NDArray[np.int64], ...],
) -> str | None:
    """A stimulus that a code may name, where in each row with a code there is just one.

    `1` may be 01, 1.png or pearl 1, unless a pair without such a one has been answered by it.
    """
    numbers = [{str(int(each)) for each in re.findall("[0-9]+", label)} for label in labels]
    code, left, right = shown
    _, first = np.unique((code * len(labels) + left) * len(labels) + right, return_index=True)
    answered = [
        (found[code[row]], left[row], right[row]) for row in first if found[code[row]] in codes
    ]
    meant: list[int] = []
    for cell, *pair in answered:
        sides = [side for side in pair if codes[cell] in numbers[side]]
        if len(sides) != 1:
            return None
        meant += sides
    return labels[min(meant)]


def _asked(codes: set[str], buttons: bool) -> str:
    """That numbers may mean either side, and the words that would say which."""
    held = sorted(codes, key=int)
    low, high = (
        ("0", "2")
        if codes == {"0", "2"}
        else ("1", "2")
        if "2" in codes
        else ("-1", "1")
        if "-1" in codes
        else ("1", "0")
    )
    tie = ", tie='0'" if "0" in codes and "0" not in (low, high) else ""
    if "2" in codes and "-1" in codes:
        low, high, tie = "WORD", "WORD", ", tie=WORD"
    elif buttons and "2" in codes:
        low, high, tie = "0", "1", ", tie='2'"
    such = f"left_word={low!r}, right_word={high!r}{tie}"
    return (
        f"{_both(held)}, and either side may be meant; allowed: labels, left and right, or the "
        f"word for each side, such as {such}"
    )


def _both(codes: list[str]) -> str:
    held = list(dict.fromkeys(codes))
    return " and ".join((", ".join(held[:-1]), held[-1]) if held[1:] else held)


def _sides_of(codes: set[str], buttons: bool) -> dict[str, int] | None:
    """The sides that numbers stand for: the first and second, or buttons from 0."""
    if codes == {"1", "2"} and not buttons:
        return {"1": _LEFT, "2": _RIGHT}
    return {"0": _LEFT, "1": _RIGHT} if codes <= {"0", "1"} and buttons else None
