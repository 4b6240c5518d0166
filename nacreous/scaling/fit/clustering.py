"""People as clusters: errors that let the answers of one person hang together, however few people.

A sandwich with people as clusters (Liang and Zeger 1986) is too small with few of them, for the fit
has followed each of them a little. CR2 takes that back: each person's score is multiplied so that,
if the model held, its spread would be what it is before fitting (Bell and McCaffrey 2002). The
variance so found is a sum of squares of a few people, and its degrees of freedom are those of
Satterthwaite by the same working model. If all C people answered the same pairs, that is the t test
with C - 1.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nacreous._core import PairModel, PersonalAnswers
from nacreous.problem import InputError
from nacreous.scaling.data.comparisons import Comparisons
from nacreous.scaling.data.fault import quoted
from nacreous.scaling.fit.existence import pair_model
from nacreous.value import value_class

if TYPE_CHECKING:
    from nacreous.scaling.data.answers import Answers

Array = NDArray[np.float64]

#: With fewer people nothing tells how others would differ: an interval of 2 is 10 units wide.
LEAST_PEOPLE = 3
#: People times parameters cubed up to which each person's own correction is worked out (a second).
#: Beyond, all get the one of equal designs.
_MOST_WORK = 2e9
#: People whose corrections are worked out at a time.
_PEOPLE = 64
#: A person whose answers leave less than this of a direction alone decides it.
_ALONE = 1e-7
INSTEAD = 'kind="expected" or counts, which take answers as independent'


@value_class
class Clusters:
    """How far each person moved the parameters of a fit.

    influence  float64 [person, parameter]; its squares sum to the covariance
    equal      whether all get the correction of equal designs; then the rest is empty
    lever      float64 [person, parameter, parameter]: a contrast of parameters to its working
               residual's weights; seen: float64 likewise, each person's expected information
    spread     float64 [parameter, parameter], the inverse of the whole expected information
    """

    influence: Array
    equal: bool
    lever: Array
    seen: Array
    spread: Array

    @property
    def covariance(self) -> Array:
        """float64 [parameter, parameter]."""
        return np.asarray(self.influence.T @ self.influence)

    def freedom(self, contrasts: Array) -> Array:
        """Degrees of freedom of the variance of contrasts [k, parameter], float64 [k].

        Satterthwaite's: with residuals of working covariance P, a person's square each,
        (trace P)^2 / trace P^2.
        """
        people = len(self.influence)
        if self.equal:
            return np.full(len(contrasts), people - 1.0)
        return np.array([self._freedom(contrast) for contrast in contrasts])

    def _freedom(self, contrast: Array) -> float:
        weights = self.lever @ contrast
        shown = np.einsum("cij,cj->ci", self.seen, weights)
        own = np.einsum("ci,ci->c", weights, shown)
        # P = diag(own) - S M S', person by person; its traces from sums of the parameters' size.
        across = np.einsum("ci,ij,cj->c", shown, self.spread, shown, optimize=True)
        small = self.spread @ (shown.T @ shown)
        squares = float(np.sum(own**2) - 2 * np.sum(own * across) + np.sum(small * small.T))
        # A contrast that is 0 whatever the answers, such as of equal rows of a design.
        trace = float(np.sum(own) - np.sum(across))
        return trace**2 / squares if squares > 0 else len(own) - 1.0


def require_people(answers: Answers | None, instead: str = INSTEAD) -> Answers:
    """The answers, if they tell how people differ: each stimulus judged by three of them."""
    least = LEAST_PEOPLE
    if answers is None or answers.person is None:
        raise InputError("it is not known who gave the answers; allowed: answers with people")
    people = len(np.unique(answers.person))
    if people < least:
        whose = "1 person" if people == 1 else f"{people} people"
        raise InputError(
            f"the answers are those of {whose}, who cannot tell how people differ; allowed: "
            f"{least} or more people, or {instead}"
        )
    count = len(answers.stimuli)
    met = (
        np.unique(
            np.concatenate(
                [answers.person * count + answers.left, answers.person * count + answers.right]
            )
        )
        % count
    )
    judges = np.bincount(met, minlength=count)
    if judges.min() < least:
        at = int(np.argmin(judges))
        raise InputError(
            f"{quoted(answers.stimuli[at])} was judged by {judges[at]} of {people} people, too few "
            f"to tell how people differ; allowed: {least} or more a stimulus, or {instead}"
        )
    return answers


def personal(answers: Answers) -> PersonalAnswers:
    """The answers with who gave them, as the compiled room holds them."""
    if answers.person is None:
        raise InputError("it is not known who gave the answers; allowed: answers with people")
    here, person = np.unique(answers.person, return_inverse=True)
    return PersonalAnswers(
        len(answers.stimuli),
        np.ascontiguousarray(answers.left, np.int64),
        np.ascontiguousarray(answers.right, np.int64),
        np.ascontiguousarray(answers.outcome, np.int8),
        np.ascontiguousarray(person, np.int64),
        len(here),
    )


def clusters(
    model: PairModel,
    answers: Answers,
    parameters: Array,
    inverse: tuple[Array, Array],
    like: tuple[str, bool, bool, Array | None],
) -> Clusters:
    """The people behind a fit.

    inverse: of the observed and of the expected information. like: link, ties, order and design of
    the fit, for the expected information of each person.
    """
    observed, expected = inverse
    scores = np.asarray(model.scores(personal(answers), parameters))
    people, size = scores.shape
    scores = scores - scores.mean(axis=0)  # 0 but for a prior, which pulls all people alike
    none = np.zeros((0, size, size))
    alike = not like[2] and _same_pairs(answers, people)
    if alike or people * size**3 > _MOST_WORK:
        influence = scores @ observed * np.sqrt(people / (people - 1))
        return Clusters(influence, True, none, none, expected)
    seen = _information(answers, parameters, like)
    correction = _corrections(seen, expected)
    influence = np.einsum("cij,cj->ci", correction, scores) @ observed
    lever = np.swapaxes(correction, 1, 2) @ observed
    return Clusters(influence, False, lever, seen, expected)


def _same_pairs(answers: Answers, people: int) -> bool:
    """Whether everyone answered the same pairs equally often; the side is no matter."""
    if answers.person is None or len(answers) % people:
        return False
    low, high = np.minimum(answers.left, answers.right), np.maximum(answers.left, answers.right)
    order = np.lexsort((high, low, answers.person))
    rows = [column[order].reshape(people, -1) for column in (answers.person, low, high)]
    own = bool((rows[0] == rows[0][:, :1]).all())
    return own and all(bool((row == row[0]).all()) for row in rows[1:])


def _information(
    answers: Answers, parameters: Array, like: tuple[str, bool, bool, Array | None]
) -> Array:
    """Expected information of each person's answers, [person, parameter, parameter]."""
    link, ties, order, design = like
    person = answers.person if answers.person is not None else np.zeros(len(answers), np.int64)
    found = []
    by_person = np.argsort(person, kind="stable")
    starts = np.unique(person[by_person], return_index=True)[1]
    for rows in np.split(by_person, starts[1:]):
        counts = Comparisons.of_outcomes(
            answers.stimuli,
            answers.left[rows],
            answers.right[rows],
            answers.outcome[rows],
            answers.sided,
        )
        room = pair_model(counts, link, ties, order, None, design)
        found.append(np.asarray(room.information(parameters, True)))
    return np.stack(found)


