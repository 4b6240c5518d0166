"""Flags from what a person's answers say of each other, by the checks of `nacreous.scaling`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers
from nacreous.study.task.asked import Asked
from nacreous.study.task.flag import RATE, Flag
from nacreous.study.task.pair.chance import at_least, one_sided
from nacreous.study.task.pair.circles import circle_flags
from nacreous.study.task.pair.expected import Shares, expected_shares
from nacreous.study.task.pair.keys import PairKeys
from nacreous.study.task.pair.reading import answers, chosen_of, pair_of, sides_of
from nacreous.study.task.row import Row

__all__ = ["consistency_flags"]


def consistency_flags(rows: Sequence[Row], asked: Asked[PairKeys]) -> dict[int, list[Flag]]:
    """Flags by person's number; rows: data of people who have a number.

    What chance does is known from the scale that the people's answers (or the simulated ones,
    for simulated people) have so far.
    """
    if not rows:
        return {}
    shares = expected_shares(rows, asked)
    circles = circle_flags(rows, asked, shares)
    read = answers(rows, {})
    hasty = _hasty(read)
    lefts = _sides(read)
    by_person: dict[int, list[Row]] = {}
    for row in rows:
        if row["number"] is not None:
            by_person.setdefault(row["number"], []).append(row)
    return {
        number: [
            *_repeats(own, asked, shares),
            *lefts.get(str(number), []),
            *circles.get(number, []),
            *([_fast(own)] if str(number) in hasty else []),
        ]
        for number, own in by_person.items()
    }


def _repeats(rows: Sequence[Row], asked: Asked[PairKeys], shares: Shares) -> Iterator[Flag]:
    """Pairs asked again and answered otherwise, more than people who look would have."""
    index = {label: at for at, label in enumerate(asked.labels)}
    first = {
        (row["question"], pair_of(row)): chosen_of(row) for row in rows if row["kind"] == "pair"
    }
    otherwise, chances = 0, []
    for row in rows:
        before, now = first.get((row["question"], pair_of(row))), chosen_of(row)
        if row["kind"] == "repeat" and before is not None and now is not None:
            left, right = sides_of(row)
            share = float(shares[row["question"], row["simulated"]][index[left], index[right]])
            chances.append(2 * share * (1 - share))
            otherwise += now != before
    if otherwise and at_least(otherwise, chances) <= RATE:
        yield Flag("repeats", f"{otherwise}/{len(chances)}")


def _sides(read: Answers) -> dict[str, list[Flag]]:
    """One side, by person's label."""
    from nacreous.scaling import side_bias

    try:
        shares = side_bias(read).by_person
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


def _hasty(read: Answers) -> frozenset[str]:
    from nacreous.scaling import response_time

    times = response_time(read)
    return frozenset(() if times is None else times.hasty)


def _fast(rows: Sequence[Row]) -> Flag:
    """How many answers came faster than anyone reacts."""
    from nacreous.scaling.check.response import FASTEST_S

    times = [row["response_ms"] for row in rows if row["response_ms"] is not None]
    return Flag("fast", f"{sum(time < 1000 * FASTEST_S for time in times)}/{len(times)}")
