"""Who gave each answer, where that has to be known."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nacreous.problem import InputError
from nacreous.scaling.data.answers import Answers


def known_people(answers: Answers) -> NDArray[np.int64]:
    """int64 [answer], who gave it; or one clear message where that is unknown."""
    if answers.person is None:
        raise InputError("the answers do not say who gave them; wanted: a column person")
    return answers.person
