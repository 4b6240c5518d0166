"""Standard input and output, terminals of any code, and homes that nobody may write to."""

import os
import pty
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from nacreous import cli

NACREOUS = (sys.executable, "-m", "nacreous")
ANSWERS = "left,right,chosen\nテリ,光沢,テリ\n光沢,巻き,光沢\n巻き,テリ,巻き\n"
SCALE = (*NACREOUS, "scale", "answers.csv", "--bootstrap", "0", "-o", "scale.csv")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "answers.csv").write_text(ANSWERS, "utf-8")
    return tmp_path


def run(*arguments: str, given: str = "", **environment: str) -> subprocess.CompletedProcess[bytes]:
    """The program with this standard input, as under these settings."""
    kept = {name: value for name, value in os.environ.items() if name != "PYTHONIOENCODING"}
    return subprocess.run(
        [*NACREOUS, *arguments],
        input=given.encode(),
        capture_output=True,
        env=kept | environment,
        check=False,
    )


def test_a_pearl_comes_from_standard_input_and_its_picture_goes_to_standard_output() -> None:
    done = run("render", "-", "--size", "8", "--samples", "1", "-o", "-", given="depth = 0.8")
    Path("same.toml").write_text("depth = 0.8", "utf-8")
    run("render", "same.toml", "--size", "8", "--samples", "1", "-o", "same.png")
    assert done.returncode == 0
    assert done.stdout == Path("same.png").read_bytes()
    assert b"in scene paper" in done.stderr


def test_answers_come_from_standard_input_and_the_scale_goes_to_standard_output() -> None:
    done = run("scale", "-", "--bootstrap", "0", "-o", "-", given=ANSWERS)
    subprocess.run(SCALE, check=True, capture_output=True)
    assert done.stdout == Path("scale.csv").read_bytes()
    assert sorted(path.name for path in Path().iterdir()) == ["answers.csv", "scale.csv"]


@pytest.mark.parametrize(
    ("arguments", "given", "said"),
    [
        (("render", "-"), "depth = 7", "standard input: depth is 7; allowed: 0 to 1"),
        (("render", "-"), "", "standard input: the file is empty"),
        (("grow", "-"), "[nacre]\nseed = -1", "standard input: nacre.seed is -1"),
        (("scale", "-"), "left,right,chosen\na,b,z\n", 'standard input: row 2: chosen is "z"'),
    ],
)
def test_what_is_wrong_in_standard_input_is_told_by_that_name(
    arguments: tuple[str, ...], given: str, said: str
) -> None:
    done = run(*arguments, given=given)
    assert done.returncode == 2
    assert done.stdout == b""
    assert done.stderr.decode().startswith(f"nacreous: {said}")


