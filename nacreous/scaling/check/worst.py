"""The pairs that stray farthest from a fit, in the cells of its test."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from nacreous.scaling.check.cells import Cells

if TYPE_CHECKING:
    from nacreous.scaling.fit.scale import Scale

__all__ = ["Misfit", "worst_of"]

#: More are not read.
MOST = 3


class Misfit(NamedTuple):
    """A pair that fits badly: what was answered, and what the fit expects.

    - `first`, `second`: labels; the first was chosen more often than expected, or as often
    - `observed`, `expected`: share that chose the first. Where the fit has ties as answers of their
      own, of those who chose one, NaN where nobody did; elsewhere of all, a tie counting half
    - `residual`: the difference in standard deviations, 0 or more
    - `ties`: share of ties; `ties_expected`, `tie_residual`: what the fit expects, and the
      difference in standard deviations, positive for too many; None where ties are no answers of
      their own
    - `answers`: how many there are
    - `left`: label that stood left in them; None for fits without an order effect, which take both
      ways round together
    """

    first: str
    second: str
    observed: float
    expected: float
    residual: float
    ties: float
    ties_expected: float | None = None
    tie_residual: float | None = None
    answers: float = 0.0
    left: str | None = None

    @property
    def by_ties(self) -> bool:
        """Whether ties stray farther than choices."""
        return self.tie_residual is not None and abs(self.tie_residual) > self.residual

    def __str__(self) -> str:
        """The pair, how often it was called equal if that is the misfit, and what stood left."""
        said = f"{self.first}-{self.second}"
        if self.left is not None:
            said += f" with {self.left} left"
        if not self.by_ties or self.ties_expected is None:
            return said
        called, expected = self.ties * self.answers, self.ties_expected * self.answers
        return (
            f"{said}: called equal in {called:g} of {self.answers:g}; "
            f"the scale expects {expected:.{0 if expected >= 1 else 1}f}"
        )


def worst_of(fit: Scale, cells: Cells) -> tuple[Misfit, ...]:
    """Up to three pairs, the largest share of X2 first; with an order effect, pairs one way round.

    At least one; others only where they stray at all.
    """
    counts, sided = fit.comparisons, fit.order_effect is not None
    ties = counts.ties if sided else counts.tie_matrix[cells.first, cells.second]
    strayed = cells.residuals**2 + cells.tie_residuals**2
    rows = np.argsort(-strayed, kind="stable")[:MOST]
    return tuple(
        _misfit(cells, int(row), float(ties[row]), sided)
        for row in rows
        if row == rows[0] or strayed[row] > 0
    )


def _misfit(cells: Cells, row: int, ties: float, sided: bool) -> Misfit:
    total, residual = float(cells.total[row]), float(cells.residuals[row])
    at = [int(cells.first[row]), int(cells.second[row])]
    left = cells.stimuli[at[0]] if sided else None
    order = [0, 1] if residual >= 0 else [1, 0]
    observed, expected = (
        _share(counts[row, order[0]], counts[row, order[1]])
        for counts in (cells.observed, cells.expected)
    )
    fitted = cells.outcomes > 2
    return Misfit(
        first=cells.stimuli[at[order[0]]],
        second=cells.stimuli[at[order[1]]],
        observed=observed,
        expected=expected,
        residual=abs(residual),
        ties=ties / total,
        ties_expected=float(cells.expected[row, 2] / total) if fitted else None,
        tie_residual=float(cells.tie_residuals[row]) if fitted else None,
        answers=total,
        left=left,
    )


def _share(chosen: float, passed: float) -> float:
    return float(chosen / (chosen + passed)) if chosen + passed > 0 else float("nan")
