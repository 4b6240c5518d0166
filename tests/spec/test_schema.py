"""What is written of a file and of its keys: TOML, JSON Schema, the reference page."""

from __future__ import annotations

import doctest
import json
import subprocess
import sys
import tomllib
from typing import Any

import pytest

from nacreous.spec import (
    Body,
    Film,
    Growth,
    Inside,
    Interference,
    Layers,
    Pearl,
    Scene,
    Surface,
    Uniaxial,
    json_schema,
    preset,
)
from nacreous.spec.key import every_key
from tests.spec.keys import (
    FILES,
    KEYS,
    LEAVES,
    NUMBERS,
    ROOT,
    bounds,
)


@pytest.mark.parametrize(
    "spec",
    [
        *(Pearl.load(name) for name in preset.names("pearl")),
        *(Scene.load(name) for name in preset.names("scene")),
        Pearl(name='quo"te\\ 真珠', nacre=Layers(thickness_nm=[1e-7, 1e5], aragonite=[1.68, 0.0])),
        Pearl(
            name="all of transport",
            film=Film(outer_um=20, columns=8, column_spread_nm=12),
            body=Body(pigment="gold", nacre_mm=0.5, nucleus="#ffffff"),
            inside=Inside(spread=0.1),
            surface=Surface(facets="ggx", facet_spread_rad=0.1),
            nacre=Growth(aragonite=Uniaxial(n_o=1.683, n_e=1.53), protein="chitin"),
        ),
        Pearl(
            name="all of illuminant",
            model="illuminant",
            body_colour="#102030",
            interference=Interference(mixing=0.2),
            surface=Surface(mirror_weight=0.5, layer_reflectance=0.0, falloff_mm=3.0),
        ),
        Scene(lamps=[{"position_mm": [0, 0, -99.5]}], walls={}),
        Scene(),
    ],
    ids=lambda spec: spec.name,
)
def test_what_is_written_reads_back_as_the_same(spec: Any) -> None:
    text = spec.to_toml()
    assert type(spec).from_toml(text) == spec
    assert type(spec).model_validate_json(spec.model_dump_json()) == spec
    assert hash(spec) == hash(type(spec).from_toml(text))


@pytest.mark.parametrize("model", FILES)
def test_the_schema_states_every_key_with_description_range_and_default(model: Any) -> None:
    schema = json_schema(model)
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    stated = {model.__name__: schema, **schema["$defs"]}
    for key in every_key(model):
        section = stated[key.owner.__name__]
        assert section["additionalProperties"] is False
        assert ">>>" not in section["description"]
        entry = section["properties"][key.path.rpartition(".")[2]]
        assert entry["description"] == key.field.description
        if (model, key) in NUMBERS:
            low, high, _ = bounds(key)
            assert entry.get("minimum", entry.get("exclusiveMinimum")) == low
            assert entry.get("maximum", entry.get("exclusiveMaximum")) == high
            default = None if key.field.is_required() else key.field.default
            assert entry.get("default") == default
    assert "null" not in json.dumps(schema)


def test_the_reference_page_names_every_key_with_its_default_and_range() -> None:
    page = (ROOT / "docs" / "files.md").read_text(encoding="utf-8")
    for _, key in LEAVES:
        name, default = key.path.rpartition(".")[2], key.field.default
        if key.field.is_required():
            written = "required"
        else:
            written = "–" if default is None else f"`{json.dumps(default)}`"
        allowed = key.field.json_schema_extra["allowed"]
        assert f"| `{name}` | {written} | {allowed} | " in page
    for _, key in KEYS:
        assert f"`{key.path.rpartition('.')[2]}`" in page or f"[{key.path}]" in page


def test_the_toml_of_the_reference_page_is_a_pearl() -> None:
    page = (ROOT / "docs" / "files.md").read_text(encoding="utf-8")
    sample = page.partition("```toml\n")[2].partition("```")[0]
    assert Pearl.from_toml(sample) == Pearl(
        name="my first pearl", depth=0.8, nacre={"preset": "akoya-rg", "seed": 7}
    )
    assert tomllib.loads(sample)["depth"] == 0.8


def test_the_python_of_the_reference_page_runs() -> None:
    done = doctest.testfile(str(ROOT / "docs" / "files.md"), module_relative=False)
    assert (done.failed, done.attempted) == (0, 4)


def test_reading_files_needs_neither_numpy_nor_the_compiled_rooms() -> None:
    code = (
        "import sys, nacreous.spec; "
        "sys.exit(any(name in sys.modules for name in ('numpy', 'nacreous._core')))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
