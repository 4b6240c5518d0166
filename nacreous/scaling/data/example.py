"""The judgements of the paper, from its table 1.

Nagata, Usami, Manabe and Inokuchi, 1996: seven crops of one picture of a pearl, numbered from its
centre outward; 21 pairs, "which looks more like a pearl?". These are no raw data: the counts are
reconstructed from the printed z of table 1, taking 104 answers a pair.
"""

from __future__ import annotations

from importlib.resources import files

import numpy as np
from numpy.typing import NDArray

from nacreous.scaling.data.comparisons import Comparisons

#: Answers a pair, the number of people the paper states; that each answered each pair is assumed.
ANSWERS = 104
#: What every table and plot of these data has to say.
LABEL = "reconstructed from the published table 1, n = 104 per pair assumed; not raw data"


def paper() -> Comparisons:
    """The paper's judgements of photographs as counts, reconstructed from the published table 1.

    >>> int(paper().matrix[1, 0])
    80
    """
    return Comparisons.of_counts(_numbers("paper_counts_n104.csv"))


def paper_proportions() -> NDArray[np.float64]:
    """float64 [7, 7]: the share that preferred i to j, two decimals, 0.50 on the diagonal.

    With these the paper's own method gives its own numbers:
    `Comparisons.of_proportions(paper_proportions(), answers=104)`.

    >>> float(paper_proportions()[1, 0])
    0.77
    """
    return _numbers("paper_proportions.csv")


def _numbers(name: str) -> NDArray[np.float64]:
    text = files("nacreous.scaling.data").joinpath("examples", name).read_text("utf-8")
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    return np.array([[float(cell) for cell in line.split(",")] for line in lines])
