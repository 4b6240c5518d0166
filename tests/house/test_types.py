"""The pages' files of the wire and of pearl and scene files, against the schemas they are of."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

STUDIO = Path(__file__).parent.parent.parent / "studio"
SOURCES = STUDIO / "src"
FILES = [
    "shared/spec.ts",
    "shared/wire.ts",
    "viewer/specs/complete.ts",
    "viewer/specs/declared.json",
]
STALE = "is of other schemas; ./just types makes it again"


def printed(hash_seed: str = "0") -> str:
    """What the schemas are now."""
    script = [sys.executable, STUDIO / "types" / "schemas.py"]
    env = {**os.environ, "PYTHONHASHSEED": hash_seed}
    return subprocess.run(script, env=env, capture_output=True, text=True, check=True).stdout


@pytest.fixture(scope="module")
def schemas() -> str:
    return printed()


def test_the_types_bear_the_fingerprint_of_the_schemas(schemas: str) -> None:
    made = json.loads(schemas)
    assert sorted(made) == FILES
    for name, of in made.items():
        text = (SOURCES / name).read_text(encoding="utf-8")
        if "values" in of:
            assert json.loads(text) == of["values"], f"{name} {STALE}"
        else:
            assert f" * {of['sha256']}" in text.splitlines()[:3], f"{name} {STALE}"


def test_the_schemas_are_the_same_in_every_process(schemas: str) -> None:
    assert printed("1") == printed("2") == schemas


def test_the_types_are_what_the_generator_makes(schemas: str, tmp_path: Path) -> None:
    if shutil.which("node") is None or not (STUDIO / "node_modules").is_dir():
        pytest.skip("no packages of the pages here:   ./just pages   (needs Node.js and npm)")
    script = ["node", STUDIO / "types" / "typescript.mjs", tmp_path]
    subprocess.run(script, input=schemas, text=True, check=True)
    for name in FILES:
        made = (tmp_path / name).read_bytes()
        assert made == (SOURCES / name).read_bytes(), f"{name} {STALE}"


def test_the_viewer_has_the_trades_words_as_they_are() -> None:
    script = [sys.executable, "-m", "nacreous", "words", "--json"]
    said = subprocess.run(script, capture_output=True, check=True).stdout
    assert said == (SOURCES / "viewer" / "words" / "trade.json").read_bytes(), STALE
