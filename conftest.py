"""What holds for every test and every example in a docstring."""

import os
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import hypothesis
import numpy as np
import pytest

# How long an example takes says how busy the machine is.
hypothesis.settings.register_profile("any machine", deadline=None)
hypothesis.settings.load_profile("any machine")


def pytest_addoption(parser: pytest.Parser) -> None:
    """Laws on simulated studies take as many as one has time for."""
    parser.addoption("--studies", type=int, default=100, help="simulated studies for each law")


@pytest.fixture(autouse=True)
def _arrays_print_as_numpy_prints_them() -> Iterator[None]:
    """colour-science, a peer in some tests, changes how NumPy prints when it is imported."""
    with np.printoptions(legacy=False):
        yield


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Say how many tests were left out for want of what, with the line that installs it."""
    if hasattr(terminalreporter.config, "workerinput"):  # who started it counts its tests once more
        return
    reasons = Counter(
        report.longrepr[2].removeprefix("Skipped: ")
        for report in terminalreporter.stats.get("skipped", [])
    )
    lines = [
        f"{count} {'test' if count == 1 else 'tests'}: {reason}"
        for reason, count in reasons.most_common()
    ]
    if not lines:
        return
    terminalreporter.section("left out")
    for line in lines:
        terminalreporter.line(line)
    if noted := os.environ.get("NACREOUS_LEFT_OUT"):  # by tests/every-part
        with Path(noted).open("a", encoding="utf-8") as file:
            file.writelines(f"{line}\n" for line in lines)
