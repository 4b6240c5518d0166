"""Control characters reach neither terminal nor page raw, whichever door they came in by."""

import ast
import pickle
import traceback
from pathlib import Path

import pytest

import nacreous
from nacreous.cli import main
from nacreous.commands.terminal import say
from nacreous.printable import printable_lines
from nacreous.problem import InputError

COMMANDS = Path(nacreous.__file__).parent / "commands"
#: What prints by itself: `say`; the bar, whose words are its own; texts of files of ours.
OWN = ("terminal.py", "progress.py", "presets.py", "schema.py")


@pytest.mark.parametrize("hidden", ["\x1b[2J", "\x07", "\x9b", "\u202e", "\u2066", "\r", "\x85"])
def test_a_refusal_shows_what_it_quotes_and_does_nothing_to_the_terminal(hidden: str) -> None:
    problem = InputError(f"pearl{hidden}.toml: cannot be read\nsecond line")
    told = "".join(traceback.format_exception(problem))
    assert hidden not in str(problem)
    assert hidden not in told
    assert str(problem).count("\n") == 1
    assert str(pickle.loads(pickle.dumps(problem))) == str(problem)


def test_lines_stay_lines_and_letters_letters() -> None:
    text = "真珠 – café\n\tnext"
    assert printable_lines(text) == "真珠 – café\n\\u0009next"


def test_what_is_said_shows_names_as_they_can_be_shown(capsys: pytest.CaptureFixture[str]) -> None:
    say("a\x1b[31m.csv: written\nb: written")
    assert capsys.readouterr().out == "a\\u001b[31m.csv: written\nb: written\n"


@pytest.mark.parametrize("path", sorted(COMMANDS.glob("*.py")), ids=lambda path: path.name)
def test_commands_say_everything_by_one_door(path: Path) -> None:
    calls = (node for node in ast.walk(ast.parse(path.read_text("utf-8"))))
    prints = [
        call.lineno
        for call in calls
        if isinstance(call, ast.Call)
        and isinstance(call.func, ast.Name)
        and call.func.id == "print"
    ]
    assert path.name in OWN or prints == []


@pytest.mark.parametrize(
    "arguments",
    [
        ["scale", "no\x1b[31m.csv"],
        ["scale", "paper", "--unit", "z\x1b[31m"],
        ["render", "no\x1b[31m.toml"],
        ["study", "serve", "no\x1b[31m"],
        ["study", "new", "no\x1b[31m.toml"],
        ["study", "export", "no\x1b[31m"],
        ["no\x1b[31m"],
    ],
)
def test_a_refused_argument_is_shown_without_its_control_characters(
    arguments: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(arguments) == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert "\x1b" not in told.err
    assert "[31m" in told.err
