"""TOML is read through one door, which bounds its depth before depth costs anything."""

import re
import tracemalloc
from pathlib import Path

import pytest

import nacreous as nc
from nacreous import toml_text
from nacreous.problem import InputError
from nacreous.spec import document, override
from nacreous.toml_text import DEEPEST, TooDeepError, loads

PACKAGE = Path(nc.__file__).parent
LONG = 40_000
DEEP = {
    "lists": "a = " + "[" * LONG,
    "lists that end": "a = " + "[" * LONG + "]" * LONG,
    "tables in lines": "a = " + "{a=" * LONG,
    "a dotted key": ".".join("a" * LONG) + " = 1",
    "a dotted header": "[" + ".".join("a" * LONG) + "]",
    "a dotted header of a list": "[[" + " . ".join("a" * LONG) + "]]",
    "quoted parts": ".".join(['"."'] * LONG) + " = 1",
    "a dotted key in a table": "a = { " + ".".join("a" * LONG) + " = 1 }",
    "behind strings and comments": "b = ']]' # ]\na = " + '["]", ' * LONG,
    "behind a string of lines": 'b = """\n]\\"""]"""\na = ' + "[" * LONG,
}


@pytest.mark.parametrize("kind", DEEP)
def test_depth_is_refused_before_it_costs_memory(kind: str) -> None:
    text = DEEP[kind]
    tracemalloc.start()
    try:
        with pytest.raises(TooDeepError):
            loads(text)
        assert tracemalloc.get_traced_memory()[1] < 1_000_000
    finally:
        tracemalloc.stop()


def test_all_that_is_not_deep_is_read_as_the_parser_reads_it() -> None:
    brackets = "[" * LONG
    assert loads(f'a = \'{brackets}\' # {brackets}\nb = "\\"{brackets}"') == {
        "a": brackets,
        "b": f'"{brackets}',
    }
    for quotes in ('"""', "'''"):
        assert loads(f"a = {quotes}\n{brackets}{quotes}") == {"a": brackets}
        assert loads(f"a = {quotes}{quotes[0]}.{quotes}{quotes[:2]}\nb = 1")["b"] == 1
    many = "\n".join(f"a{n} = [[1.5, 2.5], [{{ b.c = 0.5 }}]]" for n in range(5000))
    assert len(loads(many)) == 5000
    most = "[" * DEEPEST + "]" * DEEPEST
    assert loads(f"a = {most}")["a"]
    with pytest.raises(TooDeepError):
        loads(f"a = [{most}]")


def test_every_door_refuses_depth_by_its_place() -> None:
    for text in DEEP.values():
        with pytest.raises(InputError, match=r"^x: line \d, column \d+: nested too deeply; allow"):
            document.parse(text, "x")
        assert override.value_of(text) == text
    with pytest.raises(InputError, match="line 1, column 37: nested too deeply"):
        document.parse("a = " + "[" * 40, "x")


def test_nothing_but_the_door_and_our_own_texts_calls_the_parser() -> None:
    own = {"exhibit.py", "method.py"}  # captions and sentences of the package
    calling = {
        path.name
        for path in PACKAGE.rglob("*.py")
        if re.search(r"tomllib\.loads?\(", path.read_text(encoding="utf-8"))
    }
    assert calling == {Path(toml_text.__file__).name} | own
