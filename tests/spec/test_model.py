"""Keys and media that belong to one of the two models of light."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from nacreous.spec import (
    Film,
    Pearl,
)
from tests.spec.keys import (
    LEAVES,
    MODELS,
    NUMBERS,
    bounds,
    file_with,
    home,
    name_of,
    problems,
)


@pytest.mark.parametrize("case", [case for case in LEAVES if home(case[1])], ids=name_of)
def test_a_key_of_the_other_model_is_refused(case: Any) -> None:
    model, key = case
    default = key.field.default
    bound = bounds(key) if case in NUMBERS else None
    value = default if default is not None else bound[1] if bound else None
    values = file_with(model, key, value)
    assert model.check(dict(values), "my.toml", Path()).model == home(key)
    values["model"] = MODELS[home(key)]
    assert problems(lambda: model.check(values, "my.toml", Path())) == [
        f'my.toml: {key.path} is given while model is "{MODELS[home(key)]}"; '
        f'allowed: only with model = "{home(key)}"'
    ]


def test_transport_is_the_model_of_a_file_that_names_none() -> None:
    assert Pearl().model == "transport"
    (line,) = problems(lambda: Pearl.check({"body_colour": "#ffffff"}, "my.toml", Path()))
    assert line == (
        'my.toml: body_colour is given while model is "transport"; '
        'allowed: only with model = "illuminant"'
    )


def test_an_empty_table_of_the_other_model_is_refused_by_its_name() -> None:
    (line,) = problems(lambda: Pearl.from_toml("[interference]\n", "my.toml"))
    assert line.startswith('my.toml: interference is given while model is "transport"; ')
    (line,) = problems(lambda: Pearl(model="illuminant", film=Film()))
    assert line.startswith('Pearl: film is given while model is "illuminant"; ')


def test_every_key_of_the_other_model_has_its_line() -> None:
    text = 'body_colour = "#ffffff"\n[interference]\nmixing = 0.5\nthreshold = 0.1\n'
    lines = problems(lambda: Pearl.from_toml(text, "my.toml"))
    assert [line.split()[1] for line in lines] == [
        "body_colour",
        "interference.threshold",
        "interference.mixing",
    ]
    overrides = [("model", "illuminant")]
    lines = problems(lambda: Pearl.load("akoya-rg", overrides))
    assert [line.split(" is ")[0] for line in lines] == [
        "preset akoya-rg: film.outer_um",
        "preset akoya-rg: body.pigment",
        "preset akoya-rg: body.nacre_mm",
        "preset akoya-rg: nacre.aragonite",
    ]


@pytest.mark.parametrize(
    ("model", "nacre", "allowed"),
    [
        ("transport", {"protein": [1.43, 0.01]}, "k = 0; what absorbs is body.pigment"),
        ("illuminant", {"aragonite": [1.53, 1e-9]}, "k = 0; what absorbs is body.pigment"),
        ("illuminant", {"aragonite": "aragonite"}, "an index that is the same in all directions"),
        ("illuminant", {"protein": {"n_o": 1.5, "n_e": 1.5}}, "an index that is the same in all"),
    ],
)
def test_a_model_refuses_media_that_it_does_not_know(
    model: str, nacre: dict[str, Any], allowed: str
) -> None:
    values = {"model": model, "nacre": nacre}
    (line,) = problems(lambda: Pearl.check(values, "my.toml", Path()))
    assert line.startswith(f"my.toml: nacre.{next(iter(nacre))} is ")
    assert f'while model is "{model}"; allowed: {allowed}' in line


def test_both_models_take_the_media_that_they_know() -> None:
    for model in MODELS:
        for index in (1.5, [1.5, 0.0], "aragonite-isotropic-1.53", "silk-fibroin"):
            assert Pearl(model=model, nacre={"aragonite": index, "protein": index})
    assert Pearl(nacre={"aragonite": {"n_o": 1.683, "n_e": 1.53}}).nacre.aragonite_medium == (
        1.683,
        1.53,
    )
    assert Pearl(nacre={"aragonite": "aragonite"}).nacre.aragonite_medium == "aragonite"
    assert Pearl(nacre={"protein": [1.43, 0]}).nacre.protein_medium == 1.43
