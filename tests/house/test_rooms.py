"""The order of the rooms in Rust; import-linter (pyproject.toml) guards the Python ones."""

import graphlib
import json
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent.parent

# Cargo already refuses circles. This says which way round, and who knows nothing of whom.
MAY_KNOW = {
    "nacreous-nacre": set(),
    "nacreous-optics": {"nacreous-nacre"},
    "nacreous-colour": set(),
    "nacreous-image": {"nacreous-nacre", "nacreous-optics", "nacreous-colour"},
    "nacreous-render": {
        "nacreous-nacre",
        "nacreous-optics",
        "nacreous-colour",
        "nacreous-image",
    },
    "nacreous-measure": {"nacreous-colour"},
    "nacreous-file": {"nacreous-colour"},
    "nacreous-scaling": set(),
    "nacreous-python": {
        "nacreous-nacre",
        "nacreous-optics",
        "nacreous-colour",
        "nacreous-image",
        "nacreous-render",
        "nacreous-measure",
        "nacreous-file",
        "nacreous-scaling",
    },
    "nacreous-wasm": {
        "nacreous-nacre",
        "nacreous-optics",
        "nacreous-colour",
        "nacreous-image",
        "nacreous-render",
        "nacreous-measure",
    },
    "nacreous-wasm-files": {
        "nacreous-colour",
        "nacreous-image",
        "nacreous-render",
        "nacreous-file",
    },
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


IMAGE = ROOT / "crates" / "image" / "src"


def paths_of(tree: str, before: str = "") -> Iterator[str]:
    """The paths of a use tree: "a::{b, c::d}" gives "a::b" and "a::c::d"."""
    depth, start = 0, 0
    for place, sign in enumerate(tree + ","):
        depth += (sign == "{") - (sign == "}")
        if sign == "," and depth == 0:
            path, brace, inner = tree[start:place].partition("{")
            if brace:
                yield from paths_of(inner.rpartition("}")[0], before + path)
            elif path:
                yield before + path
            start = place + 1


def imports(text: str) -> set[str]:
    """What a file of Rust, tests included, names of its crate: paths from the crate's root."""
    code = re.sub(r"//.*", "", text)
    uses = re.findall(r"\buse crate::([^;]*);", code)
    inline = re.findall(r"\bcrate::(\w[\w:]*)", re.sub(r"\buse [^;]*;", "", code))
    return {path for use in uses for path in paths_of(re.sub(r"\s+", "", use))} | set(inline)


def file_of(path: str) -> str:
    """The file that defines a path, or the longest beginning of it that is one."""
    parts = path.split("::")
    for end in range(len(parts), 0, -1):
        if (IMAGE / "/".join(parts[:end])).with_suffix(".rs").is_file():
            return "/".join(parts[:end])
    raise AssertionError(f"crates/image has no file for crate::{path}")


def files_of_image() -> dict[str, set[str]]:
    """Each file of crates/image, lib.rs aside, with those it names; a folder names all in it."""
    paths = (file for file in IMAGE.rglob("*.rs") if file.name != "lib.rs")
    files = {path.relative_to(IMAGE).with_suffix("").as_posix(): path for path in paths}
    return {
        file: {file_of(named) for named in imports(path.read_text("utf-8"))}
        | {other for other in files if other.startswith(f"{file}/")}
        for file, path in files.items()
    }


def in_order(graph: dict[str, set[str]]) -> list[str]:
    """The names with what each needs before it; CycleError where there is a circle."""
    return list(graphlib.TopologicalSorter(graph).static_order())


def test_no_files_of_image_form_a_circle():
    files = files_of_image()
    assert len(in_order(files)) == len(files) > 50
    # A file names others by their path from the root alone, where the reading above finds it.
    for file in files:
        text = (IMAGE / file).with_suffix(".rs").read_text("utf-8")
        assert set(re.findall(r"^ *use super::(.*);", text, re.MULTILINE)) <= {"*"}, file


def test_no_folders_of_image_form_a_circle():
    folders: dict[str, set[str]] = {}
    for file, needed in files_of_image().items():
        folder = file.partition("/")[0]
        others = {other.partition("/")[0] for other in needed} - {folder}
        folders.setdefault(folder, set()).update(others)
    assert in_order(folders)[-2:] == ["picture", "preview"]


def test_a_circle_would_be_found():
    trees = "use crate::{a::{self, b::{C, D}}, e::F};"
    assert imports(trees) == {"a::self", "a::b::C", "a::b::D", "e::F"}
    with pytest.raises(graphlib.CycleError):
        in_order({"pearl": {"sight"}, "sight": {"shade"}, "shade": {"pearl"}})
