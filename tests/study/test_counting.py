"""Export, report, the lab's page and `nacreous scale` agree on which answers count."""

from __future__ import annotations

import base64
import csv
import io
import json
import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest

import nacreous as nc
from nacreous import cli
from nacreous.problem import InputError
from nacreous.server.app import create_app
from nacreous.study.results import exported_answers, report
from nacreous.study.running import Running
from nacreous.study.store import Store, answers_of, counts, export
from nacreous.study.task import counting
from tests.server.people import Experimenter
from tests.support.gathering import by_scale, frozen_study, opened, take_part
from tests.support.server_process import NAME, PASSWORD, in_thread

SCALE = {"a": 0.6, "b": 0.2, "c": -0.2, "d": -0.6}
#: Pairs of four stimuli and two of them again; beside them one of practice and one catch.
DATA, ALL = 6 + 2, 6 + 2 + 1 + 1
KEYS: dict[str, Any] = {
    "pairs": {"repeats": 2},
    "sitting": {"training": 1, "ties": True},
    "catches": [{"expected": "a", "against": "d"}],
    "groups": [{"name": "real-pearl", "values": ["shown", "not-shown"]}],
}
PEOPLE, ROBOTS = 7, 6


@pytest.fixture(scope="module")
def running(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Running]:
    """People who count, one of them erased; and who was excluded, withdrew, or is simulated."""
    folder = tmp_path_factory.mktemp("counting")
    random = np.random.default_rng(5)
    frozen = frozen_study(folder, "abcd", **KEYS)
    with Store.open(frozen.folder) as store:
        made = opened(store, frozen)

        def part(**more: Any) -> str:
            choose = by_scale(SCALE, random)
            tied = lambda trial: "tie" if trial.number == 5 else choose(trial)  # noqa: E731
            number = take_part(made, tied, **more)
            return next(one.id for one in store.sessions(made.study) if one.number == number)

        people = [part() for _ in range(PEOPLE)]
        store.exclude(part(), "left the room", "lab")
        store.withdraw(part())
        for _ in range(ROBOTS):
            part(simulated=True)
        store.erase(people[0], "lab")
        yield made


@pytest.fixture(params=[False, True], ids=["people", "simulated"])
def simulated(request: pytest.FixtureRequest) -> bool:
    return bool(request.param)


def test_every_case_is_in_the_study(running: Running) -> None:
    rows = running.store.answers(running.study)
    assert len(rows) == (PEOPLE + 2 + ROBOTS) * ALL
    assert {row["kind"] for row in rows} == set(counting.KINDS)
    assert {row["excluded"] for row in rows} == {None, "left the room", "withdrew"}
    assert any(row["erased_as"] for row in rows)


def test_what_counts_is_data_of_people_who_are_in(running: Running, simulated: bool) -> None:
    answers = answers_of(running.store, running.study, "deeper", simulated=simulated)
    people = ROBOTS if simulated else PEOPLE
    assert (len(answers), len(answers.people)) == (people * DATA, people)


