"""`nacreous study report`: a page or one plain line, and no half files."""

from __future__ import annotations

import subprocess
from pathlib import Path
from typing import get_args

import numpy as np
import pytest

from nacreous.problem import InputError
from nacreous.scaling.report.translation import texts
from nacreous.study.results import report, scale_so_far
from nacreous.study.running.screen_check import ScreenCheck
from nacreous.study.running.screening import ScreenFlag
from nacreous.study.store import Store
from tests.support.documentation import COMMAND
from tests.support.gathering import by_scale, frozen_study, opened, take_part


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A study that simulated observers alone have answered."""
    frozen = frozen_study(tmp_path_factory.mktemp("report"), "abc")
    random = np.random.default_rng(8)
    with Store.open(frozen.folder) as store:
        running = opened(store, frozen)
        for _ in range(15):
            take_part(running, by_scale({"a": 0.5, "b": 0.0, "c": -0.5}, random), simulated=True)
    return frozen.folder


def told(*words: object) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [COMMAND, "study", "report", *map(str, words)], capture_output=True, text=True
    )


@pytest.mark.parametrize(("language", "titled"), [("en", "(simulated)"), ("ja", "どちらが深い?")])
def test_the_page_is_in_the_language_and_says_that_it_is_simulated(
    folder: Path, tmp_path: Path, language: str, titled: str
) -> None:
    output = tmp_path / "report.html"
    done = told(folder, "-o", output, "--simulated", "--language", language)
    assert done.returncode == 0, done.stderr
    assert done.stdout == f"{output}: written\n"
    page = output.read_text(encoding="utf-8")
    assert f'<html lang="{language}">' in page
    assert titled in page[: page.index("</title>")]


@pytest.mark.parametrize(
    ("language", "said"),
    [("en", "viewing distance out of range (1 person)"), ("ja", "観察距離が範囲外（1人）")],
)
def test_the_page_says_what_fell_short_of_the_screens(
    tmp_path: Path, language: str, said: str
) -> None:
    frozen = frozen_study(tmp_path, "abc", screen={"levels": False})
    random = np.random.default_rng(8)
    with Store.open(frozen.folder) as store:
        running = opened(store, frozen)
        for _ in range(12):
            take_part(running, by_scale({"a": 0.5, "b": 0.0, "c": -0.5}, random))
        first, *_, excluded = store.sessions(running.study)
        near = ScreenCheck(
            window={"width_px": 1600, "height_px": 900},
            full_screen=True,
            card={"px_per_mm": 4.0},
            distance_mm=90,
        )
        for session in (first, excluded):
            running.screen(session, near)
        running.store.exclude(excluded.id, "a test", "test")
        page = report(running, "deeper", language)
        assert said in page
    assert set(get_args(ScreenFlag)) == {
        key.removeprefix("screen.") for key in texts(language) if key.startswith("screen.")
    }


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ([], "no answers to 'deeper' count yet"),
        (["--simulated", "--question", "duller"], "question is 'duller'; allowed: deeper"),
        (["--simulated", "--question", "Deeper"], "question is 'Deeper'; did you mean deeper?"),
        (["--simulated", "--group", "age"], "group is 'age'; allowed: none"),
        (["-o", "report.pdf"], "report.pdf"),
    ],
)
def test_what_cannot_be_is_said_in_one_line_and_nothing_is_written(
    folder: Path, tmp_path: Path, options: list[str], said: str
) -> None:
    output = tmp_path / "report.html"
    done = told(folder, "-o", output, *options)
    assert done.returncode == 2
    assert said in done.stderr
    assert done.stderr.count("\n") == 1
    assert not output.exists()


def test_a_study_without_a_scale_is_told_nothing_of_a_prior_that_it_cannot_have(
    tmp_path: Path,
) -> None:
    frozen = frozen_study(tmp_path, "abc")
    with Store.open(frozen.folder) as store:
        running = opened(store, frozen)
        take_part(running, lambda trial: "left" if trial.stimuli[0] < trial.stimuli[1] else "right")
        for told_by in (report, scale_so_far):
            with pytest.raises(InputError, match="no scale holds") as caught:
                told_by(running, "deeper")
            assert str(caught.value).endswith("is preferred")


def test_a_folder_without_answers_is_not_given_any(folder: Path, tmp_path: Path) -> None:
    done = told(folder, "-o", tmp_path / "report.html", "--store", tmp_path / "none.sqlite")
    assert done.returncode == 2
    assert not (tmp_path / "none.sqlite").exists()


def test_one_person_alone_in_a_group_stops_neither_the_report_nor_the_other_groups(
    tmp_path: Path,
) -> None:
    asked = {"en": "Where?", "ja": "どこで?"}
    labs = ["kobe", "osaka", "tokyo"]
    groups = [{"name": "lab", "how": "recorded", "question": asked, "values": labs}]
    frozen = frozen_study(tmp_path, "abc", groups=groups)
    random = np.random.default_rng(8)
    with Store.open(frozen.folder) as store:
        running = opened(store, frozen)
        for lab in [*["osaka", "tokyo"] * 8, "kobe"]:
            take_part(running, by_scale({"a": 0.5, "b": 0.0, "c": -0.5}, random), {"lab": lab})
        for group in (None, "lab"):
            page = report(running, "deeper", group=group)
            assert "Not compared" in page
            assert '<b class="name">kobe</b>: 1 person' in page
            assert "the groups" in page.split('id="groups"')[1]
