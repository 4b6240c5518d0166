"""What an answer to a pair means: the only place that reads left, right and tie out of rows."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypedDict, cast

import numpy as np

from nacreous.number import said
from nacreous.printable import printable
from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.label import label_of
from nacreous.study.task.row import Row, Tallied, person_of

if TYPE_CHECKING:
    from nacreous.scaling import Answers
    from nacreous.scaling.report.settings import Settings

__all__ = ["CHOICES", "answers", "chosen_of", "comparisons", "pair_of", "settings", "sides_of"]

CHOICES = ("left", "right", "tie")


class _PairColumns(TypedDict):
    """What the store keeps of a pair: two labels, and "left", "right" or "tie"."""

    left: str
    right: str
    chosen: str


def _columns(row: Row | Tallied) -> _PairColumns:
    return cast("_PairColumns", row)


def sides_of(row: Row | Tallied) -> tuple[str, str]:
    """The labels on the left and on the right, in the form in which labels are compared.

    Stores of earlier versions keep them as their study files wrote them.
    """
    pair = _columns(row)
    return label_of(pair["left"]), label_of(pair["right"])


def pair_of(row: Row | Tallied) -> frozenset[str]:
    """The labels of both, on whichever side."""
    return frozenset(sides_of(row))


def chosen_of(row: Row | Tallied) -> str | None:
    """The label of what was chosen, None for a tie.

    >>> chosen_of({"left": "a", "right": "b", "chosen": "right"})
    'b'
    """
    chosen = _columns(row)["chosen"]
    left, right = sides_of(row)
    return None if chosen == "tie" else left if chosen == "left" else right


def settings(chosen_by: str | None) -> Settings:
    """How a report fits answers to pairs that were chosen so (`Pairs.chosen_by`).

    The most telling ones stretch the most likely scale and want the prior under which they were
    chosen; ones drawn by lot are left without a prior, and bias reduction holds them.

    >>> settings("greedy").prior, settings("drawn").method
    ('hierarchical', 'bias-reduced')
    """
    from nacreous.scaling.report.settings import Settings

    known = {
        None: Settings(),
        "greedy": Settings(prior="hierarchical"),
        "drawn": Settings(method="bias-reduced"),
    }
    if chosen_by not in known:
        raise InputError(f"pairs_chosen_by is {said(chosen_by)}; allowed: greedy, drawn, or empty")
    return known[chosen_by]


def answers(rows: Sequence[Row], groups: Mapping[str, Sequence[str | None]]) -> Answers:
    """Rows as `nacreous.scaling` takes them; groups: by name, a level a row.

    People are named by number, erased ones by their random names. Trials give the order. Labels
    are as they can be shown.
    """
    from nacreous.scaling import Answers

    pairs = [_columns(row) for row in rows]
    table: dict[str, Any] = {
        "left": [printable(pair["left"]) for pair in pairs],
        "right": [printable(pair["right"]) for pair in pairs],
        "chosen": [pair["chosen"] for pair in pairs],
    }
    table["person"] = [person_of(row) for row in rows]
    # An erased person's trials have no numbers any more; their order means nothing.
    table["trial"] = [row["seq"] if row["trial"] is None else row["trial"] for row in rows]
    table["response_ms"] = [row["response_ms"] for row in rows]
    return Answers.of_table({**table, **groups}, repeats=True)


def comparisons(labels: Sequence[str], tally: Iterable[Tallied]) -> dict[str, Comparisons]:
    """The counts of each question that has any, from equal answers counted.

    People's answers alone; a program's where a question has no others, so that a rehearsal goes as
    the study will **(ours)**.

    >>> row = {"question": "q", "left": "a", "right": "b", "chosen": "left", "count": 3}
    >>> comparisons(["a", "b"], [{**row, "simulated": True}])
    {'q': Comparisons(3 answers, 2 stimuli, 1 pair)}
    >>> people = {**row, "chosen": "tie", "count": 1, "simulated": False}
    >>> comparisons(["a", "b"], [{**row, "simulated": True}, people])
    {'q': Comparisons(1 answers, 2 stimuli, 1 pair)}
    """
    by_question: dict[str, list[Tallied]] = {}
    for row in tally:
        by_question.setdefault(row["question"], []).append(row)
    return {question: _counted(labels, rows) for question, rows in by_question.items()}


def _counted(labels: Sequence[str], rows: list[Tallied]) -> Comparisons:
    people = [row for row in rows if not row["simulated"]]
    index = {label: place for place, label in enumerate(labels)}
    wins, ties = np.zeros((2, len(labels), len(labels)))
    for row in people or rows:
        left, right = (index[label] for label in sides_of(row))
        chosen = chosen_of(row)
        if chosen is None:
            ties[[left, right], [right, left]] += row["count"]
        else:
            won = index[chosen]
            wins[won, left + right - won] += row["count"]
    return Comparisons.of_counts(wins, ties, [printable(label) for label in labels])
