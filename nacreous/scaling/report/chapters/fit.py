"""Whether one scale describes the answers, and where it does not."""

from __future__ import annotations

import numpy as np

from nacreous.scaling.figure import matrix_plot
from nacreous.scaling.report.analysis import Analysis
from nacreous.scaling.report.picture import picture
from nacreous.scaling.report.table import facts, table
from nacreous.scaling.report.translation import Html, Words, chance, number, percent

__all__ = ["chapter", "shares"]

MOST_SIDES = 40
#: Share of pairs with few answers beyond which `goodness` decides by Pearson's statistic.
_MOST_SPARSE = 0.2
#: Two maps stand side by side.
_MAP_PT = 256.0


def chapter(analysis: Analysis, words: Words) -> Html:
    """Verdict, largest misfits, the maps, the tests."""
    untold = "few" if analysis.goodness.df else "none"
    good = f"good_{apart}" if (apart := _apart(analysis)) else "good"
    verdict = {None: untold, True: good, False: "bad"}[analysis.goodness.describes]
    hidden = analysis.fit_hidden_by
    key = f"fit.{verdict}" if hidden is None else f"short.fits_{hidden}"
    columns = words.names(analysis.apart_by)
    parts = [words.paragraph(key, ties=percent(analysis.tied), columns=columns)]
    if apart and verdict != good:
        parts.append(words.paragraph(f"fit.differ_{apart}", columns=columns))
    if analysis.goodness.describes is False:
        parts.append(_largest(analysis, words))
    if len(analysis.fit.stimuli) <= MOST_SIDES:
        parts.append(_maps(analysis, words))
    else:
        parts.append(words.paragraph("fit.too_many"))
    if analysis.comparisons.ties.any():
        fitted = analysis.goodness.tie_residuals is not None
        half = words("fit.ties_apart" if fitted else "fit.ties_half")
        parts.append(Html(f'<p class="quiet">{half}</p>\n'))
    if analysis.goodness.describes is not None:
        parts.append(_tests(analysis, words))
    return Html("".join(parts))


def _apart(analysis: Analysis) -> str | None:
    """What does not share the scale: single people, or the parts that columns make."""
    if analysis.single_people_differ:
        return "people"
    return "parts" if analysis.apart_by else None


def shares(analysis: Analysis) -> np.typing.NDArray[np.float64]:
    """[n, n], the share of answers that chose i over j, a tie half; NaN where not compared."""
    half = analysis.comparisons.tie_matrix / 2
    wins = analysis.comparisons.matrix + half
    total = wins + wins.T
    return np.divide(wins, total, out=np.full_like(wins, np.nan), where=total > 0)


def _largest(analysis: Analysis, words: Words) -> Html:
    """A row for each of the pairs that stray farthest: by its choices, or by its ties."""
    rows = []
    for worst in analysis.goodness.misfits:
        first, second = words.name(worst.first), words.name(worst.second)
        if worst.by_ties:
            pair = words("fit.equal", first=first, second=second)
            shares = worst.ties, worst.ties_expected
            strayed = worst.tie_residual
        else:
            pair = words("neighbours.over", first=first, second=second)
            shares = worst.observed, worst.expected
            strayed = worst.residual
        if worst.left is not None:
            pair = words("fit.left", pair=pair, left=words.name(worst.left))
        rows.append(
            (
                pair,
                *(percent(share or 0.0) for share in shares),
                number(strayed or 0.0, 1, sign=True),
            )
        )
    fitted = analysis.goodness.tie_residuals is not None
    lead = words.paragraph("fit.largest_ties" if fitted else "fit.largest")
    heads = ["", words("fit.observed"), words("fit.foretold"), words("fit.residual")]
    return Html(lead + table(heads, rows, ["", "n", "n", "n"]))


def _maps(analysis: Analysis, words: Words) -> Html:
    ends = {"first": analysis.ranking[0], "last": analysis.ranking[-1]}
    stimuli, order = analysis.fit.stimuli, analysis.order
    observed = picture(
        lambda path, width: matrix_plot(
            shares(analysis), stimuli, path, order=order, width_pt=width
        ),
        "shares",
        words.alt("fit.proportions_alt", **ends),
        words("fit.proportions_caption"),
        _MAP_PT,
    )
    residuals, tied = analysis.goodness.residuals, analysis.goodness.tie_residuals
    missed = _missed(analysis, words, "residuals", residuals)
    pair = Html(f'<div class="pair">{observed}{missed}</div>\n')
    if tied is None:
        return pair
    return Html(
        f'{pair}<div class="pair">{_missed(analysis, words, "tie_residuals", tied)}</div>\n'
    )


def _missed(
    analysis: Analysis, words: Words, key: str, values: np.typing.NDArray[np.float64]
) -> Html:
    """A map of misfits."""
    return picture(
        lambda path, width: matrix_plot(
            values,
            analysis.fit.stimuli,
            path,
            kind="residuals",
            order=analysis.order,
            width_pt=width,
        ),
        "misfits" if key == "residuals" else "misfits-of-ties",
        words.alt(f"fit.{key}_alt", first=analysis.ranking[0], last=analysis.ranking[-1]),
        words(f"fit.{key}_caption"),
        _MAP_PT,
    )


def _tests(analysis: Analysis, words: Words) -> Html:
    good = analysis.goodness
    rows = [("G2", "statistic", good.g2, good.g2_p_value)]
    rows += [("X2", "statistic_x", good.x2, good.x2_p_value)]
    if good.mosteller is not None:
        rows += [("mosteller", "statistic_x", good.mosteller, good.mosteller_p_value)]
    items = [
        (
            words(f"fit.{name}"),
            words(
                f"fit.{form}",
                value=number(value),
                df=words.count("freedom", good.df),
                p=words.equals(chance(p)),
            ),
        )
        for name, form, value, p in rows
        if p is not None
    ]
    said = f'<p class="quiet">{words("fit.tests")}</p>\n' + facts(items)
    if good.sparse > _MOST_SPARSE:
        said += f'<p class="quiet">{words("fit.sparse")}</p>\n'
    return Html(said)