@pytest.mark.parametrize("locale", ["C", "POSIX"])
def test_a_file_or_pipe_gets_utf_8_whatever_the_locale(locale: str) -> None:
    settings = {"LC_ALL": locale, "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    done = run(*SCALE[3:], **settings)
    assert done.returncode == 0
    assert "テリ" in done.stdout.decode("utf-8")


@pytest.mark.parametrize(
    ("code", "shown"), [("cp932", "テリ"), ("cp1252", "\\u30c6"), ("ascii", "\\u30c6")]
)
def test_a_terminal_shows_letters_that_its_code_lacks_by_their_number(
    code: str, shown: str
) -> None:
    done = run(*SCALE[3:], PYTHONIOENCODING=code)
    assert done.returncode == 0, done.stderr
    assert shown in done.stdout.decode(code)
    assert "テリ" in Path("scale.csv").read_text("utf-8")


def test_a_terminal_of_ascii_is_no_traceback_either() -> None:
    leader, follower = pty.openpty()
    settings = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    process = subprocess.Popen(
        SCALE, stdout=follower, stderr=follower, env={**os.environ, **settings}
    )
    os.close(follower)
    said = b""
    try:
        while part := os.read(leader, 4096):
            said += part
    except OSError:  # the other end has been closed
        pass
    assert process.wait(60) == 0, said
    assert b"\\u30c6" in said
    os.close(leader)


def test_a_picture_is_not_written_onto_a_terminal() -> None:
    leader, follower = pty.openpty()
    done = subprocess.run(
        [*NACREOUS, "render", "paper", "-o", "-"],
        stdout=follower,
        stderr=subprocess.PIPE,
        check=False,
    )
    os.close(follower)
    os.close(leader)
    assert done.returncode == 2
    assert b"allowed: with > file" in done.stderr


def test_a_home_that_nobody_can_write_to_is_no_ones_business() -> None:
    nowhere = {"HOME": "/dev/null", "XDG_CACHE_HOME": "", "XDG_CONFIG_HOME": "", "MPLCONFIGDIR": ""}
    done = run("grow", "paper", **nowhere)
    assert done.returncode == 0
    assert done.stderr == b""


def test_standard_input_that_was_closed_is_told() -> None:
    for words in (("scale", "-", "-o", "-"), ("render", "-")):
        closed = ["sh", "-c", 'exec "$@" <&-', "sh", *NACREOUS, *words]
        done = subprocess.run(closed, capture_output=True, check=False)
        assert done.returncode == 2
        assert done.stderr.startswith(b"nacreous: standard input is closed; allowed: < file")


def test_help_on_a_full_disk_and_work_in_a_removed_folder_are_told() -> None:
    full = subprocess.run(
        ["sh", "-c", 'exec "$@" >/dev/full', "sh", *NACREOUS, "--help"],
        capture_output=True,
        check=False,
    )
    assert (full.returncode, full.stderr) == (1, b"nacreous: No space left on device\n")
    gone = ["sh", "-c", 'mkdir gone; cd gone; rmdir ../gone; exec "$@"', "sh", *NACREOUS]
    done = subprocess.run([*gone, "grow", "paper", "-o", "a.png"], capture_output=True, check=False)
    assert done.returncode in (1, 2)
    (line,) = [one for one in done.stderr.splitlines() if one.startswith(b"nacreous:")]
    assert b"folder" in line or b"a.png" in line


def test_diagrams_are_the_same_whatever_matplotlib_is_told_outside() -> None:
    run("grow", "paper", "-o", "plain.svg")
    for name in ("nonsense", "module://matplotlib_inline.backend_inline"):
        assert run("grow", "paper", "-o", "other.svg", MPLBACKEND=name).stderr == b""
        assert Path("other.svg").read_bytes() == Path("plain.svg").read_bytes()
    Path("matplotlibrc").write_text("text.usetex: True\nlines.linewidth: 9\n", "utf-8")
    assert run("grow", "paper", "-o", "other.svg").returncode == 0
    assert Path("other.svg").read_bytes() == Path("plain.svg").read_bytes()
    Path("matplotlibrc").write_bytes(b"font.family: \xe9\n")
    assert b"matplotlibrc is not UTF-8" in run("grow", "paper", "-o", "other.svg").stderr


def test_ctrl_c_at_any_moment_of_the_start_is_no_traceback() -> None:
    for delay_ms in range(5, 120, 10):
        process = subprocess.Popen(
            ["sh", "-c", 'echo; exec "$@"', "sh", *NACREOUS, "render", "paper"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        assert process.stdout is not None
        process.stdout.readline()
        try:
            _, said = process.communicate(timeout=delay_ms / 1000)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGINT)
            _, said = process.communicate(timeout=60)
        # Python itself, before any line of ours, dies of the signal, in its own words.
        ours = said.replace(b"nacreous: interrupted; nothing was written\n", b"")
        assert b"nacreous/" not in ours, ours.decode()


@pytest.mark.parametrize("shell", ["bash", "zsh", "tcsh"])
def test_a_shell_completes_commands_and_options(
    shell: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["completion", shell]) == 0
    script = capsys.readouterr().out
    for word in ("render", "study", "--alpha"):
        assert word.lstrip("-") in script


def test_bash_completes_a_command_and_a_file() -> None:
    Path("mine.toml").touch()
    Path("completion.sh").write_bytes(run("completion", "bash").stdout)
    asked = """
        source ./completion.sh
        COMP_WORDS=(nacreous stu); COMP_CWORD=1; _shtab_nacreous; echo "${COMPREPLY[@]}"
        COMP_WORDS=(nacreous render m); COMP_CWORD=2; _shtab_nacreous; echo "${COMPREPLY[@]}"
    """
    done = subprocess.run(["bash", "-c", asked], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["study", "mine.toml"]


@pytest.mark.parametrize(
    ("arguments", "meant"),
    [
        (("rendr", "paper"), "did you mean render?"),
        (("study", "exprot"), "did you mean export?"),
        (("render", "mine"), "did you mean mine.toml?"),
        (("render", "mien.toml"), "did you mean mine.toml?"),
        (("render", "mien"), "did you mean mine.toml?"),
        (("render", "MINE"), "did you mean mine.toml?"),
        (("grow", "mine"), "did you mean mine.toml?"),
        (("grow", "mine.tmol"), "did you mean mine.toml?"),
        (("scale", "answers"), "did you mean answers.csv?"),
        (("scale", "ANSWERS.csv"), "did you mean answers.csv?"),
        (
            ("scale", "answers.csv", "--modle", "logit"),
            "did you mean --model?; try: nacreous scale",
        ),
        (("study", "demo", "--fodler", "x"), "did you mean --folder?; try: nacreous study demo"),
        (("sheets", "out", "--only", "famlies-black"), "did you mean families-black?"),
        (("scale", "answer.csv"), "did you mean answers.csv?"),
        (("render", "paper", "--space", "srgp"), "did you mean srgb?"),
        (("study", "report", "mine-study"), "did you mean my-study?"),
    ],
)
def test_a_mistyped_command_action_file_or_choice_is_answered_with_the_one_meant(
    arguments: tuple[str, ...], meant: str, capsys: pytest.CaptureFixture[str]
) -> None:
    Path("mine.toml").touch()
    Path("my-study").mkdir()
    assert cli.main(arguments) == 2
    assert meant in capsys.readouterr().err
