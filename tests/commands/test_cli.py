"""The command line's frame: exit codes, one plain line for each problem, help with examples."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from pydantic_core import SchemaValidator, core_schema

from nacreous import cli
from nacreous.commands.parser import build_parser
from nacreous.problem import InputError
from nacreous.spec import preset


def stand_in(monkeypatch: Any, run: Any) -> None:
    """Make a command `probe`, whose body is the given function, the only one."""

    def add_parser(subparsers: Any) -> None:
        subparsers.add_parser("probe", help="a command of the test").set_defaults(run=run)

    probe = SimpleNamespace(add_parser=add_parser)
    monkeypatch.setitem(sys.modules, "nacreous.commands.probe", probe)
    monkeypatch.setattr(cli, "COMMANDS", ("probe",))


def raising(problem: BaseException) -> Any:
    def run(_: Any) -> int:
        raise problem

    return run


@pytest.mark.parametrize(
    ("problem", "code", "said"),
    [
        (InputError("a is 1\nb is 2"), 2, "nacreous: a is 1\nnacreous: b is 2\n"),
        (KeyboardInterrupt(), 130, "nacreous: interrupted; nothing was written\n"),
        (OSError(28, "No space left on device"), 1, "nacreous: No space left on device\n"),
    ],
)
def test_what_goes_wrong_is_said_in_plain_lines_with_its_code(
    monkeypatch: Any, capsys: Any, problem: BaseException, code: int, said: str
) -> None:
    stand_in(monkeypatch, raising(problem))
    assert cli.main(["probe"]) == code
    captured = capsys.readouterr()
    assert captured.err == said
    assert captured.out == ""


def test_an_interruption_that_pydantic_wraps_in_an_error_of_its_own_is_one_too(
    monkeypatch: Any, capsys: Any
) -> None:
    class Pressed:
        def __repr__(self) -> str:
            raise KeyboardInterrupt

    def run(_: Any) -> None:
        SchemaValidator(core_schema.literal_schema([Pressed()]))

    stand_in(monkeypatch, run)
    assert cli.main(["probe"]) == 130
    assert capsys.readouterr().err == "nacreous: interrupted; nothing was written\n"


def test_a_mistake_of_ours_is_not_hidden(monkeypatch: Any) -> None:
    stand_in(monkeypatch, raising(ZeroDivisionError()))
    with pytest.raises(ZeroDivisionError):
        cli.main(["probe"])


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ([], "wanted: a command"),
        (["preset"], "preset is not a command; did you mean presets?"),
        (["xyzzy"], "xyzzy is not a command; allowed: "),
        (["a\nb"], r"a\nb is not a command; "),
        (["--verion"], "--verion"),
        (["schema"], "kind"),
        (["schema", "nacre"], "'nacre'"),
        (["presets", "scene", "boot"], '"boot" is not a scene preset; did you mean booth?'),
        (["presets", "--al"], "--al"),
        (["presets", "PEARL"], "kind is 'PEARL'; did you mean pearl?"),
        (["study", "NEW", "paper"], "ACTION is 'NEW'; did you mean new?"),
        (["scale", "PAPER"], "PAPER: does not exist; did you mean paper?"),
        (["scale", "paper", "--unit", "jod"], "--unit is 'jod'; did you mean JOD?"),
        (["scale", "paper", "--bootstrap", "1e3"], "--bootstrap: '1e3' is not a whole number;"),
        (["scale", "paper", "--seed", "1.0"], "--seed: '1.0' is not a whole number;"),
        (["scale", "paper", "--level", "most"], "--level: 'most' is not a number;"),
        (
            ["study", "report", "mine", "-o", "r.json", "--output=r.html"],
            "-o/--output is given twice, as 'r.json' and 'r.html'; allowed: once",
        ),
        (["render", "paper", "--size", "64", "--size", "64"], "--size is given twice, as '64'"),
        (["scale", "paper", "--ties", "--no-ties"], "--ties/--no-ties is given twice; allowed"),
    ],
)
def test_bad_arguments_end_with_code_2(capsys: Any, arguments: list[str], said: str) -> None:
    assert cli.main(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert said in captured.err
    (line,) = captured.err.splitlines()
    assert line.startswith("nacreous: ")


def test_what_makes_a_list_or_only_says_yes_may_be_given_twice() -> None:
    parser = build_parser(["scale"])
    options = ["-o", "a.csv", "-o", "b.csv", "--counts", "--counts"]
    assert parser.parse_args(["scale", "paper", *options]).output == ["a.csv", "b.csv"]
    assert parser.parse_args(["scale", "paper", "--seed", "2"]).seed == 2
    assert parser.parse_args(["scale", "paper", "--seed", "3"]).seed == 3


def test_every_command_explains_itself_with_examples(capsys: Any) -> None:
    for arguments in [[], *([command] for command in cli.COMMANDS)]:
        assert cli.main([*arguments, "--help"]) == 0
        page = capsys.readouterr().out
        assert "examples:" in page
        assert f"nacreous {' '.join(arguments)}".strip() in page.partition("examples:")[2]


def test_presets_lists_every_preset_with_its_line(capsys: Any) -> None:
    assert cli.main(["presets"]) == 0
    page = capsys.readouterr().out
    for kind in preset.FOLDERS:
        for name in preset.names(kind):
            assert f"  {name}" in page
            assert preset.summary(kind, name) in page


def test_presets_shows_the_file_of_one(capsys: Any) -> None:
    assert cli.main(["presets", "pearl", "akoya-g"]) == 0
    assert capsys.readouterr().out == preset.text("pearl", "akoya-g")


@pytest.mark.parametrize(
    ("kind", "title"), [("pearl", "Pearl"), ("scene", "Scene"), ("study", "Design")]
)
def test_schema_prints_json(capsys: Any, kind: str, title: str) -> None:
    assert cli.main(["schema", kind]) == 0
    assert json.loads(capsys.readouterr().out)["title"] == title


def test_version_names_program_and_version(capsys: Any) -> None:
    assert cli.main(["--version"]) == 0
    program, version = capsys.readouterr().out.split()
    assert program == "nacreous"
    assert version[0].isdigit()


def test_a_reader_that_leaves_is_no_drama() -> None:
    with subprocess.Popen(
        [sys.executable, "-m", "nacreous", "schema", "pearl"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as program:
        assert program.stdout is not None
        assert program.stderr is not None
        program.stdout.close()
        assert program.stderr.read() == b""
    assert program.returncode == 141


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a full disk to write to")
def test_a_full_disk_is_one_line_and_code_1() -> None:
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "nacreous", "presets"],
            stdout=full,
            stderr=subprocess.PIPE,
            check=False,
        )
    assert done.returncode == 1
    assert done.stderr.startswith(b"nacreous: ")
    assert done.stderr.count(b"\n") == 1


def test_help_loads_nothing_heavy() -> None:
    code = (
        "import sys; from nacreous import cli; cli.main(['--help']); "
        "sys.exit(any(name in sys.modules for name in ('numpy', 'pydantic', 'nacreous._core')))"
    )
    done = subprocess.run([sys.executable, "-c", code], stdout=subprocess.DEVNULL, check=False)
    assert done.returncode == 0


def test_the_program_ends_without_a_search_for_garbage() -> None:
    code = (
        "import atexit, gc, sys; from nacreous import cli; sys.argv = ['nacreous', '--version']; "
        "atexit.register(lambda: print(gc.get_freeze_count() > 0)); cli.prepare(); cli.main()"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "True"
