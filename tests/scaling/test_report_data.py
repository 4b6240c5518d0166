"""The data that a report carries."""

from __future__ import annotations

import base64
import json
import re

import numpy as np
import pytest

import nacreous as nc
from nacreous.scaling.report.chapters import method
from nacreous.scaling.report.translation import (
    LANGUAGES,
)
from tests.scaling.report_answers import survey


def carried(study, name: str) -> str:
    link = re.search(rf'download="{name}" href="data:[^,]*,([^"]*)"', study.text("a.html"))
    return base64.b64decode(link[1]).decode()


def test_the_answers_carried_in_the_page_make_the_page_again(tmp_path, answered):
    (tmp_path / "answers.csv").write_text(carried(answered, "answers.csv"), encoding="utf-8")
    again = nc.scaling.Answers.read(tmp_path / "answers.csv")
    found = nc.scaling.analyse(again, answered.settings)
    for language in LANGUAGES:
        assert found.text("a.html", language) == answered.text("a.html", language)


def test_the_counts_carried_in_the_page_make_the_scale_again(tmp_path):
    found = nc.scaling.analyse([[0, 30, 41], [20, 0, 33], [9, 17, 0]], bootstrap=100)
    (tmp_path / "counts.csv").write_text(carried(found, "counts.csv"), encoding="utf-8")
    again = nc.scaling.Comparisons.read_counts(tmp_path / "counts.csv")
    assert again.matrix.tolist() == found.comparisons.matrix.tolist()


def test_tables_carried_in_the_page_are_those_that_save_writes(tmp_path, paper):
    for name in ("scale.csv", "scale.json"):
        paper.save(tmp_path / name)
        assert (tmp_path / name).read_text(encoding="utf-8") == carried(paper, name)


def test_json_holds_no_nan_and_the_numbers_of_the_fit(answered, paper):
    found = json.loads(paper.text("a.json"))
    assert [row["stimulus"] for row in found["stimuli"]] == ["2", "4", "3", "1", "5", "6", "7"]
    assert found["reconstructed_from_the_published_table"] is True
    assert found["goodness"]["g2"] == pytest.approx(104.047, abs=1e-3)
    assert json.loads(answered.text("a.json"))["groups"]["tests"][0]["name"] == "permutation"
    assert "NaN" not in answered.text("a.json")


def test_large_data_stay_outside_the_page(monkeypatch):
    monkeypatch.setattr(method, "MOST_BYTES", 10)
    text = nc.scaling.analyse(survey(), bootstrap=100).text("a.html")
    assert "too many to be put into this page" in text
    assert 'download="answers.csv"' not in text


def test_many_stimuli_still_make_a_page_of_a_sensible_size():
    chance = np.random.default_rng(1)
    scale = np.sort(chance.normal(size=90))
    shares = 1 / (1 + np.exp(scale[None, :] - scale[:, None]))
    wins = chance.binomial(10, shares)
    counts = np.triu(wins, 1) + np.tril(10 - wins.T, -1)
    text = nc.scaling.analyse(counts, bootstrap=0, model="logit").text("a.html")
    assert "tables by pair are left out" in text
    assert "too many items to draw the margins" in text
    assert len(text) < 3_000_000
