"""Which columns of a wide table are pairs, and whether it is certain what each pair is."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from nacreous.scaling.data.column import text_column
from nacreous.scaling.data.fault import Faults, in_one_line, quoted
from nacreous.scaling.data.pair_name import PairName, is_numbered, pairs_in
from nacreous.scaling.data.table import Table

#: The whole of what stands beside a pair where that is its number: `Q1`, `2`, `No. 3`.
_NUMBER = re.compile(
    r"(?:[a-z]{1,3}|question|trial|item|pair|問|設問|質問)?[\s_.]*[0-9]+[.)]?", re.IGNORECASE
)
#: A number before a question, or LimeSurvey's codes of it and its row: `1. `, `q1[SQ001] `.
_NUMBER_BEFORE = re.compile(
    r"(?:(?:q[\s_.]*)?[0-9]+[.):]\s*|[a-z]\w*\[\w+\][.:]?\s+)(?=\S)", re.IGNORECASE
)
#: The end of a question that all left labels begin with: `Choose one. `, `Better - `.
_QUESTION = re.compile(r".*[.,;:!?\-–—/)]\s+", re.DOTALL)
#: What all right labels end with, and is no part of them: `(2)`, `_1`, ` - which one`.
_REPEAT = re.compile(r"\s*[(\[][^()\[\]]+[)\]]$|[._][0-9]+$|\s+[-–—]\s.*$")
_POINT = re.compile(r"[0-9]+\.[0-9]+")
_RENAME = 'names such as "Which? A vs B", "Q1: A vs B", or another label (rename)'


def has_pairs(table: Table) -> bool:
    """Whether columns are called after pairs, such as "A vs B", or Qualtrics says so of them."""
    return any(pairs_in(_text(table, name)) for name in table.columns)


def pairs_of(table: Table, faults: Faults) -> dict[str, PairName]:
    """For each column of a pair what it names; what may mean two things is noted as a fault."""
    named = {name: pairs_in(_text(table, name)) for name in table.columns}
    for name, pairs in named.items():
        if len(pairs) > 1 and text_column(table, name).null_count < table.rows:
            faults.say(
                f"{_column(table, name)} names more than one pair; allowed: one, such as "
                '"A vs B", or no such column (remove it)'
            )
    found = {name: pairs[0] for name, pairs in named.items() if len(pairs) == 1}
    found = _without_numbers(found)
    _refuse_two_ends(table, found, faults)
    _refuse_brackets(table, found, faults)
    faults.stop()
    _refuse_two_questions(table, found, faults)
    faults.stop()
    held = {
        cell for name in found for cell in text_column(table, name).unique().to_pylist() if cell
    }
    _refuse_parts(table, found, held, faults)
    return found


def _text(table: Table, column: str) -> str:
    """What Qualtrics says of a column, or else its name."""
    return table.texts.get(column) or column


def _column(table: Table, name: str) -> str:
    text = table.texts.get(name)
    return f"column {name} ({quoted(in_one_line(text))})" if text else f"column {quoted(name)}"


def _without_numbers(found: dict[str, PairName]) -> dict[str, PairName]:
    """Numbers such as `Q1_` taken from the labels where all left ones have one and no right one."""
    numbered = all(pair.number for pair in found.values())
    if not numbered or any(is_numbered(pair.right) for pair in found.values()):
        return found
    return {name: pair.numbered() for name, pair in found.items()}


def _refuse_two_ends(table: Table, found: Mapping[str, PairName], faults: Faults) -> None:
    """Note a pair between two texts: `pearl: big vs shell: small` may be read in several ways."""
    for name, pair in found.items():
        if pair.within:
            faults.say(
                f"{_column(table, name)} has text before and behind "
                f"{quoted(f'{pair.left} vs {pair.right}')}; allowed: a question before it or "
                'behind it, such as "Which? A vs B"'
            )
            return


def _refuse_brackets(table: Table, found: Mapping[str, PairName], faults: Faults) -> None:
    """Note a pair in brackets with more of them behind it, as LimeSurvey's arrays of two scales."""
    for name, pair in found.items():
        if any(label.count("[") != label.count("]") for label in (pair.left, pair.right)):
            short = re.sub(r"(\])[^\]]*\]?[^\]]*$", r"\1", _text(table, name))
            faults.say(
                f"{_column(table, name)} has brackets beside those of its pair; allowed: one pair "
                f"of them, such as {quoted(short)} (rename)"
            )
            return


