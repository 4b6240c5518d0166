"""Whether a difference scale describes its judgements: deviance, and runs of residuals.

Single judgements have no distribution of deviance that tables hold. The fit itself draws judgements
anew, each is fitted again, and what was found stands among what these give (S. N. Wood, Generalized
Additive Models, 2006; for difference scales Knoblauch and Maloney 2008). Drawn judgements are
simulated, and stand on the model's word that all are independent.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nacreous.number import said, seed_of, whole_of
from nacreous.problem import InputError
from nacreous.scaling.fit.difference import DifferenceScale
from nacreous.scaling.fit.difference_errors import sample_scale
from nacreous.scaling.fit.difference_model import Questions, log_chance
from nacreous.scaling.fit.unit import Model
from nacreous.value import value_class

__all__ = ["DifferenceGoodness", "difference_goodness", "drawn_questions"]

Array = NDArray[np.float64]


@value_class
class DifferenceGoodness:
    """How well a difference scale describes its judgements.

    - `deviance`: -2 times the log likelihood; `deviance_p`: how often simulated judgements have one
      as large
    - `runs`: in how many stretches of one sign the residuals lie, sorted by fitted chance;
      `runs_p`: how often simulated judgements have as few. Few say that the scale goes past the
      judgements over stretches, as with lapses or a wrong order of the stimuli
    - `samples`: how many were simulated; `without_maximum`: how many of them had no scale of their
      own
    """

    deviance: float
    deviance_p: float
    runs: int
    runs_p: float
    samples: int
    without_maximum: int

    def __str__(self) -> str:
        """In one line."""
        return (
            f"deviance {self.deviance:.1f} (p {self.deviance_p:.3f}), {self.runs} runs of residuals"
            f" (p {self.runs_p:.3f}); p by {self.samples} simulated sets of judgements"
        )


def difference_goodness(
    fit: DifferenceScale, samples: int = 400, seed: int = 1
) -> DifferenceGoodness:
    """Deviance and runs of residuals of a fit, with p values by simulation.

    samples: 20 to 100 000; same seed, same p values. Both p are one-sided, and never below 1 in
    samples + 1. Both are too large rather than too small: of 100 simulated studies that follow the
    model 1 had runs_p up to 0.05 and none deviance_p.

    >>> from nacreous.scaling import difference_scale, simulate_quadruples
    >>> fit = difference_scale(simulate_quadruples([0, 1, 2, 4, 6], people=20, seed=1))
    >>> difference_goodness(fit, samples=50).runs_p > 0.02
    True
    """
    drawn = drawn_questions(fit, samples, seed)
    asked, design = fit.questions, fit.questions.design
    deviance, runs = _deviance_and_runs(design @ fit.scale, asked, fit.model)
    worse, fewer, unplaced, count = 0, 0, 0, 0
    for one in drawn:
        values, ended = sample_scale(fit, design[:, 1:], one.counts())
        found = _deviance_and_runs(design[:, 1:] @ values, one, fit.model)
        worse, fewer = worse + (found[0] >= deviance), fewer + (found[1] <= runs)
        unplaced, count = unplaced + (not ended), count + 1
    return DifferenceGoodness(
        deviance=deviance,
        deviance_p=(worse + 1) / (count + 1),
        runs=runs,
        runs_p=(fewer + 1) / (count + 1),
        samples=count,
        without_maximum=unplaced,
    )


def drawn_questions(fit: DifferenceScale, samples: int, seed: int) -> Iterator[Questions]:
    """Judgements of the same questions, in the same order, drawn from the fit: simulated ones."""
    if not isinstance(fit, DifferenceScale):
        raise InputError(f"fit is {said(fit)}; allowed: what difference_scale gives")
    count, random = whole_of("samples", samples, 20, 100_000), np.random.default_rng(seed_of(seed))
    asked = fit.questions
    chance = np.exp(log_chance(asked.design @ fit.scale, fit.model))[asked.question]
    return (replace(asked, upper=random.random(len(chance)) < chance) for _ in range(count))


def _deviance_and_runs(lead: Array, answered: Questions, model: Model) -> tuple[float, int]:
    """Of judgements at leads [question]; equal leads stay in the order of judging.

    A residual has the sign of its judgement.
    """
    own, upper = lead[answered.question], answered.upper
    deviance = -2 * float(log_chance(np.where(upper, own, -own), model).sum())
    signs = upper[np.argsort(own, kind="stable")]
    return deviance, 1 + int(np.count_nonzero(signs[1:] != signs[:-1]))
