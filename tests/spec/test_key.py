"""Every key refuses what it must, in words that name file, key and range."""

from __future__ import annotations

import datetime as dt
import json
import math
from pathlib import Path
from typing import Any, get_args

import pytest

import nacreous as nc
from nacreous.spec import (
    Pearl,
    medium,
)
from nacreous.spec.body import Pigment
from nacreous.spec.key import alternatives, sections_in
from tests.spec.keys import (
    KEYS,
    LEAVES,
    MEDIA,
    NUMBERS,
    bounds,
    file_with,
    name_of,
    problems,
    refusal,
)


@pytest.mark.parametrize("case", LEAVES, ids=name_of)
@pytest.mark.parametrize("value", [True, {"a": 1}, [[]], dt.datetime(2026, 1, 1)])
def test_every_key_refuses_a_value_of_the_wrong_type(case: Any, value: Any) -> None:
    model, key = case
    if case in MEDIA and isinstance(value, dict):
        assert len(problems(lambda: model.check(file_with(model, key, value), "", Path()))) == 3
        return  # a table is of the right type here; the next test says what it holds
    line = refusal(model, key, value)
    assert key.field.json_schema_extra["allowed"] in line


@pytest.mark.parametrize("case", MEDIA, ids=name_of)
def test_a_medium_by_direction_says_which_of_its_indices_is_wrong(case: Any) -> None:
    model, key = case
    for value, words in (
        ({"n_o": 1.6}, ["n_e is missing; allowed: above 0 to 10"]),
        ({"n_o": -1, "n_e": True}, ["n_o is -1; allowed: above 0 to 10", "n_e is true; wanted"]),
        ({"n_o": 1.6, "n_e": 1.5, "ne": 1.5}, ["ne is not a key here; did you mean n_e?"]),
    ):
        values = file_with(model, key, value)
        lines = problems(lambda values=values: model.check(values, "my.toml", Path()))
        assert len(lines) == len(words)
        for line, word in zip(lines, words, strict=True):
            assert line.startswith(f"my.toml: {key.path}.{word}")


@pytest.mark.parametrize("case", MEDIA, ids=name_of)
def test_an_index_says_its_range(case: Any) -> None:
    for value in (0, -1.5, 10.5, math.nan, [1.5, -0.1], [1.5, 11], [1.5], [1.5, 0, 0]):
        line = refusal(*case, value)
        assert "; allowed: a number n above 0 to 10, [n, k] with k from 0 to 10" in line


@pytest.mark.parametrize(
    ("values", "line"),
    [
        ({"nacre": {"aragonite": "aragonit"}}, '"aragonit"; allowed: a number n above 0'),
        ({"nacre": {"aragonite": "aragonit"}}, 'did you mean "aragonite"?'),
        ({"nacre": {"protein": "chitine"}}, 'did you mean "chitin"?'),
        ({"body": {"pigment": "golden"}}, 'did you mean "gold"?'),
        ({"body": {"pigment": "blacklip"}}, 'did you mean "black-lip"?'),
        ({"surface": {"facets": "torrance"}}, 'did you mean "torrance-sparrow"?'),
        ({"model": "transprt"}, 'did you mean "transport"?'),
        ({"model": "paper"}, 'model is "paper"; allowed: "transport" or "illuminant"'),
    ],
)
def test_a_mistyped_name_is_offered_the_nearest(values: dict[str, Any], line: str) -> None:
    (said,) = problems(lambda: Pearl.check(values, "my.toml", Path()))
    assert line in said


def test_names_of_media_and_pigments_are_those_of_the_compiled_rooms() -> None:
    assert medium.NAMES == nc.medium.NAMES
    assert get_args(Pigment) == nc.body.PIGMENTS


@pytest.mark.parametrize("case", NUMBERS, ids=name_of)
@pytest.mark.parametrize("value", ["20", math.nan, math.inf, -math.inf])
def test_every_number_refuses_text_and_what_is_not_finite(case: Any, value: Any) -> None:
    line = refusal(*case, value)
    assert line.startswith(f"my.toml: {case[1].path} is {json.dumps(value)}"[:-9]) or "inf" in line
    assert line.endswith(f"allowed: {case[1].field.json_schema_extra['allowed']}")