def _refuse_two_questions(table: Table, found: Mapping[str, PairName], faults: Faults) -> None:
    """Note columns that ask different things of their pairs; numbers of questions are none."""
    asked: dict[str, list[str]] = {}
    numbers: dict[str, list[str]] = {}
    for name, pair in found.items():
        beside = pair.before or pair.behind
        kind = numbers if _NUMBER.fullmatch(beside) else asked
        kind.setdefault(_plain(beside), []).append(name)
    if any(len(columns) > 1 for columns in numbers.values()):
        asked |= numbers  # numbers of blocks, and not of columns
    elif numbers:
        asked.setdefault("", next(iter(numbers.values())))
    if len(asked) < 2:
        return
    one, other = (columns[0] for columns in list(asked.values())[:2])
    said = [
        quoted(in_one_line(found[name].before or found[name].behind or "nothing"))
        for name in (one, other)
    ]
    faults.say(
        f"{_column(table, one)} and {_column(table, other)} ask different questions, {said[0]} and "
        f"{said[1]}; allowed: one question a table (remove the other's columns), or the same words "
        "beside each pair"
    )


def _plain(question: str) -> str:
    """A question without its number and its marks, in small letters."""
    text = question if _NUMBER.fullmatch(question) else _NUMBER_BEFORE.sub("", question, count=1)
    return " ".join(re.sub(r"[\W_]+", " ", text).casefold().split())


def _refuse_parts(
    table: Table, found: Mapping[str, PairName], held: Iterable[str], faults: Faults
) -> None:
    """Note labels that may be another one with part of a question, or the mark of a repeat.

    A label that stands on the other side too, or in a cell, is one: questions stand before the
    left one, and marks of repeats behind the right one.
    """
    lefts = {pair.left for pair in found.values()}
    rights = {pair.right for pair in found.values()}
    known = {*held} | (lefts & rights)
    question = "" if lefts & known else _shared_question(lefts, rights)
    repeat = "" if rights & known else _shared_repeat(lefts, rights)
    doubtful = []
    for name, pair in found.items():
        for label, shorter in (
            (pair.left, _ending(pair.left, lefts | rights) or pair.left.removeprefix(question)),
            (pair.right, _beginning(pair.right, found) or pair.right.removesuffix(repeat)),
        ):
            if label not in known and shorter != label:
                doubtful.append((name, label, shorter))
    if doubtful:
        name, label, shorter = doubtful[0]
        columns = len({name for name, _, _ in doubtful})
        more = f" ({columns} such columns)" if columns > 1 else ""
        faults.say(
            f"{_column(table, name)} may mean {quoted(shorter)}, or {quoted(label)} as another "
            f"stimulus; allowed: {_RENAME}{more}"
        )


def _ending(label: str, labels: Iterable[str]) -> str | None:
    """Another label with which this one ends, behind a blank or a mark."""
    ends = [each for each in labels if each != label and label.endswith(each)]
    ends = [each for each in ends if not label[-len(each) - 1].isalnum()]
    return max(ends, key=len, default=None)


def _beginning(label: str, found: Mapping[str, PairName]) -> str | None:
    """Another label with which this one begins, before a blank or a mark.

    1 is no part of 1.5, unless a column `A vs 1` shows that pandas numbered its twin.
    """
    labels = {each for pair in found.values() for each in (pair.left, pair.right)}
    starts = [each for each in labels if each != label and label.startswith(each)]
    starts = [each for each in starts if not label[len(each)].isalnum()]
    if _POINT.fullmatch(label):
        lefts = {pair.left for pair in found.values() if pair.right == label}
        pairs = {(pair.left, pair.right) for pair in found.values()}
        starts = [each for each in starts if {(left, each) for left in lefts} <= pairs]
    return max(starts, key=len, default=None)


def _shared_question(lefts: set[str], rights: set[str]) -> str:
    shared = _QUESTION.match(_beginning_of(lefts)) if len(lefts) > 1 else None
    apart = shared and not any(label.startswith(shared[0]) for label in rights)
    return shared[0] if shared and apart else ""


def _shared_repeat(lefts: set[str], rights: set[str]) -> str:
    ending = _beginning_of({label[::-1] for label in rights})[::-1] if len(rights) > 1 else ""
    shared = _REPEAT.search(ending)
    apart = shared and not any(label.endswith(shared[0]) for label in lefts)
    return shared[0] if shared and apart else ""


def _beginning_of(labels: set[str]) -> str:
    """What all of them begin with."""
    first, last = min(labels), max(labels)
    same = next((at for at, each in enumerate(first) if last[at : at + 1] != each), len(first))
    return first[:same]
