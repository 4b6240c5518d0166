"""ARCHITECTURE.md is true: its paths exist, its names are defined there, no room is missing."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "ARCHITECTURE.md").read_text("utf-8")

#: What opens a definition of a name, by the ending of the file.
DEFINITIONS = {
    ".rs": r"\b(fn|struct|enum|trait|type|const|static|mod) {name}\b",
    ".py": r"^\s*((async )?def|class) {name}\b|^\s*{name}\s*[:=]",
    ".ts": r"\b(function|class|interface|type|const) {name}\b|^\s*{name}:",
}

#: What somebody new to the project must find in the tables, and where.
SOUGHT = {
    "the coherence length": ("crates/optics/src/window.rs", "ends"),
    "the number of bounces": ("crates/render/src/stages/around.rs", "BOUNCES"),
    "a third observer": ("crates/colour/src/observer.rs", "Observer"),
    "a new task of a study": ("nacreous/study/task/task.py", "Task"),
    "a new scene key": ("nacreous/spec/scene.py", "Scene"),
    "the footprint of a pixel on the pearl": (
        "crates/image/src/picture/reflections.rs",
        "pixels_mm",
    ),
    "where rows become answers": ("nacreous/study/task/pair/reading.py", "answers"),
    "a new picture format": ("nacreous/image.py", "SUFFIXES"),
    "a pigment": ("crates/nacre/src/pigment.rs", "NAMES"),
    "the Japanese sentence on the break page": (
        "studio/src/participant/words/ja.ts",
        "break_text",
    ),
}


class Row(NamedTuple):
    """A row of the tables: what is sought, and the names to look for by path."""

    what: str
    places: list[tuple[str, list[str]]]


def is_path(word: str) -> bool:
    return "/" in word and " " not in word and not word.startswith("./")


def rows(page: str) -> Iterator[Row]:
    """The rows below "Where is ..."."""
    for line in page.partition("## Where is")[2].partition("## For the whole")[0].splitlines():
        cells = line.strip("|").split(" | ")
        if not line.startswith("| ") or len(cells) != 2 or cells[0].strip() == "what":
            continue
        places: list[tuple[str, list[str]]] = []
        for word in re.findall(r"`([^`]+)`", cells[1]):
            if is_path(word):
                places.append((word, []))
            elif re.fullmatch(r"\w+", word) and places:
                places[-1][1].append(word)
        yield Row(cells[0].strip(), places)


def defines(path: Path, name: str) -> bool:
    pattern = DEFINITIONS[path.suffix].replace("{name}", re.escape(name))
    return re.search(pattern, path.read_text("utf-8"), re.MULTILINE) is not None


def test_every_path_on_the_page_is_there() -> None:
    paths = {word for word in re.findall(r"`([^`\n]+)`", PAGE) if is_path(word)}
    built = {"nacreous/server/pages/", "nacreous/viewer/page/"}  # by ./just, and not in git
    inside = {"data/", "fit/", "check/", "compare/", "planning/", "figure/", "report/"}
    inside |= {"task/", "design/", "plan/", "store/", "running/", "results/", "specs/"}
    inside |= {"light/", "words/", "state/", "panels/"}
    missing = {path for path in paths - built - inside if not (ROOT / path).exists()}
    assert missing == set()
    assert len(paths) > 150


@pytest.mark.parametrize("row", list(rows(PAGE)), ids=lambda row: row.what)
def test_every_name_of_a_row_is_defined_in_the_file_before_it(row: Row) -> None:
    assert row.places or "where it is declared" in row.what
    for path, names in row.places:
        assert [name for name in names if not defines(ROOT / path, name)] == [], path


def test_what_somebody_new_looks_for_is_found() -> None:
    table = list(rows(PAGE))
    for what, (path, name) in SOUGHT.items():
        found = [row for row in table if row.what.startswith(what)]
        assert len(found) == 1, what
        assert name in dict(found[0].places)[path], what


def test_every_room_is_on_the_page() -> None:
    crates = [path.parent for path in ROOT.glob("crates/*/Cargo.toml")]
    python = [
        path
        for path in (ROOT / "nacreous").iterdir()
        if path.suffix == ".py" or (path / "__init__.py").is_file()
    ]
    folders = [path for path in (ROOT / "crates/image/src").iterdir() if path.is_dir()]
    rooms = {path.relative_to(ROOT).as_posix() for path in [*crates, *python, *folders]}
    assert rooms - {"nacreous/__init__.py"} > {"crates/render", "nacreous/study"}
    missing = {room for room in rooms if not re.search(rf"`{re.escape(room)}/?(\.pyi)?`", PAGE)}
    assert missing == {"nacreous/__init__.py"}


def test_a_wrong_row_would_be_found() -> None:
    page = "## Where is ...\n| what | where |\n| it | `nacreous/image.py` `render`, `nothing` |\n"
    (row,) = rows(page)
    assert row == Row("it", [("nacreous/image.py", ["render", "nothing"])])
    assert defines(ROOT / "nacreous/image.py", "render")
    assert not defines(ROOT / "nacreous/image.py", "nothing")
