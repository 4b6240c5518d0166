"""Every key of pearl and scene files is known to the renderer, which knows no other key."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from functools import reduce
from typing import Any, Literal, NamedTuple, get_args, get_origin

import pytest
from pydantic import BaseModel

from nacreous import InputError, _core
from nacreous.image import recipe_json
from nacreous.spec import Growth, Lamp, Layers, Pearl, Row, Scene, Uniaxial, Walls, Window
from nacreous.spec.key import alternatives, every_key
from nacreous.spec.model import only_with

BOGUS = "bogus"


class Table(NamedTuple):
    """A table of a recipe: the steps that lead to it, what it was written from, and its keys."""

    steps: tuple[str | int, ...]
    section: BaseModel
    keys: frozenset[str]


def tables(section: BaseModel, model: str, *steps: str | int) -> Iterator[Table]:
    """A table and those in it, with the keys that a pearl of this model has of them."""
    fields = type(section).model_fields
    keys = [name for name, field in fields.items() if only_with(field) in ("", model)]
    yield Table(steps, section, frozenset(keys))
    for key in keys:
        value = getattr(section, key)
        for number, inner in enumerate(value if isinstance(value, tuple) else ()):
            if isinstance(inner, BaseModel):
                yield from tables(inner, model, *steps, key, number)
        if isinstance(value, BaseModel):
            yield from tables(value, model, *steps, key)


ARAGONITE = Uniaxial(n_o=1.683, n_e=1.53)
PEARLS = [
    Pearl(model="transport", nacre=Growth(aragonite=ARAGONITE)),
    Pearl(model="illuminant", nacre=Layers(thickness_nm=[400.0])),
]
SCENE = Scene(
    rows=[Row(pearls=["*0", "*1"])],
    lamps=[Lamp(azimuth_deg=0, elevation_deg=45)],
    windows=[Window(azimuth_deg=0, elevation_deg=45)],
    walls=Walls(),
)
RECIPE = json.loads(recipe_json(PEARLS, SCENE, 1, 1))
TABLES = [
    table
    for root, steps in ((PEARLS[0], ("pearls", 0)), (PEARLS[1], ("pearls", 1)), (SCENE, ("scene",)))
    for table in tables(root, getattr(root, "model", ""), *steps)
]


def refusal(change: Table, key: str, value: Any) -> str:
    """What the renderer says of the recipe with one key of a table set."""
    recipe = json.loads(json.dumps(RECIPE))
    table: Any = reduce(lambda inner, step: inner[step], change.steps, recipe)
    table[key] = value
    with pytest.raises(InputError) as caught:
        _core.render(json.dumps(recipe), [], [], [], None)
    return str(caught.value)


def expected(message: str) -> frozenset[str]:
    """The names that serde would have taken in place of the one it refuses."""
    return frozenset(re.findall(r"`([^`]*)`", message.partition("expected")[2]))


def named(table: Table) -> str:
    return ".".join(map(str, table.steps))


def test_the_recipe_has_every_table_that_a_file_may_have() -> None:
    visited = {type(table.section) for table in TABLES}
    assert visited == {key.owner for model in (Pearl, Scene) for key in every_key(model)}
    assert expected(refusal(Table((), SCENE, frozenset()), BOGUS, 0)) == RECIPE.keys()


@pytest.mark.parametrize("table", TABLES, ids=named)
def test_the_renderer_knows_the_keys_of_each_table_and_no_other(table: Table) -> None:
    written: Any = reduce(lambda inner, step: inner[step], table.steps, RECIPE)
    assert written.keys() == table.keys
    message = refusal(table, BOGUS, 0)
    if isinstance(
        table.section, Uniaxial
    ):  # one of four kinds of medium, which serde tries in turn
        assert "MediumSpec" in message
        return
    assert f"unknown field `{BOGUS}`" in message
    # Which model it is has told serde whose keys to expect, and is none of them.
    assert expected(message) == table.keys - {"model"}


def words() -> Iterator[tuple[Table, str, frozenset[str]]]:
    """Each key that takes one of some words, with the words."""
    for table in TABLES:
        for key in sorted(table.keys):
            annotation = type(table.section).model_fields[key].annotation
            kinds = [kind for kind in alternatives(annotation) if get_origin(kind) is Literal]
            if kinds and not isinstance(getattr(table.section, key), int | float):
                yield table, key, frozenset(get_args(kinds[0]))


@pytest.mark.parametrize(
    ("table", "key", "allowed"),
    list(words()),
    ids=lambda given: given if isinstance(given, str) else "",
)
def test_the_renderer_knows_the_words_of_each_key_and_no_other(
    table: Table, key: str, allowed: frozenset[str]
) -> None:
    message = refusal(table, key, BOGUS)
    if key in ("aragonite", "protein", "pigment"):  # words of the nacre room, which lists them
        assert message.partition("allowed: ")[0].endswith(f'.{key} is "{BOGUS}"; ')
        assert frozenset(message.partition("allowed: ")[2].split(", ")) == allowed
        return
    assert f"unknown variant `{BOGUS}`" in message
    assert expected(message) == allowed
