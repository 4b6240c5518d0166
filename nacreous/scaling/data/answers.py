"""Answers of people: who saw which two things, and which one was chosen."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field, replace
from os import PathLike
from typing import Any, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.column import Grouping
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.entrance import fields_of
from nacreous.scaling.data.fault import listed, nearest, quoted
from nacreous.scaling.data.header import name_of
from nacreous.scaling.data.label import check_visible
from nacreous.scaling.data.pairs import codes_of_pairs
from nacreous.scaling.data.roles import Names, check_names, wanted_of
from nacreous.scaling.data.table import read_table, table_of
from nacreous.unchanging import ReadOnlyMapping, released
from nacreous.value import value_class


@value_class
class Answers:
    """One row an answer. Made by `read`, `of_table` or `of_pairs`, which check everything.

    - `stimuli`: labels in natural order ("2" before "10"), or as given
    - `left`, `right`: int64 [answer], indices into `stimuli`
    - `outcome`: int8 [answer]: 1 left chosen, -1 right chosen, 0 a tie
    - `people`, `person`: labels of people and int64 [answer], an index into them; () and None
      where unknown
    - `groups`: every other column by name, a `Grouping` of `levels` and `code` [answer]
    - `response_s`: float64 [answer], seconds until the answer, NaN where empty; or None
    - `time`: float64 [answer], when or in which order (column time, else trial or order); or None
    - `sided`: left and right are places before the eye, and not only an order of listing
    - `left_out`: how many rows of the table are no answers, such as those of instructions;
      `unanswered`: how many of them show a pair
    - `uncounted`: how many further rows are answers that do not count, by why: `question` (another
      one), `practice`, `catch`, `marked` (as excluded), and of studies `excluded`, `simulated`,
      `people`
    - `encoding_guessed`: as which a file was read that does not say how its letters are written

    >>> answers = Answers.of_pairs([("a", "b"), ("a", "c"), ("c", "b")])
    >>> answers
    Answers(3 answers, 3 stimuli, people unknown)
    """

    stimuli: tuple[str, ...]
    left: NDArray[np.int64]
    right: NDArray[np.int64]
    outcome: NDArray[np.int8]
    people: tuple[str, ...] = ()
    person: NDArray[np.int64] | None = None
    groups: Mapping[str, Grouping] = field(default_factory=lambda: ReadOnlyMapping({}))
    response_s: NDArray[np.float64] | None = None
    time: NDArray[np.float64] | None = None
    sided: bool = True
    left_out: int = 0
    unanswered: int = 0
    uncounted: Mapping[str, int] = field(default_factory=lambda: ReadOnlyMapping({}))
    encoding_guessed: str | None = None

    def __post_init__(self) -> None:
        """Refuse labels of stimuli and people with characters that a terminal would obey."""
        check_visible(self.stimuli, "stimuli")
        check_visible(self.people, "people")

    @classmethod
    def read(
        cls,
        path: str | PathLike[str],
        *,
        stimuli: Iterable[object] | None = None,
        repeats: bool = False,
        sided: bool = True,
        skip_unanswered: bool = False,
        skip_rows: int = 0,
        encoding: str | None = None,
        question: str | None = None,
        **names: Unpack[Names],
    ) -> Answers:
        r"""Read answers from a table as text (.csv, .tsv, .txt) or a .parquet file.

        Columns, which `names` may call otherwise (`left="first"`): `left`, `right` and `chosen`,
        or `winner` and `loser`. `chosen` holds the label of either, or left, right or tie
        (`tie="equal"`, `left_word="f"`, `right_word="j"` for other words). `person`, `time`,
        `trial` (or `order`), `response_s` or `response_ms` are used where they are; `count` (or
        `freq`) says how many answers a row stands for. Every other column is a group.
        docs/answers.md has what else is read, such as files of PsychoPy, jsPsych and Qualtrics.
        `stimuli` gives the labels in an order of your own, and allows no
        others.

        A text file is UTF-8, UTF-16 or Shift-JIS, or in the `encoding` of that name; its first
        `skip_rows` rows are left out. So are rows without a pair, and with `skip_unanswered` those
        without an answer.

        A table whose column `question` holds several is refused unless one is chosen by `question`.
        Rows that are marked as practice, catch trials or excluded do not count (docs/answers.md).

        An answer given twice is refused: the same person, left and right, with the same time and
        trial where there are such columns; without people, rows that are the same in every column,
        a time among them. `repeats=True` takes them all.

        Raises `InputError` with a line for each of the first problems: file, row (a CSV file's
        header is row 1) and column. At most 1 GiB and 100 000 000 answers.

        >>> from pathlib import Path
        >>> from tempfile import TemporaryDirectory
        >>> with TemporaryDirectory() as folder:
        ...     path = Path(folder, "answers.csv")
        ...     _ = path.write_text("person,left,right,chosen\nmika,a,b,b\nmika,b,a,tie\n")
        ...     Answers.read(path)
        Answers(2 answers, 2 stimuli, 1 person)
        """
        names = check_names(names)
        table = read_table(path, wanted_of(names), skip_rows=skip_rows, encoding=encoding)
        fields = fields_of(
            table,
            names,
            stimuli=stimuli,
            repeats=repeats,
            sided=sided,
            skip_unanswered=skip_unanswered,
            question=question,
        )
        return cls(**fields)

    @classmethod
    def of_table(
        cls,
        table: Any,
        *,
        stimuli: Iterable[object] | None = None,
        repeats: bool = False,
        sided: bool = True,
        skip_unanswered: bool = False,
        question: str | None = None,
        **names: Unpack[Names],
    ) -> Answers:
        """The answers in a pandas, Polars or pyarrow table, a dict of columns, or a list of rows.

        As `read`; rows are counted from 0. A row of a list is a dict, as `csv.DictReader` makes.

        >>> Answers.of_table([{"winner": "a", "loser": "b"}, {"winner": "b", "loser": "c"}])
        Answers(2 answers, 3 stimuli, people unknown)

        >>> Answers.of_table({"left": ["a"], "right": ["b"]})
        Traceback (most recent call last):
        nacreous.problem.InputError: table: has no column chosen; columns here: "left", "right"; ...
        """
        fields = fields_of(
            table_of(table),
            check_names(names),
            stimuli=stimuli,
            repeats=repeats,
            sided=sided,
            skip_unanswered=skip_unanswered,
            question=question,
        )
        return cls(**fields)

    @classmethod
    def of_pairs(cls, pairs: Any, *, stimuli: Iterable[object] | None = None) -> Answers:
        """Answers as (winner, loser), each a label or a whole number; or an array [answer, 2].

        Whole numbers become labels: 0 is the stimulus "0". The first of a pair is no left, so the
        answers are not `sided`.

        >>> Answers.of_pairs([(0, 1), (1, 2)]).stimuli
        ('0', '1', '2')
        """
        labels, codes = codes_of_pairs(pairs, stimuli)
        outcome = np.ones(len(codes), np.int8)
        return cls(labels, codes[:, 0].copy(), codes[:, 1].copy(), outcome, sided=False)

    def __len__(self) -> int:
        """How many answers there are."""
        return len(self.left)

    def __repr__(self) -> str:
        """In one line how much is here."""
        count = len(self.people)
        people = f"{count} {'person' if count == 1 else 'people'}" if count else "people unknown"
        return f"Answers({len(self)} answers, {len(self.stimuli)} stimuli, {people})"

    def comparisons(self) -> Comparisons:
        """The answers counted by pair.

        >>> Answers.of_pairs([("a", "b"), ("b", "a"), ("a", "b")]).comparisons().matrix
        array([[0., 2.],
               [1., 0.]])
        """
        found = Comparisons.of_outcomes(
            self.stimuli, self.left, self.right, self.outcome, self.sided
        )
        return replace(found, encoding_guessed=self.encoding_guessed)

    def take(self, rows: ArrayLike) -> Answers:
        """The answers of some rows (a mask, or positions), with the same stimuli and people."""
        chosen = np.asarray(rows)

        def part(column: Any) -> Any:
            return None if column is None else released(column[chosen])

        groups = {
            name: replace(group, code=released(group.code[chosen]))
            for name, group in self.groups.items()
        }
        return replace(
            self,
            left=part(self.left),
            right=part(self.right),
            outcome=part(self.outcome),
            person=part(self.person),
            groups=groups,
            response_s=part(self.response_s),
            time=part(self.time),
        )

    def decided(self) -> Answers:
        """The answers with a choice, without the ties.

        >>> table = {"left": ["a", "b"], "right": ["b", "a"], "chosen": ["a", "tie"]}
        >>> len(Answers.of_table(table).decided())
        1
        """
        return self if self.outcome.all() else self.take(np.flatnonzero(self.outcome))

    def split(self, column: str) -> dict[str, Answers]:
        """The answers of each group, by a group column or "person"; all keep the same stimuli.

        Answers whose cell is empty belong to none. People keep only those of the group.

        >>> table = {"left": ["a", "b"], "right": ["b", "a"], "chosen": ["a"] * 2}
        >>> table["eye"] = ["L", "R"]
        >>> {name: len(part) for name, part in Answers.of_table(table).split("eye").items()}
        {'L': 1, 'R': 1}
        """
        group = self._group(column)
        parts = {}
        for index, level in enumerate(group.levels):
            rows = np.flatnonzero(group.code == index)
            if len(rows):
                parts[level] = self.take(rows)._with_own_people()
        return parts

    def sizes(self, column: str) -> dict[str, tuple[int, int]]:
        """How many people and answers each part of `split` has; people are 0 where unknown.

        >>> table = {"left": ["a", "b"], "right": ["b", "a"], "chosen": ["a"] * 2}
        >>> Answers.of_table(table | {"person": ["x", "x"], "eye": ["L", "R"]}).sizes("eye")
        {'L': (1, 1), 'R': (1, 1)}
        """
        group = self._group(column)
        found = {}
        for index, level in enumerate(group.levels):
            here = group.code == index
            people = 0 if self.person is None else len(np.unique(self.person[here]))
            if answers := int(here.sum()):
                found[level] = (people, answers)
        return found

    def _group(self, column: str) -> Grouping:
        column = name_of(column)
        if column in self.groups:
            return self.groups[column]
        if column == "person" and self.person is not None:
            return Grouping(self.people, self.person)
        near = nearest(column, self.groups)
        allowed = listed(self.groups) or "none, for the answers have no other columns"
        hint = f"did you mean {near}?" if near else f"allowed: {allowed}"
        raise InputError(f"{quoted(column)} is no group of these answers; {hint}")

    def _with_own_people(self) -> Answers:
        if self.person is None:
            return self
        here = np.bincount(self.person, minlength=len(self.people)) > 0
        place = np.cumsum(here) - 1
        people = tuple(self.people[index] for index in np.flatnonzero(here))
        return replace(self, people=people, person=released(place[self.person]))