@pytest.mark.parametrize("case", NUMBERS, ids=name_of)
def test_every_number_refuses_what_lies_outside_its_range(case: Any) -> None:
    model, key = case
    low, high, outside = bounds(key)
    step = 1 if int in alternatives(key.field.annotation) else 1e-3
    for value in (low - step, high + step, *outside):
        line = refusal(model, key, value)
        assert line == (
            f"my.toml: {key.path} is {value}; allowed: {key.field.json_schema_extra['allowed']}"
        )


@pytest.mark.parametrize("case", NUMBERS, ids=name_of)
def test_the_message_states_the_very_bounds_that_are_enforced(case: Any) -> None:
    low, high, _ = bounds(case[1])
    words = case[1].field.json_schema_extra["allowed"].split()
    stated = [word for word in words if word.lstrip("-").replace(".", "").isdigit()]
    assert [type(low)(stated[0]), type(high)(stated[1])] == [low, high]


@pytest.mark.parametrize("case", NUMBERS, ids=name_of)
def test_every_number_accepts_its_bounds(case: Any) -> None:
    model, key = case
    low, high, outside = bounds(key)
    for value in {low, high} - set(outside):
        values = file_with(model, key, value)
        if key.path.startswith("nacre.thickness_"):  # far from the noise, which another test checks
            values["nacre"]["thickness_noise_nm"] = min(value, 10)
        assert model.check(values, "my.toml", Path())


TEXTS = [case for case in LEAVES if case not in NUMBERS]


@pytest.mark.parametrize("case", TEXTS, ids=name_of)
@pytest.mark.parametrize("value", ["", "nonsense\n", "#12345g", "02-30", "99999K", "-1"])
def test_every_text_key_refuses_nonsense(case: Any, value: str) -> None:
    model, key = case
    if key.path in ("name", "rows.0.label") and value not in ("", "nonsense\n"):
        assert model.check(file_with(model, key, value), "my.toml", Path())
        return
    line = refusal(model, key, value)
    assert f"is {json.dumps(value)}; " in line
    assert f"allowed: {key.field.json_schema_extra['allowed']}" in line


@pytest.mark.parametrize("case", KEYS, ids=name_of)
def test_every_key_says_its_meaning_range_and_source(case: Any) -> None:
    field = case[1].field
    assert field.description
    if not sections_in(field.annotation):
        assert "Allowed: " in field.description
        assert "Source: " in field.description
        assert field.default is not None or "Left out: " in field.description


@pytest.mark.parametrize("case", [c for c in KEYS if c not in LEAVES], ids=name_of)
def test_every_table_refuses_a_number_in_its_place(case: Any) -> None:
    assert "wanted: a " in refusal(*case, 5)


@pytest.mark.parametrize("case", KEYS, ids=name_of)
def test_a_misspelt_key_is_told_its_right_name(case: Any) -> None:
    model, key = case
    wrong = f"{key.path}x"
    values = file_with(model, key._replace(path=wrong), 1)
    lines = problems(lambda: model.check(values, "my.toml", Path()))
    right = key.path.rpartition(".")[2]
    assert f"my.toml: {wrong} is not a key here; did you mean {right}?" in lines


@pytest.mark.parametrize(
    "value",
    [10**400, -(10**5000), 1e308, "\udc80", "\u202e", "a" * 10_000],
    ids=["400 digits", "5000 digits", "1e308", "surrogate", "right to left", "long"],
)
def test_monstrous_values_are_refused_in_one_short_line(value: Any) -> None:
    for values in ({"depth": value}, {"nacre": {"seed": value}}, {"body": {"nucleus": value}}):
        (line,) = problems(lambda values=values: Pearl.check(dict(values), "my.toml", Path()))
        assert len(line) < 250
        assert line.isprintable()
