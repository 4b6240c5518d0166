"""SIGTERM, as systems and `kill` send it: a command ends with 143, and no part of a file stays."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from pydantic import BaseModel, model_serializer

from nacreous.cli import main
from nacreous.stopping import Terminated, code_of

pytestmark = pytest.mark.skipif(
    sys.platform == "win32", reason="Windows ends programs without SIGTERM"
)

#: SIGTERM comes as the first file is whole and about to take its place, the latest that it may.
_AT_THE_LAST = """
import os, signal, sys
os.fsync = lambda _: os.kill(os.getpid(), signal.SIGTERM)
from nacreous import cli
cli.prepare()
sys.exit(cli.main())
"""
#: SIGTERM comes after a second of work.
_AT_WORK = """
import os, signal, sys, threading
from nacreous import cli
threading.Timer(1, os.kill, (os.getpid(), signal.SIGTERM)).start()
cli.prepare()
sys.exit(cli.main())
"""
_TINY = ["--size", "16", "--samples", "1"]
_HUGE = ["--size", "4096"]


def is_clean(program: str, words: list[str], here: Path) -> None:
    """Run the command in a folder of its own and see that SIGTERM ends it, and nothing stays."""
    lot = here / "lot.csv"
    rows = [f"{7 + n / 10},80,1,5,0.05" for n in range(3)]
    lot.write_text("\n".join(["size_mm,L,a,b,facet_spread_rad", *rows]) + "\n")
    folder = here / "folder"
    folder.mkdir()
    given = [str(lot) if word == "LOT" else word for word in words]
    done = subprocess.run(
        [sys.executable, "-c", program, *given],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert (done.returncode, list(folder.iterdir())) == (143, []), done.stderr
    assert done.stderr.endswith("nacreous: terminated; nothing was written\n")


@pytest.mark.parametrize(
    "words",
    [
        ["render", "akoya-rg", *_TINY, "-o", "p.png"],
        ["render", "akoya-rg", *_TINY, "-o", "p.exr"],
        ["card", "akoya-rg", *_TINY, "-o", "c.html"],
        ["card", "akoya-rg", *_TINY, "-o", "c.png"],
        ["strand", "draw", "--count", "3"],
        ["strand", "show", "LOT", *_TINY, "-o", "s.png"],
        ["grow", "akoya-rg", "-o", "g.csv"],
        ["scale", "paper", "-o", "r.csv", "-o", "r.json"],
    ],
    ids=" ".join,
)
def test_a_file_that_is_all_but_in_its_place_goes(words: list[str], tmp_path: Path) -> None:
    is_clean(_AT_THE_LAST, words, tmp_path)


@pytest.mark.parametrize(
    "words",
    [
        ["render", "akoya-rg", *_HUGE],
        ["card", "akoya-rg", *_HUGE],
        ["strand", "show", "LOT", *_HUGE, "-o", "s.png"],
        ["sheets", "out", "--only", "scenes", "--size", "1024"],
        ["turn", "akoya-rg", "--frames", "500", "-o", "t.webp"],
    ],
    ids=" ".join,
)
def test_work_ends_and_leaves_no_part_behind(words: list[str], tmp_path: Path) -> None:
    is_clean(_AT_WORK, words, tmp_path)


@pytest.mark.parametrize("stop", [KeyboardInterrupt, Terminated])
def test_a_signal_within_pydantic_ends_a_command_too(
    stop: type[BaseException], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    class Met(BaseModel):
        @model_serializer
        def signalled(self) -> None:
            raise stop

    monkeypatch.setattr("nacreous.cli._run", lambda arguments: Met().model_dump_json())
    assert main(["render"]) == code_of(stop())
    assert capsys.readouterr().err.endswith("; nothing was written\n")
