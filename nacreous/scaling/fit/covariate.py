"""What goes with the differences between people: age, training, any column that is of a person."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import repeat
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nacreous.number import seed_of, whole_of
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.column import Grouping
from nacreous.scaling.data.given import answers_of
from nacreous.scaling.data.person import known_people
from nacreous.scaling.fit.blocks import Array, Blocks, blocks_of
from nacreous.scaling.fit.own_side import OwnSides, drawn_by_side
from nacreous.scaling.fit.own_ties import with_own_ties
from nacreous.scaling.fit.shared import MOST_STIMULI
from nacreous.scaling.fit.uncertainty import holm
from nacreous.value import value_class

__all__ = ["Covariate", "Untested", "person_covariates", "untested_columns"]

#: A number splits people at up to so many places.
_SPLITS = 25
#: In so many parts of a number's range pulls of the side may be distributed in other ways.
_PARTS = 4
#: The smaller part of a split has at least this share of the people.
_LEAST_PART = 0.05
#: People whose column is filled in, below which nothing is tested.
_LEAST_PEOPLE = 6
#: Sums over people dealt at a time: 32 MB of them.
_AT_ONCE = 1 << 22


@value_class
class Covariate:
    """Whether people who differ in a column judge differently.

    - `column`, `people`: its name, and for how many people it is filled in
    - `kind`: "groups", its values as they are, or "number", above against below a split
    - `split`: of a number, the value at which people differ most; the first part is up to it
    - `statistic`, `p_value`: by dealing the column anew to the people; `p_adjusted`: Holm's over
      all columns
    - `side_p_value`, `side_p_adjusted`: the same of how the left side draws people, which is no
      other judging; None where the answers do not tell
    """

    column: str
    people: int
    kind: Literal["groups", "number"]
    split: float | None
    statistic: float
    p_value: float
    p_adjusted: float
    side_p_value: float | None = None
    side_p_adjusted: float | None = None

    def side_differs(self, level: float = 0.95) -> bool:
        """Whether the side draws people who differ in it differently, among all columns."""
        return self.side_p_adjusted is not None and self.side_p_adjusted < 1 - level

    def differs(self, level: float = 0.95) -> bool:
        """Whether people who differ in it judge differently, at a level, among all columns."""
        return self.p_adjusted < 1 - level


@value_class
class Untested:
    """A column of people by which they were not compared.

    `reason`: "few people" where it is filled in for fewer than 6, "few apart" where numbers split
    off fewer than 2 people or 5 %, "many values" where it is text with more than half as many
    values as people, "no numbers" where `cells` stand beside numbers, "unclear marks" where 1,250
    may be a thousand or a decimal.
    """

    column: str
    reason: Literal["few people", "few apart", "many values", "no numbers", "unclear marks"]
    cells: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class _Sorted:
    """People sorted by a column: their indices, where parts end, and the values there."""

    kind: Literal["groups", "number"]
    people: NDArray[np.int64]
    ends: NDArray[np.int64]
    values: tuple[float, ...]

    def parts(self, people: int) -> NDArray[np.int64]:
        """The part of each of all the people, by value; of a number 4 or fewer in its order.

        Whoever has no value is in a part of their own.
        """
        ends = self.ends
        if self.kind == "number":
            ends = ends[np.unique(np.linspace(0, len(ends) - 1, _PARTS + 1).astype(np.int64)[1:-1])]
        found = np.full(people, len(ends) + 1, np.int64)
        found[self.people] = np.searchsorted(ends, np.arange(len(self.people)), side="right")
        return np.unique(found, return_inverse=True)[1]


def person_covariates(
    answers: Any, permutations: int = 999, seed: int = 1
) -> tuple[Covariate, ...]:
    """Test every column that says one thing about each person: () where there is none.

    answers: `Answers`, or a file, table or list of them as `thurstone` takes; no counts.
    A person's slopes against the shares of all people, at the person's own width of ties and pull
    of the side, are summed over the people of each group;
    the statistic is the sum over groups of S' M^-1 S (people / people of the group), with M from
    how far the slopes vary between people. A column of three or more different numbers takes the
    largest such statistic of up to 25 splits in two. The column is dealt anew to the people,
    splits and all, so that choosing the largest costs nothing in honesty. Columns with more than
    half as many values as people, unless numbers, say nothing and are left out
    (`untested_columns` says which, and why).

    permutations: 99 to 1 000 000. Raises `InputError` where people are unknown.

    >>> import nacreous as nc
    >>> person_covariates(nc.scaling.simulate([1.0, 0.0, -1.0], people=40))
    ()
    """
    whole_of("permutations", permutations, 99, 1_000_000)
    seed = seed_of(seed)
    answers = answers_of(answers)
    blocks = with_own_ties(blocks_of(answers))
    columns = dict(_columns(answers)) if len(blocks.stimuli) <= MOST_STIMULI else {}
    found = {name: each for name, each in columns.items() if isinstance(each, _Sorted)}
    if not found:
        return ()
    sides = OwnSides.of(blocks)
    slopes = _slopes(blocks)
    tested = []
    for column in found.values():
        if sides is not None:
            slopes = _slopes(sides.held(column.parts(len(blocks.people))))
        tested.append(_tested(slopes, column, permutations, seed))
    adjusted = holm(np.array([p_value for _, p_value, _ in tested])).tolist()
    by_side: Iterable[tuple[float, float] | tuple[None, None]] = repeat((None, None))
    if sides is not None:
        by_side = _by_side(drawn_by_side(blocks), list(found.values()), permutations, seed)
    return tuple(
        Covariate(name, len(column.people), column.kind, split, statistic, p_value, both, *side)
        for (name, column), (statistic, p_value, split), both, side in zip(
            found.items(), tested, adjusted, by_side, strict=False
        )
    )


def _by_side(
    drawn: Array, columns: list[_Sorted], permutations: int, seed: int
) -> Iterable[tuple[float, float]]:
    """For each column, p values of how the side draws people, alone and among all columns."""
    slopes = (drawn / max(float(np.sqrt((drawn**2).sum())), 1e-300))[:, None]
    found = [_tested(slopes, column, permutations, seed)[1] for column in columns]
    return zip(found, holm(np.array(found)).tolist(), strict=True)


def untested_columns(answers: Any) -> tuple[Untested, ...]:
    """The columns of people that `person_covariates` leaves out; none in which all are alike.

    >>> import nacreous as nc
    >>> untested_columns(nc.scaling.simulate([1.0, 0.0, -1.0], people=40))
    ()
    """
    answers = answers_of(answers)
    return tuple(each for _, each in _columns(answers) if isinstance(each, Untested))


def _columns(answers: Answers) -> Iterator[tuple[str, _Sorted | Untested]]:
    """Columns that are of a person, with people sorted by them, or why they cannot be.

    A person's empty cells say nothing against what the others hold.
    """
    here, person = np.unique(known_people(answers), return_inverse=True)
    for name, column in answers.groups.items():
        own = np.full(len(here), -1, np.int64)
        filled = column.code >= 0
        own[person[filled]] = column.code[filled]
        if not np.array_equal(own[person[filled]], column.code[filled]):
            continue  # of the answer, not of the person
        known = np.flatnonzero(own >= 0)
        used, code = np.unique(own[known], return_inverse=True)
        if len(used) < 2:
            continue
        numbers = column.numbers(used)
        if len(known) < _LEAST_PEOPLE:
            yield name, Untested(name, "few people")
        elif numbers is not None and len(used) > 2:
            sorted_ = _by_number(known, numbers[code])
            yield name, Untested(name, "few apart") if sorted_ is None else sorted_
        elif len(used) <= len(known) / 2:
            order = np.argsort(code, kind="stable")
            ends = np.cumsum(np.bincount(code))
            yield name, _Sorted("groups", known[order], ends, ())
        else:
            yield name, _unsorted(name, column, used)


def _unsorted(name: str, column: Grouping, used: NDArray[np.int64]) -> Untested:
    """That there are nearly as many values as people, or what keeps them from being numbers."""
    others = [column.levels[at] for at in used if column.numbers([at]) is None]
    if len(others) > len(used) / 2:
        marks = all(re.fullmatch("[0-9]{1,3}([.,][0-9]{3})*", column.levels[at]) for at in used)
        return Untested(name, "unclear marks" if marks else "many values")
    return Untested(name, "no numbers", tuple(others))


def _by_number(known: NDArray[np.int64], value: Array) -> _Sorted | None:
    order = np.argsort(value, kind="stable")
    value, count = value[order], len(value)
    least = max(2, int(np.ceil(_LEAST_PART * count)))
    ends = np.flatnonzero(np.diff(value)) + 1
    ends = ends[(ends >= least) & (ends <= count - least)]
    if len(ends) == 0:
        return None
    ends = ends[np.unique(np.linspace(0, len(ends) - 1, _SPLITS).round().astype(np.int64))]
    return _Sorted("number", known[order], ends, tuple(value[ends - 1].tolist()))


def _slopes(blocks: Blocks) -> Array:
    """Each person's slopes in units of their errors, float64 [person, r]."""
    people, stimuli = len(blocks.people), len(blocks.stimuli)
    found = np.zeros(people * stimuli)
    for side, sign in ((blocks.first, 1.0), (blocks.second, -1.0)):
        cell = blocks.person * stimuli + side[blocks.pair]
        found += sign * np.bincount(cell, blocks.residual, people * stimuli)
    return np.asarray(found.reshape(people, stimuli) @ blocks.metric())


