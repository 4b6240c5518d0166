"""An option given twice: nothing is dropped in silence, whichever command has it."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path

import pytest

from nacreous import cli
from nacreous.commands.parser import build_parser

#: Lists of KEY=VALUE: a call of each, less the option, and one key with two values.
_SETTINGS = {
    "render --set": (["akoya-rg"], ["depth=0.7", "depth = 0.8"]),
    "render --word": (["akoya-rg"], ["luster=Fair", "テリ=最上"]),
    "turn --set": (["akoya-rg"], ["depth=0.7", "depth = 0.8"]),
    "turn --word": (["akoya-rg"], ["luster=Fair", "テリ=最上"]),
    "view --set": (["akoya-rg"], ["depth=0.7", "depth = 0.8"]),
    "card --set": (["akoya-rg"], ["depth=0.7", "depth = 0.8"]),
    "card --word": (["akoya-rg"], ["luster=Fair", "テリ=最上"]),
    "grow --set": (["akoya-rg"], ["seed=1", "nacre.seed=2"]),
    "scale --column": (["answers.csv"], ["left=a", "left=b"]),
    "strand draw --mean": ([], ["size_mm=7", "size_mm =8"]),
    "strand draw --spread": ([], ["L=1", "L=2"]),
}
#: Lists whose every entry is used.
_LISTS = {"sheets --only", "scale -o", "study serve --allow-host"}


def options() -> Iterator[tuple[str, argparse.Action]]:
    """Every option of every command and action, with the words that lead to it."""

    def walk(parser: argparse.ArgumentParser, words: str) -> Iterator[tuple[str, argparse.Action]]:
        for action in parser._actions:
            if isinstance(action, argparse._SubParsersAction):
                for name, below in action.choices.items():
                    yield from walk(below, f"{words} {name}".strip())
            elif action.option_strings:
                yield words, action

    yield from walk(build_parser(cli.COMMANDS), "")


def lists() -> Iterator[str]:
    for words, action in options():
        if isinstance(action, argparse._AppendAction):
            yield f"{words} {action.option_strings[0]}"


def test_every_option_that_makes_a_list_is_known_here() -> None:
    assert sorted(lists()) == sorted({*_SETTINGS, *_LISTS})


def test_an_option_with_one_value_is_refused_a_second(capsys: pytest.CaptureFixture[str]) -> None:
    tried = 0
    for words, action in options():
        if action.nargs == 0 or isinstance(action, argparse._AppendAction):
            continue
        value = str(next(iter(action.choices))) if action.choices else "1"
        once = [action.option_strings[0], *[value] * (int(action.nargs or 1))]
        assert cli.main([*words.split(), *once, *once]) == 2
        name = "/".join(action.option_strings)
        assert f"nacreous: {name} is given twice" in capsys.readouterr().err
        tried += 1
    assert tried > 60


@pytest.mark.parametrize("option", sorted(_SETTINGS))
def test_one_key_is_refused_two_values(
    option: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    *words, flag = option.split()
    given, (first, second) = _SETTINGS[option]
    if given == ["answers.csv"]:
        Path("answers.csv").write_text("a,b,chosen\nx,y,x\n")
    before = sorted(tmp_path.iterdir())
    assert cli.main([*words, *given, flag, first, flag, second]) == 2
    assert "allowed: on" in capsys.readouterr().err  # once, or one word for a key
    assert sorted(tmp_path.iterdir()) == before