def test_the_four_ways_to_a_scale_agree(
    running: Running, simulated: bool, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    store, study = running.store, running.study
    wanted = counts(store, study, "deeper", simulated=simulated)

    # The export, and `nacreous scale` on it.
    found = {}
    for name in ("answers.csv", "answers.parquet"):
        export(store, study, tmp_path / name)
        exported = exported_answers(tmp_path / name, simulated=simulated)
        assert exported is not None
        np.testing.assert_array_equal(exported.comparisons().matrix, wanted.matrix)
        output = tmp_path / f"{name}.json"
        flags = ["--simulated"] if simulated else []
        told = ["scale", str(tmp_path / name), "--bootstrap", "0", "-o", str(output), *flags]
        assert cli.main(told) == 0
        found[name] = _scale_of(json.loads(output.read_text(encoding="utf-8")))
        assert f"{wanted.total:g} answers" in capsys.readouterr().out

    # The lab's page.
    store.set_password(NAME, PASSWORD, "test")
    with in_thread(create_app(running)) as url, httpx.Client(base_url=url, timeout=60) as client:
        page = Experimenter.login(client).get(f"scale?simulated={simulated}".lower()).json()
    assert (page["answers"], page["people"]) == (wanted.total, ROBOTS if simulated else PEOPLE)
    on_page = {one["label"]: one["value"] for one in page["stimuli"]}
    for scale in found.values():
        assert scale == pytest.approx(on_page, abs=1e-9)

    # The report carries its answers along.
    carried = csv.DictReader(io.StringIO(_carried(report(running, "deeper", simulated=simulated))))
    rows = list(carried)
    assert Counter(row["person"] for row in rows) == dict.fromkeys(
        {row["person"] for row in rows}, DATA
    )
    assert (
        nc.scaling.Answers.of_table(
            {name: [row[name] for row in rows] for name in ("left", "right", "chosen")},
            repeats=True,
        )
        .comparisons()
        .matrix.tolist()
        == wanted.matrix.tolist()
    )


def _scale_of(record: dict[str, Any]) -> dict[str, float]:
    """The places of stimuli in a file that `nacreous scale` wrote."""
    return {one["stimulus"]: one["scale"] for one in record["stimuli"]}


def _carried(page: str) -> str:
    """The answers that a report carries along."""
    found = re.search(
        r'download="answers.csv" href="data:text/csv;charset=utf-8;base64,([^"]+)', page
    )
    assert found
    return base64.b64decode(found[1]).decode()


def test_an_export_of_several_questions_is_asked_which(tmp_path: Path) -> None:
    words = {"en": "Which?", "ja": "どちら?"}
    questions = [{"id": "deeper", "text": words}, {"id": "rounder", "text": words}]
    frozen = frozen_study(tmp_path, "abc", questions=questions)
    with Store.open(frozen.folder) as store:
        running = opened(store, frozen)
        take_part(running, by_scale(SCALE, np.random.default_rng(1)))
        export(store, running.study, tmp_path / "answers.csv")
        wanted = counts(store, running.study, "rounder").matrix
    with pytest.raises(
        InputError,
        match=r"none is chosen; wanted: question=\"deeper\" or another of deeper, rounder",
    ):
        exported_answers(tmp_path / "answers.csv")
    read = exported_answers(tmp_path / "answers.csv", "rounder")
    assert read is not None
    np.testing.assert_array_equal(read.comparisons().matrix, wanted)


@pytest.mark.parametrize(
    ("column", "cell", "said"),
    [
        ("sequence", "abc", "row 2: sequence is 'abc'; allowed: a number"),
        ("sequence", "NA", "row 2: sequence is ''; allowed: a number"),
        ("response_ms", "fast", "row 2: response_ms is 'fast'; allowed: a number"),
        ("kind", "Pair", "row 2: kind is 'Pair'; allowed: training, pair, repeat, catch"),
        ("simulated", "perhaps", "row 2: simulated is 'perhaps'; allowed: true or false"),
        ("simulated", "NA", "row 2: simulated is ''; allowed: true or false"),
    ],
)
def test_a_spoiled_export_is_refused_in_one_line(
    running: Running, tmp_path: Path, column: str, cell: str, said: str
) -> None:
    path = _exported(running, tmp_path)
    head, first, *rest = path.read_text().splitlines()
    cells = next(csv.reader([first]))
    cells[next(csv.reader([head])).index(column)] = cell
    line = io.StringIO()
    csv.writer(line, lineterminator="\n").writerow(cells)
    path.write_text("\n".join([head, line.getvalue().strip(), *rest, ""]))
    with pytest.raises(InputError, match=f"answers.csv: {re.escape(said)}"):
        exported_answers(path)


@pytest.mark.parametrize(
    ("true", "false"),
    [
        *[("1", "0"), ("1.0", "0.0"), ("TRUE", "FALSE"), ("WAHR", "FALSCH"), ("VRAI", "FAUX")],
        *[("VERDADERO", "FALSO"), ("ＴＲＵＥ", "ＦＡＬＳＥ"), ("はい", "いいえ"), ("yes", "no")],
    ],
)
def test_true_and_false_are_read_as_spreadsheets_write_them(
    running: Running, tmp_path: Path, true: str, false: str
) -> None:
    path = _exported(running, tmp_path)
    before = exported_answers(path, simulated=True)
    text = path.read_text().replace(",true", f",{true}").replace(",false", f",{false}")
    path.write_text(text, encoding="utf-8")
    after = exported_answers(path, simulated=True)
    assert before is not None
    assert after is not None
    np.testing.assert_array_equal(after.comparisons().matrix, before.comparisons().matrix)
    assert f",{true}" in text


@pytest.mark.parametrize("word", ["NA", "NULL", "nan", "None", "#N/A", "#NV", "\\N", ".", "<NA>"])
def test_words_for_an_empty_cell_are_one_in_an_export(
    running: Running, tmp_path: Path, word: str
) -> None:
    path = _exported(running, tmp_path)
    before = exported_answers(path)
    rows = list(csv.reader(io.StringIO(path.read_text())))
    filled = [[cell or word for cell in row] for row in rows]
    with path.open("w", newline="") as text:
        csv.writer(text).writerows(filled)
    after = exported_answers(path)
    assert before is not None
    assert after is not None
    np.testing.assert_array_equal(after.comparisons().matrix, before.comparisons().matrix)
    assert filled != rows


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16"])
def test_an_export_saved_anew_by_a_spreadsheet_is_known(
    running: Running, tmp_path: Path, encoding: str
) -> None:
    """Semicolons, decimal commas, TRUE and FALSE, a mark: as where the decimal mark is a comma."""
    path = _exported(running, tmp_path)
    before = exported_answers(path, simulated=True)
    rows = list(csv.reader(io.StringIO(path.read_text())))
    times = rows[0].index("response_ms")
    for row in rows[1:]:
        row[times] = row[times].replace(".", ",")
    text = io.StringIO()
    csv.writer(text, delimiter=";").writerows(rows)
    saved = text.getvalue().replace(";true", ";TRUE").replace(";false", ";FALSE")
    path.write_bytes(saved.encode(encoding))
    after = exported_answers(path, simulated=True)
    assert before is not None
    assert after is not None
    assert len(after) == len(before)
    np.testing.assert_array_equal(after.comparisons().matrix, before.comparisons().matrix)


def test_options_of_other_tables_are_refused_with_an_export(
    running: Running, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = _exported(running, tmp_path)
    assert cli.main(["scale", str(path), "--repeats", "-o", str(tmp_path / "r.html")]) == 2
    assert "--repeats is given with an export of a study" in capsys.readouterr().err
    assert not (tmp_path / "r.html").exists()


def _exported(running: Running, folder: Path) -> Path:
    path = folder / "answers.csv"
    export(running.store, running.study, path)
    return path
