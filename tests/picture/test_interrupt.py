"""Progress, and the wish to stop."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

import pytest

import nacreous as nc
from nacreous.spec import Pearl, Scene
from tests.picture.stage import pearl
from tests.support.terminal import at_terminal


def test_progress_rises_from_0_to_1() -> None:
    shares: list[float] = []
    nc.render(pearl(), "paper", 256, 16, progress=shares.append)
    assert len(shares) > 3
    assert shares == sorted(shares)
    assert 0 <= shares[0] < shares[-1] <= 1


def test_what_progress_raises_stops_the_render() -> None:
    class EnoughError(Exception):
        pass

    def stop(share: float) -> None:
        if share > 0:
            raise EnoughError

    begin = time.monotonic()
    with pytest.raises(EnoughError):
        nc.render(pearl(), "paper", 2048, 64, progress=stop)
    assert time.monotonic() - begin < 5


def test_hundreds_of_pearls_need_not_be_lit_before_the_render_stops() -> None:
    """The light around each is worked out before the first row; all 225 take many times as long."""
    scene = Scene(
        rows=[{"pearls": ["*"] * 15}] * 15, camera={"distance_mm": 2000, "elevation_deg": 60}
    )
    begin = time.monotonic()
    asked: list[float] = []

    def stop(share: float) -> None:
        if share == 0 and time.monotonic() - begin > 0.5:  # past the film, amid the pearls
            asked.append(time.monotonic())
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        nc.render(Pearl(grain=0), scene, 64, 1, progress=stop)
    assert time.monotonic() - asked[0] < 1.5


def test_ctrl_c_ends_a_big_render_at_once_and_leaves_nothing(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "nacreous", "render", "paper", "--size", "4096"]
    with at_terminal([*command, "--samples", "64", "-o", "x.png"], tmp_path) as watched:
        watched.shows(b"rendering [")
        code, seconds = watched.interrupted()
        assert (code, seconds < 2) == (130, True), seconds
        shown = watched.shows(b"nothing was written")
        assert shown.endswith(b"nacreous: interrupted; nothing was written\r\n")
    assert not list(tmp_path.iterdir())


def test_ctrl_c_is_heard_without_anybody_watching() -> None:
    program = """
import os, signal, threading, time, nacreous as nc
def interrupt():
    global begin
    begin = time.monotonic()
    os.kill(os.getpid(), signal.SIGINT)
threading.Timer(0.5, interrupt).start()
try:
    nc.render("paper", size=4096, samples=64)
except KeyboardInterrupt:
    print(time.monotonic() - begin)
"""
    done = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True)
    assert float(done.stdout) < 2
