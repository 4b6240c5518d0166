"""Whether judged differences add up: the six-point property."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.check.difference_fit import drawn_questions
from nacreous.scaling.fit.difference import DifferenceScale
from nacreous.value import value_class

__all__ = ["SixPoints", "six_points"]

Array = NDArray[np.float64]
Index = NDArray[np.int64]

#: More tests than this take too long; 30 stimuli in all their quadruples hold so many.
_MOST_TRIPLES = 1_000_000


@value_class
class SixPoints:
    """How often the six-point property was put to the test, and how often it failed.

    Of stimuli a < b < c and d < e < f in order: where (a, b) was judged to differ more than (d, e),
    and (b, c) more than (e, f), then (a, c) has to more than (d, f), if differences add up
    (Maloney and Yang 2003). Noise makes some fail: `expected` is how many do among judgements drawn
    from the fit, and `p` how often as many fail there.
    """

    tested: int
    failed: int
    expected: float
    p: float
    samples: int

    def __str__(self) -> str:
        """In one line."""
        return (
            f"six-point property: {self.failed} of {self.tested} fail, {self.expected:.1f} expected"
            f" (p {self.p:.3f}, {self.samples} simulated)"
        )


def six_points(fit: DifferenceScale, samples: int = 400, seed: int = 1) -> SixPoints:
    """The six-point property of judgements, all people together: each question by its majority.

    samples: 20 to 100 000; same seed, same `expected` and `p`, which is one-sided and never below
    1 in samples + 1. Raises `InputError` where no three questions of the design put it to the test.

    >>> from nacreous.scaling import difference_scale, simulate_quadruples
    >>> truth = [0, 0.3, 0.9, 1.8, 3, 4.5, 6.3]
    >>> found = six_points(difference_scale(simulate_quadruples(truth, people=30, seed=1)), 50)
    >>> found.tested, found.failed
    (7, 0)
    """
    drawn = drawn_questions(fit, samples, seed)
    asked = fit.questions
    triples, turned = _triples(asked.pairs)
    if len(triples) == 0:
        raise InputError(
            "no three questions put the six-point property to the test; allowed: judgements of "
            "(a, b) against (d, e), (b, c) against (e, f), and (a, c) against (d, f)"
        )
    tested, failed = _failures(asked.counts(), triples, turned)
    counts = [_failures(one.counts(), triples, turned)[1] for one in drawn]
    return SixPoints(
        tested=tested,
        failed=failed,
        expected=float(np.mean(counts)),
        p=(1 + sum(one >= failed for one in counts)) / (len(counts) + 1),
        samples=len(counts),
    )


def _triples(pairs: Index) -> tuple[Index, Index]:
    """Questions [triple, 3] that test the property, and the sign [triple, 3] of each one's first.

    pairs: int64 [question, 4].
    """
    first_parts: dict[tuple[int, int], list[tuple[int, int, int, int]]] = {}
    place: dict[tuple[int, int, int, int], tuple[int, int]] = {}
    for at, (a, b, d, e) in enumerate(pairs.tolist()):
        for key, sign in (((a, b, d, e), 1), ((d, e, a, b), -1)):
            place[key] = (at, sign)
            first_parts.setdefault((key[0], key[2]), []).append((key[1], key[3], at, sign))
    found = []
    for at, (a, b, d, e) in enumerate(pairs.tolist()):
        for c, f, second, sign in first_parts.get((b, e), []):
            if (third := place.get((a, c, d, f))) is not None:
                found.append(((at, second, third[0]), (1, sign, third[1])))
            if len(found) > _MOST_TRIPLES:
                raise InputError(
                    f"the judgements hold more than {_MOST_TRIPLES} tests; allowed: fewer"
                )
    both = np.array(found, np.int64).reshape(-1, 2, 3)
    return both[:, 0], both[:, 1]


def _failures(counts: Array, triples: Index, turned: Index) -> tuple[int, int]:
    """How many triples were tested, and how many failed; a question judged evenly tests nothing."""
    majority = np.sign(counts[:, 0] - counts[:, 1])[triples] * turned
    one, two, three = majority.T
    tested = (one == two) & (one != 0) & (three != 0)
    return int(tested.sum()), int((tested & (three != one)).sum())
