"""`nacreous paper` as its users meet it."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from nacreous import cli, folder
from nacreous.paper import (
    make,
    pictures,
)
from nacreous.paper.pictures import Pictures
from nacreous.problem import InputError


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["paper"], "out"),
        (["paper", "OUT", "--size", "63"], "size is 63; allowed: 64 to 2048 pixels"),
        (["paper", "OUT", "--size", "4096"], "size is 4096; allowed: 64 to 2048 pixels"),
        (["paper", "OUT", "--size", "big"], "'big'"),
        (["paper", "file.txt"], "file.txt: is a file; wanted: a folder"),
        (["paper", "holiday"], "holiday: holds 'beach.jpg'; wanted: an empty folder, or one"),
        (["paper", "site"], "site: holds files but no measurements.json of nacreous paper"),
        (["paper", "missing/out"], "missing/out: the folder"),
        (["paper", "a\0b"], "cannot be written"),
    ],
)
def test_bad_calls_end_with_code_2_and_write_nothing(
    tmp_path: Path, monkeypatch: Any, capsys: Any, arguments: list[str], said: str
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("file.txt").write_text("mine")
    for place in ("holiday/beach.jpg", "site/index.html"):
        Path(place).parent.mkdir()
        Path(place).write_text("mine")
    before = sorted(tmp_path.rglob("*"))
    assert cli.main(arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert said in captured.err
    assert captured.err.count("nacreous: ") <= 2
    assert sorted(tmp_path.rglob("*")) == before
    assert Path("site/index.html").read_text() == "mine"


@pytest.mark.parametrize("exists", [False, True])
def test_an_interrupted_run_leaves_the_folder_as_it_was(tmp_path: Path, exists: bool) -> None:
    target = tmp_path / "out"
    if exists:
        target.mkdir()
    reports = []

    def report(share: float) -> None:
        reports.append(share)
        if share > 0.05:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        make.make(target, 64, report)
    assert [path.name for path in tmp_path.iterdir()] == (["out"] if exists else [])
    assert not exists or list(target.iterdir()) == []


def test_progress_grows_to_the_end(taken: Pictures, tmp_path: Path) -> None:
    shares: list[float] = []
    shots = pictures._Shots(taken.scene, 64, shares.append)
    shots.take([], 64, 16)
    shots.take([], 64, 16)
    assert shares == sorted(shares)
    assert 0 < shares[-1] <= 1


@pytest.mark.skipif(os.name != "posix", reason="sends a signal")
def test_ctrl_c_ends_with_code_130_and_leaves_nothing(tmp_path: Path) -> None:
    with subprocess.Popen(
        [sys.executable, "-m", "nacreous", "paper", "out", "--size", "2048"],
        cwd=tmp_path,
        stderr=subprocess.PIPE,
    ) as program:
        while not list(tmp_path.iterdir()):
            assert program.poll() is None
            time.sleep(0.02)
        time.sleep(0.2)
        program.send_signal(signal.SIGINT)
        assert program.stderr is not None
        assert program.stderr.read() == b"nacreous: interrupted; nothing was written\n"
    assert program.returncode == 130
    assert list(tmp_path.iterdir()) == []


def test_a_folder_takes_an_earlier_run_and_refuses_a_folder_with_more(tmp_path: Path) -> None:
    target = tmp_path / "out"
    for content in ("first", "second"):
        with folder.whole(target, ["a.txt", "run.json"], "run.json", "maker") as temporary:
            (temporary / "a.txt").write_text(content)
            (temporary / "run.json").write_text('{"made_by": "maker"}')
        assert (target / "a.txt").read_text() == content
    (target / ".nacreous-left-by-a-kill").mkdir()
    with folder.whole(target, ["a.txt", "run.json"], "run.json", "maker"):
        pass
    (target / "mine.txt").write_text("mine")
    with (
        pytest.raises(InputError, match=re.escape("holds 'mine.txt'")),
        folder.whole(target, ["a.txt", "run.json"], "run.json", "maker"),
    ):
        pass
    assert (target / "a.txt").read_text() == "second"
