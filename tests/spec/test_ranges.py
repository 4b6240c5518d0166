"""The renderer's table of ranges is that of the keys' declarations."""

from pathlib import Path

import pytest

import nacreous as nc
from nacreous import _core
from nacreous.image import recipe_json
from nacreous.spec.ranges import ranges, table

COMMITTED = Path(__file__).parents[2] / "crates" / "render" / "src" / "spec" / "ranges.csv"


def test_the_table_is_current():
    assert COMMITTED.read_text() == table(), "call ./just types"


def test_every_number_has_both_bounds():
    for row in ranges():
        low = row.least if row.above is None else row.above
        high = row.most if row.below is None else row.below
        assert (low, high) != (None, None), row
        assert row.kind == "length" or (low is not None and high is not None), row
        assert row.allowed or row.kind == "length", row


@pytest.mark.parametrize(
    ("written", "instead", "message"),
    [
        ('"depth":0.6', '"depth":1.5', "pearls.0.depth is 1.5; allowed: 0 to 1"),
        ('"columns":64', '"columns":1', "pearls.0.film.columns is 1; allowed: 2 to 1024 columns"),
        ('"exposure":1.0', '"exposure":0', "scene.camera.exposure is 0; allowed: 0.001 to 1000"),
    ],
)
def test_the_renderer_refuses_what_the_declaration_does(written, instead, message):
    recipe = recipe_json(nc.Pearl(), nc.Scene(), size=8)
    assert written in recipe
    with pytest.raises(nc.InputError) as refused:
        _core.render(recipe.replace(written, instead), [], [], [], None)
    assert str(refused.value) == message
