"""The scale of a study whose pairs were chosen by its answers: fitted as that choice asks for."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import polars as pl
import pytest

from nacreous import cli
from nacreous.problem import InputError
from nacreous.scaling import thurstone
from nacreous.study.results import exported_settings, report, scale_so_far
from nacreous.study.running import Running
from nacreous.study.store import Store, answers_of, export
from tests.support.gathering import by_scale, frozen_study, opened, take_part

SCALE = {"a": 0.9, "b": 0.3, "c": 0.0, "d": -0.3, "e": -0.9}
FIT = {"greedy": {"prior": "hierarchical"}, "drawn": {"method": "bias-reduced"}}
SAID = {
    ("greedy", "en"): "Pairs that are chosen by earlier answers make items look further apart",
    ("greedy", "ja"): "それまでの回答に応じて対を選ぶと",
    ("drawn", "en"): "The places are corrected for lying too far apart where answers are few",
    ("drawn", "ja"): "回答が少ないと位置が離れすぎる偏りを補正しています",
}


@pytest.fixture(scope="module", params=["greedy", "drawn", None], ids=str)
def choice(request: pytest.FixtureRequest) -> str | None:
    return request.param


@pytest.fixture(scope="module")
def running(choice: str | None, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    """Six people, one after the other; without a choice all see all pairs."""
    random = np.random.default_rng(3)
    pairs = {"kind": "adaptive", "number": 7, "choice": choice} if choice else {"kind": "all"}
    frozen = frozen_study(tmp_path_factory.mktemp("study"), "abcde", pairs=pairs)
    with Store.open(frozen.folder) as store:
        made = opened(store, frozen)
        for _ in range(6):
            take_part(made, by_scale(SCALE, random))
        yield made


def test_report_page_and_export_have_the_scale_that_the_choice_asks_for(
    running: Running, choice: str | None, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    answers = answers_of(running.store, running.study, "deeper")
    fit = thurstone(answers, **FIT.get(choice or "", {}))
    wanted = dict(zip(fit.stimuli, fit.scale, strict=True))
    page = scale_so_far(running, "deeper")
    assert {one.label: one.value for one in page.stimuli} == pytest.approx(wanted)
    export(running.store, running.study, tmp_path / "answers.csv")
    told = ["scale", str(tmp_path / "answers.csv"), "-o", str(tmp_path / "scale.json")]
    assert cli.main([*told, "--bootstrap", "0"]) == 0
    found = json.loads((tmp_path / "scale.json").read_text(encoding="utf-8"))
    assert {one["stimulus"]: one["scale"] for one in found["stimuli"]} == pytest.approx(wanted)
    how = {"greedy": "prior over the spread", "drawn": "bias-reduced"}
    assert how.get(choice or "", "maximum-likelihood") in capsys.readouterr().out
    for language in ("en", "ja"):
        text = report(running, "deeper", language)
        for (of, spoken), sentence in SAID.items():
            assert (sentence in text) == (of == choice and spoken == language)


def test_what_is_asked_for_goes_before_what_the_study_asks_for(
    running: Running, tmp_path: Path
) -> None:
    answers = answers_of(running.store, running.study, "deeper")
    export(running.store, running.study, tmp_path / "answers.csv")
    told = ["scale", str(tmp_path / "answers.csv"), "-o", str(tmp_path / "scale.json")]
    assert cli.main([*told, "--bootstrap", "0", "--prior", "0.5"]) == 0
    found = json.loads((tmp_path / "scale.json").read_text(encoding="utf-8"))
    fit = thurstone(answers, prior=0.5)
    wanted = dict(zip(fit.stimuli, fit.scale, strict=True))
    assert {one["stimulus"]: one["scale"] for one in found["stimuli"]} == pytest.approx(wanted)


def test_an_export_says_how_pairs_were_chosen_and_is_not_fitted_without(
    running: Running, choice: str | None, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "answers.csv"
    export(running.store, running.study, path)
    whole = pl.read_csv(path)
    assert set(whole["pairs_chosen_by"]) == {choice or "beforehand"}
    told = ["scale", str(path), "-o", str(tmp_path / "scale.json"), "--bootstrap", "0"]
    for column, said in (
        (pl.lit("by whim"), "pairs_chosen_by is 'by whim'; allowed: greedy, drawn, beforehand"),
        (pl.lit(""), "pairs_chosen_by is empty; wanted: the file as `nacreous study export` wrot"),
        (pl.lit("NA"), "pairs_chosen_by is empty; wanted: the file as"),
    ):
        whole.with_columns(column.alias("pairs_chosen_by")).write_csv(path)
        with pytest.raises(InputError, match=said):
            exported_settings(path)
    whole.drop("pairs_chosen_by").write_csv(path)
    assert cli.main(told) == 2
    assert "has no column pairs_chosen_by; wanted: the file as" in capsys.readouterr().err
    assert cli.main([*told, "--prior", "hierarchical"]) == 0


def test_a_manifest_without_the_choice_means_the_most_telling_pairs(running: Running) -> None:
    design = running.frozen.design
    older = design.model_dump(exclude_none=True)
    older["pairs"] = {"kind": "adaptive", "number": 7}
    made = type(design).check(older, "study.json", Path())
    assert made.pairs.chosen_by == "greedy"
    assert "choice" not in made.model_dump(exclude_none=True)["pairs"]


def test_an_end_that_no_answer_sets_is_none_on_the_page(tmp_path: Path) -> None:
    pairs = {"kind": "adaptive", "number": 7, "choice": "greedy"}
    frozen = frozen_study(tmp_path, "abcde", pairs=pairs)
    with Store.open(frozen.folder) as store:
        made = opened(store, frozen)
        for seed in range(4):
            one = by_scale({**SCALE, "a": 99.0}, np.random.default_rng(seed))
            take_part(made, one)
        found = {one.label: one for one in scale_so_far(made, "deeper").stimuli}
    assert [label for label, one in found.items() if one.high is None] == ["a"]
    assert {label for label, one in found.items() if one.low is None} == set("bcde")