def _corrections(seen: Array, spread: Array) -> Array:
    """CR2's matrix of each person's score: A (H - H M H) A' = H, for H seen and M spread."""
    values, vectors = np.linalg.eigh(seen)
    values = np.where(values > 1e-10 * values.max(), values, 0.0)
    for start in range(0, len(seen), _PEOPLE):  # all at once would take memory several times over
        some = slice(start, start + _PEOPLE)
        vectors[some] = _corrected(values[some], vectors[some], spread)
    return np.asarray(vectors)


def _corrected(values: Array, vectors: Array, spread: Array) -> Array:
    """The matrices of some people, from the eigenvalues and -vectors of H."""
    root = np.sqrt(values)
    back = np.divide(1.0, root, out=np.zeros_like(root), where=root > 0)
    half = (vectors * root[:, None, :]) @ np.swapaxes(vectors, 1, 2)
    unhalf = (vectors * back[:, None, :]) @ np.swapaxes(vectors, 1, 2)
    left, across = np.linalg.eigh(np.eye(len(spread)) - half @ spread @ half)
    if left.min() < _ALONE:
        raise InputError(
            "the answers of 1 person alone join some stimuli to the others, so that it is not "
            f"known how people differ there; allowed: more people for them, or {INSTEAD}"
        )
    widened = (across / np.sqrt(left)[:, None, :]) @ np.swapaxes(across, 1, 2)
    return np.asarray(half @ widened @ unhalf)
