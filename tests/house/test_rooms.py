"""The order of the rooms in Rust; import-linter (pyproject.toml) guards the Python ones."""

import json
import subprocess
from pathlib import Path

ROOT = Path(__file__).parent.parent.parent

# Cargo already refuses circles. This says which way round, and who knows nothing of whom.
MAY_KNOW = {
    "nacreous-nacre": set(),
    "nacreous-optics": {"nacreous-nacre"},
    "nacreous-colour": set(),
    "nacreous-image": {"nacreous-nacre", "nacreous-optics", "nacreous-colour"},
    "nacreous-scaling": set(),
    "nacreous-python": {
        "nacreous-nacre",
        "nacreous-optics",
        "nacreous-colour",
        "nacreous-image",
        "nacreous-scaling",
    },
    "nacreous-wasm": {"nacreous-nacre", "nacreous-optics"},
}


def crates() -> dict[str, set[str]]:
    """Each crate of the workspace with those of its dependencies that are rooms too."""
    metadata = subprocess.run(
        ["cargo", "metadata", "--no-deps", "--offline", "--format-version=1"],
        cwd=ROOT,
        check=True,
        capture_output=True,
        text=True,
    )
    packages = json.loads(metadata.stdout)["packages"]
    rooms = {package["name"] for package in packages}
    return {
        package["name"]: rooms & {needed["name"] for needed in package["dependencies"]}
        for package in packages
    }


def test_every_crate_has_its_place_in_the_order():
    assert crates().keys() == MAY_KNOW.keys()


def test_earlier_crates_never_depend_on_later_ones():
    too_much = {
        name: known - MAY_KNOW[name] for name, known in crates().items() if known - MAY_KNOW[name]
    }
    assert too_much == {}
