"""Rankings of people: who saw which things together, and in which order they put them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from os import PathLike
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.label import check_visible
from nacreous.scaling.data.long_ranks import RankColumns, trays_of_table
from nacreous.scaling.data.table import read_table, table_of
from nacreous.scaling.data.trays import Trays, trays_of_extremes, trays_of_lists
from nacreous.unchanging import released
from nacreous.value import value_class

__all__ = ["Rankings"]


@value_class
class Rankings:
    """One row a tray. Made by `of_lists`, `of_table`, `read` or `of_best_worst`, which check all.

    - `stimuli`: labels in natural order, or as given
    - `task`: "ranking", or "best-worst" where only the best and the worst of a tray were named
    - `items`: int64 [placed], indices into `stimuli`, tray after tray, the best first; those that
      were not put in order come last, and of best-worst between the best and the worst
    - `sizes`: int64 [tray], how many stimuli lay on it; `ordered`: int64 [tray], how many of them
      were put in order; all but one are all
    - `people`, `person`: labels of people and int64 [tray], an index into them; () and None where
      unknown

    >>> Rankings.of_lists([["a", "c", "b"], ["c", "a"]])
    Rankings(2 trays of 2 to 3, 3 stimuli, people unknown)
    """

    stimuli: tuple[str, ...]
    task: Literal["ranking", "best-worst"]
    items: NDArray[np.int64]
    sizes: NDArray[np.int64]
    ordered: NDArray[np.int64]
    people: tuple[str, ...] = ()
    person: NDArray[np.int64] | None = None

    def __post_init__(self) -> None:
        """Refuse labels of stimuli and people with characters that a terminal would obey."""
        check_visible(self.stimuli, "stimuli")
        check_visible(self.people, "people")

    @classmethod
    def of_lists(
        cls,
        rankings: Iterable[Sequence[object]],
        *,
        shown: Iterable[Sequence[object]] | None = None,
        person: Iterable[object] | None = None,
        stimuli: Iterable[object] | None = None,
    ) -> Rankings:
        """Rankings as lists of labels, or whole numbers, the best first; one list a tray.

        shown: all that lay on each tray, where only the first few were put in order. person: who
        ranked each tray. stimuli: the labels in an order of your own, and no others.

        Raises `InputError` with the row and the column of what is wrong, both counted from 0.

        >>> Rankings.of_lists([["a", "b"]], shown=[["a", "b", "c", "d"]]).ordered
        array([2])
        """
        return _made(cls, "ranking", trays_of_lists(rankings, shown, person, stimuli))

    @classmethod
    def of_best_worst(
        cls,
        answers: Iterable[tuple[Sequence[object], object, object]],
        *,
        person: Iterable[object] | None = None,
        stimuli: Iterable[object] | None = None,
    ) -> Rankings:
        """The best and the worst of each tray: (all that lay there, the best, the worst).

        Further arguments and errors as `of_lists`.

        >>> Rankings.of_best_worst([(["a", "b", "c"], "b", "a"), (["b", "c", "d"], "b", "d")])
        Rankings(2 trays of 3, 4 stimuli, best and worst, people unknown)
        """
        return _made(cls, "best-worst", trays_of_extremes(answers, person, stimuli))

    @classmethod
    def of_table(
        cls, table: Any, *, stimuli: Iterable[object] | None = None, **names: str
    ) -> Rankings:
        """Rankings in a long table: a row for each stimulus on each tray.

        Columns, which `names` may call otherwise (`tray="trial"`): `tray`, `stimulus`, `rank` (1
        the best; empty where it was not put in order) and, where it is there, `person`. Trays of
        one name are one tray only where they are of the same person. table: as for
        `Answers.of_table`.

        Raises `InputError` with row and column of what is wrong, and for two stimuli of one rank:
        Plackett and Luce's model has no ties.

        >>> Rankings.of_table({"tray": [1, 1, 1], "stimulus": list("abc"), "rank": [2, 1, None]})
        Rankings(1 tray of 3, 3 stimuli, people unknown)
        """
        return _made(
            cls, "ranking", trays_of_table(table_of(table), RankColumns.of(names), stimuli)
        )

    @classmethod
    def read(
        cls,
        path: str | PathLike[str],
        *,
        stimuli: Iterable[object] | None = None,
        encoding: str | None = None,
        **names: str,
    ) -> Rankings:
        r"""The same from a table as text (.csv, .tsv, .txt), whose header is row 1, or .parquet.

        >>> from pathlib import Path
        >>> from tempfile import TemporaryDirectory
        >>> with TemporaryDirectory() as folder:
        ...     path = Path(folder, "ranks.csv")
        ...     _ = path.write_text("person,tray,stimulus,rank\nmika,1,a,2\nmika,1,b,1\n")
        ...     Rankings.read(path)
        Rankings(1 tray of 2, 2 stimuli, 1 person)
        """
        columns = RankColumns.of(names)
        table = read_table(path, columns.wanted, encoding=encoding, rows="rows of rankings")
        return _made(cls, "ranking", trays_of_table(table, columns, stimuli))

    def __len__(self) -> int:
        """How many trays there are."""
        return len(self.sizes)

    def __repr__(self) -> str:
        """In one line how much is here."""
        count = len(self.people)
        people = f"{count} {'person' if count == 1 else 'people'}" if count else "people unknown"
        least, most = int(self.sizes.min()), int(self.sizes.max())
        size = f"{most}" if least == most else f"{least} to {most}"
        trays = f"{len(self)} {'tray' if len(self) == 1 else 'trays'} of {size}"
        task = "" if self.task == "ranking" else ", best and worst"
        return f"Rankings({trays}, {len(self.stimuli)} stimuli{task}, {people})"

    @property
    def tray(self) -> NDArray[np.int64]:
        """int64 [placed], which tray each of `items` lay on."""
        return np.repeat(np.arange(len(self)), self.sizes)

    @property
    def starts(self) -> NDArray[np.int64]:
        """int64 [tray], where each tray begins in `items`."""
        return np.cumsum(self.sizes) - self.sizes

    def lists(self) -> list[tuple[str, ...]]:
        """The labels of each tray in the order of `items`.

        >>> Rankings.of_lists([["b", "a"]], shown=[["a", "c", "b"]]).lists()
        [('b', 'a', 'c')]
        """
        labels = [self.stimuli[index] for index in self.items.tolist()]
        starts = self.starts.tolist()
        return [
            tuple(labels[start : start + size])
            for start, size in zip(starts, self.sizes.tolist(), strict=True)
        ]


def _made(kind: type[Rankings], task: Literal["ranking", "best-worst"], trays: Trays) -> Rankings:
    """Equal rankings as equal values: what has no order stands in that of the stimuli."""
    items, sizes = trays.items.copy(), trays.sizes
    ordered = np.where(trays.ordered >= sizes - 1, sizes, trays.ordered)
    if task == "best-worst":
        ordered = np.full(len(sizes), 2)
    starts = np.cumsum(sizes) - sizes
    first = ordered if task == "ranking" else np.ones(len(sizes), np.int64)
    last = sizes if task == "ranking" else sizes - 1
    for begin, end in zip((starts + first).tolist(), (starts + last).tolist(), strict=True):
        items[begin:end] = np.sort(items[begin:end])
    arrays = (released(items), released(sizes), released(ordered))
    return kind(trays.stimuli, task, *arrays, trays.people, trays.person)
