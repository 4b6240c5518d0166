"""The numbers of a report: the scale as a table, everything as JSON, the data as they came."""

from __future__ import annotations

import csv as tables
import io
import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, is_dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nacreous
from nacreous.scaling.check.population import Population
from nacreous.scaling.check.triads import Triads
from nacreous.scaling.data.answers import Answers
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.spreadsheet import as_written
from nacreous.scaling.data.uncounted import REASONS
from nacreous.scaling.report import called
from nacreous.scaling.report.analysis import Analysis
from nacreous.scaling.report.doubt import Pair

__all__ = ["csv", "data_csv", "data_options", "json_text"]

#: What is told of circular triads: those that go round, and not all that beat each other.
_TRIADS = ("circular", "complete", "tied", "most", "zeta", "p_value", "wins", "named")
_ROLES = ("person", "left", "right", "chosen", "time", "response_s")


def csv(analysis: Analysis) -> str:
    """A line for each stimulus, from the top of the scale; inf for an end that is not told."""
    fit, doubt = analysis.fit, analysis.doubt
    wins = analysis.comparisons.matrix
    ties = analysis.comparisons.tie_matrix
    heads = ("place", "stimulus", "scale", "unit", "low", "high", "se", "chosen", "passed", "ties")
    rows = [
        (
            place + 1,
            as_written(fit.stimuli[at]),
            f"{fit.scale[at]:z.6f}",
            fit.unit,
            *(f"{value:z.6f}" for value in (*_ends(analysis)[at], doubt.se[at])),
            *(f"{value:g}" for value in (wins[at].sum(), wins[:, at].sum(), ties[at].sum())),
        )
        for place, at in enumerate(analysis.order)
    ]
    return _table(heads, rows)


def json_text(analysis: Analysis) -> str:
    """Every number of the report; a person's label stands only where the report names it."""
    fit, ends = analysis.fit, _ends(analysis)
    found = {
        "made_by": f"nacreous {nacreous.__version__}",
        "settings": asdict(analysis.settings),
        "reconstructed_from_the_published_table": analysis.example,
        "answers": analysis.comparisons.total,
        "people": None if analysis.answers is None else len(analysis.answers.people),
        "rows_left_out": _left_out(analysis),
        "unit": fit.unit,
        "stimuli": [
            {
                "stimulus": fit.stimuli[at],
                "scale": fit.scale[at],
                "low": ends[at, 0],
                "high": ends[at, 1],
                "se": analysis.doubt.se[at],
                **_called(analysis, fit.stimuli[at]),
            }
            for at in analysis.order
        ],
        "order_effect": fit.order_effect,
        "tie_threshold": fit.tie_threshold,
        "ties_unfitted": analysis.ties_unfitted,
        "log_likelihood": fit.log_likelihood,
        "resampled": {
            "by": analysis.doubt.by,
            "samples": analysis.doubt.samples,
            "without_maximum": analysis.doubt.without_maximum,
        },
        "endless": analysis.doubt.endless,
        "covariance": analysis.doubt.covariance,
        "neighbours": _compared(analysis.neighbours),
        "differences": _compared(analysis.differences),
        "pairs": _pairs(analysis),
        "goodness": analysis.goodness,
        "fit_hidden_by": analysis.fit_hidden_by,
        "consistency": analysis.consistency,
        "one_scale_for_all_people": _people(analysis),
        "groups": _groups(analysis),
        "judged_differently_by": analysis.apart_by,
    }
    return json.dumps(_plain(found), ensure_ascii=False, indent=1, allow_nan=False) + "\n"


def _called(analysis: Analysis, label: str) -> dict[str, Any]:
    """What a table of words calls a thing, where any numbers are known."""
    found = analysis.called.get(label, ())
    return {"words": called.record(found)} if analysis.called else {}


def _ends(analysis: Analysis) -> NDArray[np.float64]:
    """float64 [n, 2], the intervals; without end where the answers put none."""
    gone = analysis.doubt.open_ends(analysis.fit.stimuli)
    return np.where(gone, (-np.inf, np.inf), analysis.doubt.intervals)


def _compared(pairs: tuple[Pair, ...]) -> list[Pair]:
    """Pairs; without an upper end where the answers put none."""
    return [replace(pair, high=np.inf) if pair.endless else pair for pair in pairs]


def _left_out(analysis: Analysis) -> dict[str, int] | None:
    """Rows of the table that are left out, by what they lack or why; None for counts."""
    answers = analysis.answers
    if answers is None:
        return None
    lacking = {"pair": answers.left_out - answers.unanswered, "answer": answers.unanswered}
    return lacking | {reason: answers.uncounted.get(reason, 0) for reason in REASONS}


def _pairs(analysis: Analysis) -> dict[str, Any]:
    return {
        "stimuli": analysis.fit.stimuli,
        "wins": analysis.comparisons.matrix,
        "ties": analysis.comparisons.tie_matrix,
        "fitted_shares": analysis.fit.proportions,
    }


def _people(analysis: Analysis) -> Any:
    """The tests, and what describes the people; of their labels only how many there are."""
    people = analysis.people
    if people is None:
        return None
    found = people.population
    return {
        "test": asdict(people.shared) | {"reversed": len(people.shared.reversed)},
        "differ": people.differ,
        "columns": people.covariates,
        "columns_not_compared": people.untested,
        "described_by": None if found is None else found.kind,
        **_spread(found),
        "candidates": () if found is None else found.candidates,
        "classes_in_own_unit": [
            {
                "share": one.share,
                "people": len(one.people),
                "correlation": one.correlation,
                "scale": dict(zip(found.stimuli, one.scale, strict=True)),
            }
            for one in found.classes
        ]
        if found is not None
        else None,
    }


