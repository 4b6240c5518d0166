"""What holds for every test and every example in a docstring."""

from collections.abc import Iterator

import numpy as np
import pytest


def pytest_addoption(parser: pytest.Parser) -> None:
    """Laws on simulated studies take as many as one has time for."""
    parser.addoption("--studies", type=int, default=100, help="simulated studies for each law")


@pytest.fixture(autouse=True)
def _arrays_print_as_numpy_prints_them() -> Iterator[None]:
    """colour-science, a peer in some tests, changes how NumPy prints when it is imported."""
    with np.printoptions(legacy=False):
        yield
