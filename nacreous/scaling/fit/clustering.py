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
from nacreous.scaling.fit.blocks import numbered
from nacreous.scaling.fit.existence import pair_model
from nacreous.scaling.fit.judges import INSTEAD
from nacreous.unchanging import released
from nacreous.value import value_class

if TYPE_CHECKING:
    from nacreous.scaling.data.answers import Answers

Array = NDArray[np.float64]

#: People times parameters cubed up to which each person's own correction is worked out (a second).
#: Beyond, all get the one of equal designs.
_MOST_WORK = 2e9
#: Where nobody gave more of the answers to any pair, nobody gets an own correction: a person has
#: H_p <= s H of the information H, they lie within 1 and (1 - s)^-1/2, which is 1.005.
_SMALL_SHARE = 0.01
#: People whose corrections are worked out at a time.
_PEOPLE = 64
#: Numbers of people and contrasts that are held at a time.
_NUMBERS = 1 << 22
#: A person whose answers leave less than this of a direction alone decides it.
_ALONE = 1e-7


@value_class
class Clusters:
    """How far each person moved the parameters of a fit.

    influence  float64 [person, parameter]; its squares sum to the covariance
    degrees    of freedom of every contrast, where all get the correction of equal designs; then the
               rest is empty. None: people have their own
    lever      float64 [person, parameter, parameter]: a contrast of parameters to its working
               residual's weights; seen: float64 likewise, each person's expected information
    spread     float64 [parameter, parameter], the inverse of the whole expected information
    """

    influence: Array
    degrees: float | None
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
        if self.degrees is not None:
            return np.full(len(contrasts), self.degrees)
        at_once = max(1, _NUMBERS // (people * contrasts.shape[1]))
        parts = [contrasts[at : at + at_once] for at in range(0, len(contrasts), at_once)]
        return np.concatenate([np.zeros(0), *map(self._freedom, parts)])

    def _freedom(self, contrasts: Array) -> Array:
        people, size = self.influence.shape
        root = _root(self.spread)
        trace, own_squares = np.zeros(len(contrasts)), np.zeros(len(contrasts))
        # P = diag(own) - S M S', person by person; its traces from sums of the parameters' size.
        shown = np.empty((people, size, len(contrasts)))
        for at in range(people):
            weights = self.lever[at] @ contrasts.T
            seen = self.seen[at] @ weights
            own = np.einsum("ik,ik->k", weights, seen)
            shown[at] = root.T @ seen
            across = np.einsum("ik,ik->k", shown[at], shown[at])
            trace += own - across
            own_squares += own**2 - 2 * own * across
        by_contrast = np.moveaxis(shown, 2, 0)
        small = np.swapaxes(by_contrast, 1, 2) @ by_contrast
        squares = own_squares + np.einsum("kij,kij->k", small, small)
        # A contrast that is 0 whatever the answers, such as of equal rows of a design.
        safe = np.where(squares > 0, squares, 1.0)
        return np.asarray(np.where(squares > 0, trace**2 / safe, people - 1.0))


def _root(spread: Array) -> Array:
    """R with R R' a covariance, which may hold some direction at 0."""
    values, vectors = np.linalg.eigh(spread)
    return np.asarray(vectors * np.sqrt(np.maximum(values, 0.0)))


def personal(answers: Answers) -> PersonalAnswers:
    """The answers with who gave them, as the compiled room holds them."""
    if answers.person is None:
        raise InputError("it is not known who gave the answers; allowed: answers with people")
    here, person = numbered(answers.person, int(answers.person.max(initial=0)) + 1)
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
    scores = np.asarray(model.scores(personal(answers), parameters))
    people, size = scores.shape
    degrees = _common_degrees(answers, people, size, sided=like[2])
    seen = None if degrees is not None else _information(answers, parameters, like)
    return of_scores(scores, inverse, degrees, seen)


def of_scores(
    scores: Array,
    inverse: tuple[Array, Array],
    degrees: float | None,
    seen: Array | None,
    instead: str = INSTEAD,
) -> Clusters:
    """The people behind a fit, by the slopes of each, float64 [person, parameter].

    inverse: of the observed information and of that which a working model expects. degrees: of
    freedom where all get the correction of equal designs; else `seen` is what each person's answers
    are expected to tell, float64 [person, parameter, parameter], and adds up to the whole.
    """
    observed, expected = inverse
    people, size = scores.shape
    scores = scores - scores.mean(axis=0)  # 0 but for a prior, which pulls all people alike
    if degrees is not None or seen is None:
        none = np.zeros((0, size, size))
        influence = scores @ observed * np.sqrt(people / (people - 1))
        return Clusters(influence, degrees, none, none, expected)
    values, vectors = np.linalg.eigh(seen)
    values = np.where(values > 1e-10 * values.max(), values, 0.0)
    influence, lever = np.empty((people, size)), vectors  # in the same place, for it is large
    for start in range(0, people, _PEOPLE):  # all at once would take memory several times over
        some = slice(start, start + _PEOPLE)
        correction = _corrected(values[some], vectors[some], expected, instead)
        influence[some] = np.einsum("cij,cj->ci", correction, scores[some]) @ observed
        lever[some] = np.swapaxes(correction, 1, 2) @ observed
    return Clusters(influence, None, released(lever), released(seen), expected)


def common_degrees(
    person: NDArray[np.int64], question: NDArray[np.int64], people: int, size: int
) -> float | None:
    """Degrees of freedom where all people get one correction; None where each gets their own.

    person, question: int64 [answer], who answered which question, all of which were asked; answers
    to one question are expected to tell alike. size: how many parameters. With a largest share s of
    the answers to a question, no contrast has fewer than 1/s: nobody has more than s of its
    variance, and (sum v)^2 / sum v^2 >= sum v / max v.
    """
    times = np.bincount(question)
    asked = len(times)
    cells, cell = numbered(person * asked + question, (int(person.max()) + 1) * asked)
    each = np.bincount(cell)
    if len(each) == people * asked:
        by_person = each.reshape(people, asked)
        if (by_person == by_person[0]).all():
            return people - 1.0
    largest = float((each / times[cells % asked]).max())
    if largest <= _SMALL_SHARE:
        return min(people - 1.0, 1 / largest - 1)
    return people - 1.0 if too_many(people, size) else None


def _common_degrees(answers: Answers, people: int, size: int, sided: bool) -> float | None:
    """The same for answers to pairs.

    sided: a pair the other way round is another, for the fit has an advantage of the left one.
    """
    count = len(answers.stimuli)
    left, right = answers.left, answers.right
    if not sided:
        left, right = np.minimum(left, right), np.maximum(left, right)
    _, pair = numbered(left * count + right, count**2)
    known = np.zeros(len(answers), np.int64) if answers.person is None else answers.person
    return common_degrees(known, pair, people, size)


def too_many(people: int, size: int) -> bool:
    """Whether so many people get one correction, for each one's own would take too long."""
    return people * size**3 > _MOST_WORK


def _information(
    answers: Answers, parameters: Array, like: tuple[str, bool, bool, Array | None]
) -> Array:
    """Expected information of each person's answers, [person, parameter, parameter].

    It hangs on the pairs that they were asked, not on what they chose: that of one answer to each
    pair, as often as a person was asked it.
    """
    from scipy.sparse import csr_array, vstack

    link, ties, order, design = like
    left, right, count = answers.left, answers.right, len(answers.stimuli)
    if not order:
        left, right = np.minimum(left, right), np.maximum(left, right)
    pairs, row = numbered(left * count + right, count**2)
    once, size = np.ones(1, np.int8), len(parameters)
    told = []
    for pair in pairs:
        one = Comparisons.of_outcomes(
            answers.stimuli, pair[None] // count, pair[None] % count, once, answers.sided
        )
        room = pair_model(one, link, ties, order, None, design)
        found = np.asarray(room.information(parameters, True)).ravel()
        told.append(csr_array(found[None]))  # nearly all zeros
    known = answers.person if answers.person is not None else np.zeros(len(answers), np.int64)
    here, person = numbered(known, int(known.max()) + 1)
    cells, cell = numbered(person * len(pairs) + row, len(here) * len(pairs))
    table = (np.bincount(cell).astype(np.float64), (cells // len(pairs), cells % len(pairs)))
    asked = csr_array(table, (len(here), len(pairs)))
    seen = np.zeros((len(here), size**2))
    each = vstack(told, format="csr")
    for start in range(0, len(here), _PEOPLE):
        some = slice(start, start + _PEOPLE)
        seen[some] = (asked[some] @ each).toarray()
    return seen.reshape(len(here), size, size)


def _corrected(values: Array, vectors: Array, spread: Array, instead: str) -> Array:
    """CR2's matrix of each person's score: A (H - H M H) A' = H, for H seen and M spread.

    values, vectors: of H, the eigenvalues and -vectors.
    """
    root = np.sqrt(values)
    back = np.divide(1.0, root, out=np.zeros_like(root), where=root > 0)
    half = (vectors * root[:, None, :]) @ np.swapaxes(vectors, 1, 2)
    unhalf = (vectors * back[:, None, :]) @ np.swapaxes(vectors, 1, 2)
    left, across = np.linalg.eigh(np.eye(len(spread)) - half @ spread @ half)
    if left.min() < _ALONE:
        raise InputError(
            "the answers of 1 person alone join some stimuli to the others, so that it is not "
            f"known how people differ there; allowed: more people for them, or {instead}"
        )
    widened = (across / np.sqrt(left)[:, None, :]) @ np.swapaxes(across, 1, 2)
    return np.asarray(half @ widened @ unhalf)
