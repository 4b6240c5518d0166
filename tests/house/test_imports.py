"""Who imports whom in Python, beyond the order that import-linter guards (pyproject.toml)."""

from __future__ import annotations

import ast
import graphlib
from collections.abc import Iterator
from pathlib import Path

import grimp
import pytest

ROOT = Path(__file__).parents[2]

#: What rooms to come may never know, whichever is built first: a measurement takes linear pictures
#: and no pearl file, and a bundle for another renderer asks no participant.
NEVER = {
    "nacreous.measure": {"nacreous.spec", "nacreous.image"},
    "nacreous.export": {"nacreous.scaling", "nacreous.study"},
    "nacreous.fitting": {"nacreous.scaling", "nacreous.study"},
    "nacreous.batch": {"nacreous.scaling", "nacreous.study"},
}


def at_load(body: list[ast.stmt]) -> Iterator[int]:
    """The lines of imports that run at load: none in functions, none for types alone."""
    for statement in body:
        match statement:
            case ast.Import() | ast.ImportFrom():
                yield statement.lineno
            case ast.If(test=ast.Name(id="TYPE_CHECKING")):
                yield from at_load(statement.orelse)
            case ast.If() | ast.ClassDef() | ast.With() | ast.Try():
                for inner in ("body", "handlers", "orelse", "finalbody"):
                    yield from at_load(getattr(statement, inner, []))
            case ast.ExceptHandler():
                yield from at_load(statement.body)


def loaded_with(graph: grimp.ImportGraph) -> dict[str, set[str]]:
    """Each module of ours with those that it imports when it is loaded."""
    loaded: dict[str, set[str]] = {}
    for module in graph.modules:
        path = ROOT.joinpath(*module.split("."))
        file = path.with_suffix(".py")
        if not file.is_file():
            file = path / "__init__.py"
        lines = set(at_load(ast.parse(file.read_text("utf-8")).body))
        imported = graph.find_modules_directly_imported_by(module)
        details = (
            detail
            for other in imported
            for detail in graph.get_import_details(importer=module, imported=other)
        )
        found = {detail["imported"] for detail in details if detail["line_number"] in lines}
        loaded[module] = found
    return loaded


@pytest.fixture(scope="module")
def graph() -> grimp.ImportGraph:
    return grimp.build_graph("nacreous", cache_dir=None)


def test_no_modules_load_each_other_in_a_circle(graph: grimp.ImportGraph) -> None:
    loaded = loaded_with(graph)
    order = list(graphlib.TopologicalSorter(loaded).static_order())
    assert len(order) == len(loaded) > 200
    assert order.index("nacreous.spec.key") < order.index("nacreous.image")


def test_a_circle_would_be_found_and_a_late_import_is_none() -> None:
    text = "import a\nif TYPE_CHECKING:\n    import b\ndef f():\n    import c\ntry:\n    import d\n"
    assert list(at_load(ast.parse(f"{text}except E:\n    import e\n").body)) == [1, 7, 9]


def test_rooms_to_come_know_nothing_of_what_is_not_theirs(graph: grimp.ImportGraph) -> None:
    for room in NEVER.keys() & graph.modules:
        for other in NEVER[room]:
            assert not graph.find_shortest_chains(room, other, as_packages=True)