def _spread(found: Population | None) -> dict[str, Any]:
    """The spread of people's own values with its interval, or why there is none."""
    if found is None or found.kind != "spread":
        reason = "people are not described by a spread"
    elif found.spread is None:
        reason = "larger than these answers can tell"
    else:
        reason = None
    low, high = (None, None) if found is None else (found.spread_low, found.spread_high)
    return {
        "spread_in_own_unit": None if found is None else found.spread,
        "spread_low": low,
        "spread_high": high,
        "spread_untold": reason,
    }


def _groups(analysis: Analysis) -> Any:
    if analysis.groups is None:
        return None
    groups = analysis.groups.found
    left_out = {one.name: one.reason for one in analysis.groups.left_out}
    if groups is None:
        return {"not_compared": left_out}
    return {
        "not_compared": left_out,
        "tests": groups.tests,
        "ways_of_answering": groups.styles,
        "side_untold": groups.side_untold,
        "scales": {name: fit.to(analysis.fit.unit).scale for name, fit in groups.fits.items()},
        "differences_in_own_unit": groups.differences,
    }


def _plain(value: Any) -> Any:
    """What JSON can hold; NaN, which marks pairs never compared, becomes null."""
    if isinstance(value, Triads):
        value = {name: getattr(value, name) for name in _TRIADS}
    if is_dataclass(value) and not isinstance(value, type):
        value = {name: getattr(value, name) for name in value.__dataclass_fields__}
    if isinstance(value, Mapping):
        return {str(key): _plain(each) for key, each in value.items()}
    if hasattr(value, "_asdict"):
        return _plain(value._asdict())
    if isinstance(value, np.ndarray):
        return _plain(value.tolist())
    if isinstance(value, list | tuple):
        return [_plain(each) for each in value]
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, float) and not np.isfinite(value):
        return None
    return value


def data_csv(analysis: Analysis) -> str:
    """The data in the form that `nacreous scale` reads: answers, or a matrix of counts."""
    if analysis.answers is None:
        return _counts_csv(analysis.comparisons)
    return _answers_csv(analysis.answers)


def data_options(analysis: Analysis) -> list[str]:
    """What `nacreous scale` must be told to read `data_csv` as it was meant."""
    answers = analysis.answers
    if answers is None:
        return ["--counts"]
    tie = _tie_word(answers)
    words = [] if tie == "tie" else ["--tie", tie]
    words += [] if answers.sided else ["--no-sides"]
    return words + (["--repeats"] if _repeats(answers) else [])


def _tie_word(answers: Answers) -> str:
    """A word for ties that is no stimulus."""
    word = "tie"
    while word in answers.stimuli:
        word += "-"
    return word


def _repeats(answers: Answers) -> bool:
    """Whether nothing tells some answers apart, so that a reader would ask about them."""
    known = [column for column in (answers.person, answers.time) if column is not None]
    if not known:
        return False
    columns = [answers.left * len(answers.stimuli) + answers.right, *known]
    order = np.lexsort(columns)
    same = np.ones(len(order) - 1, bool)
    for column in columns:
        same &= column[order[1:]] == column[order[:-1]]
    return bool(same.any())


def _counts_csv(counts: Comparisons) -> str:
    rows = [
        (as_written(label), *(f"{count:.12g}" for count in row))
        for label, row in zip(counts.stimuli, counts.matrix.tolist(), strict=True)
    ]
    return _table(("", *map(as_written, counts.stimuli)), rows)


def _answers_csv(answers: Answers) -> str:
    names = [as_written(label) for label in answers.stimuli]
    columns: dict[str, list[Any]] = {}
    if answers.person is not None:
        columns["person"] = _levels(answers.people, answers.person)
    columns["left"] = [names[at] for at in answers.left.tolist()]
    columns["right"] = [names[at] for at in answers.right.tolist()]
    tie = _tie_word(answers)
    columns["chosen"] = [
        left if outcome == 1 else right if outcome == -1 else tie
        for left, right, outcome in zip(
            columns["left"], columns["right"], answers.outcome.tolist(), strict=True
        )
    ]
    if answers.time is not None:
        columns["time"] = [_cell(value) for value in answers.time.tolist()]
    if answers.response_s is not None:
        columns["response_s"] = [_cell(value) for value in answers.response_s.tolist()]
    for name, group in answers.groups.items():
        if name not in _ROLES:
            columns[as_written(name)] = _levels(group.levels, group.code)
    return _table(tuple(columns), zip(*columns.values(), strict=True))


def _levels(labels: Sequence[str], code: NDArray[np.int64]) -> list[str]:
    """A column of labels, empty where the code is below 0."""
    written = [*map(as_written, labels), ""]
    return [written[max(at, -1)] for at in code.tolist()]


def _cell(value: float) -> str:
    return "" if value != value else repr(value)


def _table(heads: Any, rows: Any) -> str:
    text = io.StringIO()
    writer = tables.writer(text, lineterminator="\n")
    writer.writerow(heads)
    writer.writerows(rows)
    return text.getvalue()