def _tested(
    slopes: Array, column: _Sorted, permutations: int, seed: int
) -> tuple[float, float, float | None]:
    """Statistic, p value, and the split of a number."""
    own = slopes[column.people] - slopes[column.people].mean(axis=0)
    # Half what people of one scale would vary by, half what these people do, so that few people
    # do not make a metric in which every difference is as large as any other (ours).
    values, vectors = np.linalg.eigh((own.T @ own + np.eye(own.shape[1])) / 2)
    own = own @ (vectors / np.sqrt(values))
    true = _parts(own[None], column)[0]
    random = np.random.default_rng(seed)
    at_once = max(1, _AT_ONCE // own.size)
    as_far = 0
    for start in range(0, permutations, at_once):
        count = min(at_once, permutations - start)
        dealt = np.argsort(random.random((count, len(own))), axis=1)
        as_far += int((_parts(own[dealt], column).max(axis=1) >= true.max() * (1 - 1e-9)).sum())
    split = column.values[int(true.argmax())] if column.kind == "number" else None
    return float(true.max()), (1 + as_far) / (1 + permutations), split


def _parts(own: Array, column: _Sorted) -> Array:
    """Statistic of each split of a number, or the one of groups, float64 [deal, split]."""
    count = own.shape[1]
    sums = np.cumsum(own, axis=1)[:, column.ends - 1]
    if column.kind == "number":
        below = column.ends
        return np.asarray((sums**2).sum(axis=2) * count / (below * (count - below)))
    sizes = np.diff(column.ends, prepend=0)
    groups = np.diff(sums, axis=1, prepend=0.0)
    return np.asarray(((groups**2).sum(axis=2) * (1 / sizes)).sum(axis=1, keepdims=True))
