"""Pictures changed on purpose, and which criteria fail of them."""

from __future__ import annotations

from nacreous.paper.measurement import Measurement

SIZE_PX = 160


def failing(measurements: list[Measurement]) -> set[int]:
    """Places of the criteria that do not hold."""
    return {i for i, measured in enumerate(measurements) if measured.holds is False}
