"""Days of seeding and harvest."""

from __future__ import annotations

import pytest

from nacreous.spec import (
    Growth,
    Pearl,
)


@pytest.mark.parametrize(
    ("seeding", "harvest", "days"),
    [
        ("04-15", "12-15", 244),
        ("12-15", "04-15", 121),
        ("04-15", "04-15", 365),
        ("2023-12-31", "2024-12-31", 366),
        ("2000-01-01", "2020-01-01", 7305),
    ],
)
def test_days_from_seeding_to_harvest(seeding: str, harvest: str, days: int) -> None:
    assert Growth(seeding=seeding, harvest=harvest).days == days


def test_a_date_without_quotes_means_the_same() -> None:
    text = "[nacre]\nseeding = 2024-02-29\nharvest = 2024-12-15\n"
    assert Pearl.from_toml(text).nacre == Growth(seeding="2024-02-29", harvest="2024-12-15")
