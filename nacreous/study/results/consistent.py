"""Flags from what a person's answers say of each other, by the checks of `nacreous.scaling`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers
from nacreous.study.design import Design
from nacreous.study.results.chance import at_least, one_sided
from nacreous.study.results.circles import circle_flags
from nacreous.study.results.expected import Shares, expected_shares
from nacreous.study.results.flag import RATE, Flag
from nacreous.study.results.rows import Row, answers_from, chosen_of

__all__ = ["consistency_flags"]


def consistency_flags(rows: Sequence[Row], design: Design) -> dict[int, list[Flag]]:
    """Flags by person's number; rows: answers to pairs and repeats, as `Store.answers` gives them.

    What chance does is known from the scale that the people's answers (or the simulated ones,
    for simulated people) have so far.
    """
    if not rows:
        return {}
    shares = expected_shares(rows, design)
    circles = circle_flags(rows, design, shares)
    answers = answers_from(rows)
    hasty = _hasty(answers)
    lefts = _sides(answers)
    by_person: dict[int, list[Row]] = {}
    for row in rows:
        by_person.setdefault(row["number"], []).append(row)
    return {
        number: [
            *_repeats(own, design, shares),
            *lefts.get(str(number), []),
            *circles.get(number, []),
            *([_fast(own)] if str(number) in hasty else []),
        ]
        for number, own in by_person.items()
    }


def _repeats(rows: Sequence[Row], design: Design, shares: Shares) -> Iterator[Flag]:
    """Pairs asked again and answered otherwise, more than people who look would have."""
    index = {label: at for at, label in enumerate(design.labels)}
    first = {
        (row["question"], frozenset((row["left"], row["right"]))): chosen_of(row)
        for row in rows
        if row["kind"] == "pair"
    }
    otherwise, chances = 0, []
    for row in rows:
        before = first.get((row["question"], frozenset((row["left"], row["right"]))))
        if row["kind"] == "repeat" and before and row["chosen"] != "tie":
            at = index[row["left"]], index[row["right"]]
            share = float(shares[row["question"], row["simulated"]][at])
            chances.append(2 * share * (1 - share))
            otherwise += chosen_of(row) != before
    if otherwise and at_least(otherwise, chances) <= RATE:
        yield Flag("repeats", f"{otherwise}/{len(chances)}")


def _sides(answers: Answers) -> dict[str, list[Flag]]:
    """One side, by person's label."""
    from nacreous.scaling import side_bias

    try:
        shares = side_bias(answers).by_person
    except InputError:  # ties alone
        return {}
    found = {}
    for person, share in shares.items():
        lefts, total = int(share.count), int(share.total)
        if one_sided(lefts, total) <= RATE:
            left = 2 * lefts > total
            detail = f"{lefts if left else total - lefts}/{total}"
            found[person] = [Flag("left" if left else "right", detail)]
    return found


def _hasty(answers: Answers) -> frozenset[str]:
    from nacreous.scaling import response_time

    times = response_time(answers)
    return frozenset(() if times is None else times.hasty)


def _fast(rows: Sequence[Row]) -> Flag:
    """How many answers came faster than anyone reacts."""
    from nacreous.scaling.check.response import FASTEST_S

    times = [row["response_ms"] for row in rows if row["response_ms"] is not None]
    return Flag("fast", f"{sum(time < 1000 * FASTEST_S for time in times)}/{len(times)}")
