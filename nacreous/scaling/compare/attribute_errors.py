"""Errors of attributes' weights, over people and over stimuli at once.

What attributes leave unexplained belongs to a stimulus: all people see it, so it does not average
out over people, and weights that are right for these stimuli alone look sure. People and stimuli
are therefore crossed random effects. To first order a stimulus whose own value is u off the line
moves the weights by M T' J u, J the information of the stimuli's values, T the attributes and
M = (T' J T)^-1; with own values of variance s^2 the weights' covariance is

    V = V_people + s^2 L L'        L = M T' J

V_people a sandwich with people as clusters (infinitely many degrees of freedom where the answers
are all there is), s^2 by the method of moments from the free scale's distances from the line, on
stimuli - terms - 1 degrees of freedom. Both together by Satterthwaite (1946).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.fit.errors import clusters_of, parameter_covariance
from nacreous.scaling.fit.existence import pair_model
from nacreous.scaling.fit.scale import Scale
from nacreous.value import value_class

__all__ = ["WeightErrors", "satterthwaite", "weight_errors"]

Array = NDArray[np.float64]


@value_class
class WeightErrors:
    """Of weights, one a column of the fit's design.

    answers   float64 [term, term], covariance over people, or of the answers where unknown
    freedom   float64 [term], its degrees of freedom
    moved     float64 [term, stimulus], L: how a stimulus off the line moves the weights
    """

    answers: Array
    freedom: Array
    moved: Array

    def crossed(self, unexplained: float | None, rest: int) -> tuple[Array, Array]:
        """Covariance over people and stimuli [term, term], and degrees of freedom [term].

        unexplained: standard deviation of stimuli off the line, taken from `rest` degrees of
        freedom; None leaves the stimuli out, for nothing is known of others than these.
        """
        if unexplained is None:
            return self.answers, self.freedom
        own = unexplained**2 * self.moved @ self.moved.T
        freedom = satterthwaite(np.diag(self.answers), np.diag(own), self.freedom, rest)
        return self.answers + own, freedom


def satterthwaite(people: Array, stimuli: Array, freedom: Array | float, rest: int) -> Array:
    """Degrees of freedom of sums of two variances, known from `freedom` and from `rest`."""
    if rest < 1:
        return np.broadcast_to(np.asarray(freedom, np.float64), people.shape).copy()
    total = people + stimuli
    share = np.divide(stimuli, total, out=np.zeros(len(total)), where=total > 0)
    lost = (1 - share) ** 2 / freedom + share**2 / rest
    found: Array = np.divide(1.0, lost, out=np.full(len(lost), np.inf), where=lost > 0)
    return found


def weight_errors(fit: Scale) -> WeightErrors:
    """The errors of a fit with a design."""
    design = np.zeros((len(fit.stimuli), 0)) if fit.design is None else fit.design
    terms = design.shape[1]
    moved = _moved(fit, design)
    if fit.answers is None or fit.answers.person is None:
        table = parameter_covariance(fit, "expected")[:terms, :terms]
        return WeightErrors(table, np.full(terms, np.inf), moved)
    people = clusters_of(fit)
    freedom = people.freedom(np.eye(terms, len(fit.parameters)))
    return WeightErrors(people.covariance[:terms, :terms], freedom, moved)


def _moved(fit: Scale, design: Array) -> Array:
    """L, [term, stimulus], at the fit."""
    count, terms = design.shape
    extra = len(fit.parameters) - terms  # side and ties
    with_ties = fit.tie_threshold is not None and bool(fit.comparisons.ties.any())
    room = pair_model(fit.comparisons, fit.model, with_ties, fit.order_effect is not None)
    values = np.concatenate([design @ fit.parameters[:terms], fit.parameters[terms:]])
    information = np.asarray(room.information(values, True))
    table = np.zeros((count + extra, terms + extra))
    table[:count, :terms] = design
    table[count:, terms:] = np.eye(extra)
    pull = table.T @ information
    return np.asarray(np.linalg.solve(pull @ table, pull)[:terms, :count])
