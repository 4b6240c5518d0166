"""Studies that several files of tests report on."""

from __future__ import annotations

import pytest

import nacreous as nc
from tests.scaling.report_answers import SPITEFUL, survey


@pytest.fixture(scope="session")
def paper():
    return nc.scaling.analyse(nc.scaling.paper(), example=True, bootstrap=200)


@pytest.fixture(scope="session")
def answered():
    return nc.scaling.analyse(survey(SPITEFUL), group="room", bootstrap=200, question="Which <i>?")
