"""What the tests leave out, and what they leave behind."""

import ast
import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

pytest_plugins = ["pytester"]

ROOT = Path(__file__).parents[2]
SOURCES = sorted((ROOT / "tests").rglob("*.py"))


def calls(name: str) -> Iterator[tuple[str, ast.Call]]:
    """Each call of `name`, with the file it is in."""
    for path in SOURCES:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and ast.unparse(node.func) == name:
                yield path.relative_to(ROOT).as_posix(), node


def test_a_test_that_leaves_itself_out_says_what_brings_it_back() -> None:
    """As `no PostgreSQL here:   sudo apt install postgresql`."""
    silent = [
        f"{path}:{call.lineno}"
        for path, call in calls("pytest.skip")
        if ":   " not in ast.unparse(call)
    ]
    assert silent == []


def test_temporary_folders_are_of_the_kind_that_removes_itself() -> None:
    found = [path for name in ("tempfile.mkdtemp", "mkdtemp") for path, _ in calls(name)]
    assert found == ["tests/support/database.py"]  # which belongs to the server's own user


def test_what_is_left_out_is_told_by_its_reason_and_noted_for_the_end(
    pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    noted = tmp_path / "left out"
    monkeypatch.setenv("NACREOUS_LEFT_OUT", str(noted))
    pytester.makeconftest((ROOT / "conftest.py").read_text(encoding="utf-8"))
    pytester.makepyfile(
        """
        import pytest

        @pytest.mark.parametrize("case", range(3))
        def test_of_a_database(case):
            pytest.skip("no database here:   sudo apt install database")

        def test_of_a_browser():
            pytest.skip("no browser here:   sudo apt install browser")

        def test_that_runs():
            pass
        """
    )
    output = pytester.runpytest_inprocess("-p", "no:cacheprovider").stdout
    lines = [
        "3 tests: no database here:   sudo apt install database",
        "1 test: no browser here:   sudo apt install browser",
    ]
    output.fnmatch_lines(["*= left out =*", *lines])
    assert noted.read_text(encoding="utf-8").splitlines() == lines


@pytest.fixture
def every_part(tmp_path: Path) -> subprocess.CompletedProcess[str]:
    """tests/every-part with four tasks, of which the first fails and the third leaves out."""
    just = tmp_path / "bin" / "just"
    just.parent.mkdir()
    just.write_text(
        "#!/bin/sh\n"
        'case "$1" in\n'
        "    lint) exit 3 ;;\n"
        '    _pages) exec tests/every-part --left-out "pages: no Node.js here" ;;\n'
        "esac\n"
    )
    just.chmod(0o755)
    (tmp_path / "temporary").mkdir()
    return subprocess.run(
        ["tests/every-part", "lint", "rust", "_pages", "python"],
        cwd=ROOT,
        env={"PATH": f"{just.parent}:{os.environ['PATH']}", "TMPDIR": str(tmp_path / "temporary")},
        capture_output=True,
        text=True,
        check=False,
    )


def test_a_part_that_fails_hides_no_other(
    every_part: subprocess.CompletedProcess[str], tmp_path: Path
) -> None:
    table, _, end = every_part.stdout.partition("Left out:\n")
    told = [line.split()[:2] for line in table.splitlines() if line]
    assert told == [
        ["lint", "FAILED"],
        ["rust", "passed"],
        ["pages", "passed"],
        ["python", "passed"],
    ]
    assert end == "  pages: no Node.js here\nFailed: lint\n"
    assert every_part.returncode == 1
    assert list((tmp_path / "temporary").iterdir()) == []


@pytest.mark.parametrize("status", [0, 7])
def test_a_temporary_folder_goes_with_the_command_it_is_for(tmp_path: Path, status: int) -> None:
    done = subprocess.run(
        [ROOT / "tests/own-temporary-folder", "sh", "-c", f'echo >"$TMPDIR/left"; exit {status}'],
        env=os.environ | {"TMPDIR": str(tmp_path)},
        check=False,
    )
    assert done.returncode == status
    assert list(tmp_path.iterdir()) == []
