"""The report and the command say before the scale that people do not share it, and only then."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous.cli import main
from nacreous.scaling.report.chapters import people
from nacreous.scaling.report.translation import Words
from tests.scaling.test_covariate import two_ages
from tests.scaling.test_shared import TRUTH, together

CAMPS = Path(__file__).with_name("camps.csv")


@pytest.fixture(scope="module")
def camps():
    return nc.scaling.analyse(nc.scaling.Answers.read(CAMPS), bootstrap=100)


@pytest.fixture(scope="module")
def alike():
    return nc.scaling.analyse(nc.scaling.simulate(TRUTH, 40, seed=1), bootstrap=0)


def test_camps_are_said_before_the_scale(camps):
    page = camps.text("report.html")
    first = page.index("People do not share one scale")
    assert (
        page.index('<section id="short">')
        < first
        < page.index("No two items differ by more than chance")
    )
    assert "2 classes" in page
    assert page.index('<section id="people">') < page.index('<section id="scale">')
    assert "One scale describes the answers" not in page
    assert "Taken together, the answers follow the scale" in page


def test_camps_are_said_in_japanese(camps):
    page = camps.text("report.html", "ja")
    first = page.index("全員に共通する一つの尺度はありません")
    assert first < page.index("対象どうしの差はどれも偶然の範囲内で")
    assert "人々は2つのクラスに分かれ" in page
    assert "回答は一つの尺度でよく表せます" not in page


def test_people_who_are_alike_come_after_the_scale(alike):
    page = alike.text("report.html")
    assert not alike.people_differ
    assert page.index('<section id="people">') > page.index('<section id="scale">')
    assert "People do not share one scale" not in page


def test_counts_say_nothing_of_single_people():
    counts = nc.scaling.simulate(TRUTH, 40, seed=1).comparisons()
    page = nc.scaling.analyse(counts, bootstrap=0).text("report.html")
    assert "Whether each person judges by it, they cannot tell" in page
    assert 'id="people"' not in page


def test_the_other_way_round_is_said_apart_from_other_orders():
    words = Words("en")
    few = together(
        nc.scaling.simulate(TRUTH, 55, seed=1), nc.scaling.simulate(-1.5 * TRUTH, 5, seed=2)
    )
    said = people.chapter(nc.scaling.analyse(few, bootstrap=0), words)
    assert "Sharper, or the other way round" in said
    spread = nc.scaling.simulate(TRUTH, 104, person_spread=0.3, seed=2)
    said = people.chapter(nc.scaling.analyse(spread, bootstrap=0), words)
    assert "Other order" in said
    assert "the other way round" not in said
    assert "Classes of people describe them no better" in said


def test_a_column_of_people_that_goes_with_their_scales_is_named():
    found = nc.scaling.analyse(two_ages(1), bootstrap=0)
    said = people.chapter(found, Words("en"))
    row = said[said.index('<th scope="row"><b class="name">age</b>') :]
    assert "yes" in row[: row.index("</tr>")]


def test_the_record_has_the_test_and_the_classes_and_no_label_of_a_person(camps):
    found = json.loads(camps.text("scale.json"))["one_scale_for_all_people"]
    assert found["differ"] is True
    assert found["test"]["p_value"] == 0.001
    assert [one["people"] for one in found["classes_in_own_unit"]] == [30, 30]
    assert '"p12"' not in json.dumps(found)


def test_the_command_says_first_that_people_do_not_share_one_scale(tmp_path, capsys):
    output = tmp_path / "scale.csv"
    assert main(["scale", str(CAMPS), "-o", str(output), "--bootstrap", "0"]) == 0
    first, second, third, *_ = capsys.readouterr().out.splitlines()
    assert first.startswith("people do not share one scale, p 0.001")
    assert second == "2 classes of people: 0.50, 0.50; correlation -1.00"
    assert third.startswith("1260 answers")


def test_print_says_first_that_people_do_not_share_one_scale():
    answers = nc.scaling.Answers.read(CAMPS)
    for fit in (
        nc.scaling.thurstone(answers),
        nc.scaling.bradley_terry(answers).to("logit"),
        nc.scaling.thurstone(answers, method="least-squares"),
    ):
        first, second, *_ = str(fit).splitlines()
        assert first.startswith("people do not share one scale, p 0.001")
        assert second.startswith("scale in ")
        assert str(fit) == str(fit)


def test_print_says_nothing_of_people_who_are_alike_or_unknown(alike):
    for fit in (alike.fit, nc.scaling.thurstone(nc.scaling.Answers.read(CAMPS).comparisons())):
        assert str(fit).startswith("scale in z")


def test_print_says_what_it_does_not_test(camps, monkeypatch):
    monkeypatch.setattr("nacreous.scaling.fit.summary._MOST_DEALT", 98)
    first = str(camps.fit).splitlines()[0]
    assert first == "whether people share one scale was not tested here; shared_scale(answers) does"


def test_camps_differ_at_a_strict_level_too():
    found = nc.scaling.analyse(nc.scaling.Answers.read(CAMPS), bootstrap=0, level=0.999)
    assert found.people_differ


def test_spread_in_the_report_is_in_the_unit_of_the_scale():
    study = nc.scaling.simulate(TRUTH, 60, person_spread=0.8, seed=4)
    own = nc.scaling.analyse(study, bootstrap=0)
    other = nc.scaling.analyse(study, bootstrap=0, unit="JOD")
    spread = own.people.population.spread
    for found, times in ((own, 1.0), (other, 1.4826)):
        assert f"{np.round(spread * times, 2):.2f}" in people.chapter(found, Words("en"))


def test_what_was_read_as_nothing_or_by_a_guess_is_told(tmp_path, capsys):
    lines = CAMPS.read_text().splitlines()
    rows = [
        "年齢,視力,目",
        *(f"{cells},{'lr'[k // 21 % 2]}" for k, cells in enumerate(aged(lines))),
    ]
    path = tmp_path / "a.csv"
    table = "\n".join(f"{a},{b}" for a, b in zip(lines, rows, strict=True))
    path.write_bytes(table.encode("cp932"))
    outputs = [option for name in ("a.html", "a.json") for option in ("-o", str(tmp_path / name))]
    assert main(["scale", str(path), *outputs, "--bootstrap", "0"]) == 0
    said = capsys.readouterr().out
    assert "read as Shift-JIS, a guess; --encoding names this or another\n" in said
    assert 'read as empty: "NA" in column 年齢\n' in said
    assert 'column 視力 is not compared between people: beside numbers it holds "?"' in said
    page = (tmp_path / "a.html").read_text()
    assert "The file was read as Shift-JIS, a guess" in page
    assert "Read as empty cells: " in page
    assert " stands beside numbers." in page
    (told,) = json.loads((tmp_path / "a.json").read_text())["one_scale_for_all_people"][
        "columns_not_compared"
    ]
    assert (told["column"], told["reason"], told["cells"]) == ("視力", "no numbers", ["?"])


def aged(lines: list[str]) -> list[str]:
    """Cells of age and eyesight a row, of one person NA and a question mark."""
    people = [line.split(",")[0] for line in lines[1:]]
    own = {
        person: f"{20 + at},{0.8 + at / 100:g}" for at, person in enumerate(dict.fromkeys(people))
    }
    own[people[0]] = "NA,?"
    return [own[person] for person in people]
