"""Exports: every row is there and says what it is; scales take what counts."""

import csv
import json
from collections.abc import Mapping
from datetime import UTC, datetime
from pathlib import Path
from typing import get_args

import numpy as np
import polars as pl
import pyarrow.parquet
import pytest
from pydantic import BaseModel

import nacreous as nc
from nacreous.problem import InputError
from nacreous.study.results import exported_answers
from nacreous.study.running.screen_check import (
    Card,
    Monitor,
    Plates,
    ScreenCheck,
    Vision,
    Window,
)
from nacreous.study.running.screening import ScreenFlag
from nacreous.study.store import Store, answers_of, counts, export
from nacreous.study.store.disclosure import SCREEN_CHECK
from tests.support.pairs import pair_answer

STUDY = "5e" * 32
AT = datetime(2026, 3, 1, 9, 30, tzinfo=UTC)


def fill(store: Store) -> None:
    """Five people: one as usual, one excluded, one erased, one simulated, one without groups."""
    store.add_study({"design_hash": STUDY, "design": {"name": "Akoya, 2 looks"}})
    store.set_registration(STUDY, "open", "lab")
    sessions = []
    for index in range(5):
        groups = {} if index == 4 else {"sex": "fm"[index % 2], "left": "handed"}
        session = store.enter(STUDY, "en", groups)[0].id
        sessions.append(session)
        store.consent(session)
        for trial, kind in enumerate(("training", "pair", "pair", "repeat", "catch")):
            left, right = ('a,\n"b"', "c") if trial % 2 else ("c", "真珠")
            chosen = "tie" if trial == 2 else "left"
            simulated = index == 3
            told = pair_answer(
                trial, "q", left, right, chosen, 500, AT, AT, {}, simulated, kind=kind
            )
            store.answer(session, told)
    store.exclude(sessions[1], "slept", "lab")
    store.erase(sessions[2], "lab")


@pytest.fixture
def store(place: str):
    with Store.open(place) as made:
        fill(made)
        yield made


@pytest.mark.parametrize("suffix", ["csv", "parquet"])
def test_every_row_is_there_and_marked(store: Store, tmp_path: Path, suffix: str) -> None:
    output = tmp_path / f"answers.{suffix}"
    assert export(store, STUDY, output) == 25
    read = pl.read_csv if suffix == "csv" else pl.read_parquet
    rows = read(output).to_dicts()
    assert len(rows) == 25
    assert sum(row["excluded"] == "slept" for row in rows) == 5
    assert sum(row["simulated"] for row in rows) == 5
    assert sum(row["erased"] for row in rows) == 5
    assert {row["group_left"] for row in rows} == {"handed", None}
    assert rows[1]["left"] == 'a,\n"b"'
    assert rows[1]["shown_at"] == "2026-03-01T09:30:00.000000Z"
    assert [row["sequence"] for row in rows] == sorted(row["sequence"] for row in rows)


def test_a_psych_ds_folder_describes_every_column(store: Store, tmp_path: Path) -> None:
    export(store, STUDY, tmp_path / "akoya")
    akoya = (tmp_path / "akoya").rglob("*")
    files = {str(path.relative_to(tmp_path)) for path in akoya if path.is_file()}
    kinds = ("", "_description-people", "_description-log")
    tables = [f"akoya/data/study-akoya2looks{kind}_data.csv" for kind in kinds]
    assert files == {"akoya/dataset_description.json", *tables}
    told = json.loads((tmp_path / "akoya/dataset_description.json").read_text(encoding="utf-8"))
    assert (told["@context"], told["@type"]) == ("https://schema.org", "Dataset")
    assert told["name"] == "Akoya, 2 looks"
    assert "1 people were erased; 5 answers of theirs" in told["description"]
    described = [variable["name"] for variable in told["variableMeasured"]]
    headers, rows = [], []
    for table in tables:
        with (tmp_path / table).open(encoding="utf-8", newline="") as stream:
            header, *lines = csv.reader(stream)
        headers.append(header)
        rows.append(len(lines))
        assert len({len(line) for line in lines}) == 1
    assert len(described) == len(set(described))
    assert set(described) == {name for header in headers for name in header}
    assert described[: len(headers[0])] == headers[0]
    assert rows == [25, 5, len(store.events(STUDY))]
    with pytest.raises(InputError, match="is there already"):
        export(store, STUDY, tmp_path / "akoya")


FORMULAS = ("=1+1", "+1", "-1", "@x", "'=1", "''-1", "＝1")
PLAIN = ("a-b", "'s", "1=1", "'", "a'=")


@pytest.mark.parametrize("suffix", ["csv", "parquet"])
def test_our_import_reads_every_label_and_level_back_as_it_was(
    place: str, tmp_path: Path, suffix: str
) -> None:
    labels = (*FORMULAS, *PLAIN)
    with Store.open(place) as store:
        store.add_study({"design_hash": STUDY})
        store.set_registration(STUDY, "open", "lab")
        for level in FORMULAS:
            session = store.enter(STUDY, "en", {"sex": level})[0].id
            store.consent(session)
            for trial, label in enumerate(labels[1:]):
                store.answer(session, pair_answer(trial, "q", labels[0], label, "left"))
        export(store, STUDY, tmp_path / f"answers.{suffix}")
        given = answers_of(store, STUDY, "q")
    read = exported_answers(tmp_path / f"answers.{suffix}")
    assert read is not None
    assert set(read.stimuli) == set(given.stimuli)
    assert read.groups["sex"].levels == given.groups["sex"].levels
    if suffix == "csv":
        rows = pl.read_csv(tmp_path / "answers.csv", infer_schema=False)
        assert set(rows["right"]) == {f"'{text}" for text in FORMULAS[1:]} | set(PLAIN)


def test_no_cell_of_text_begins_a_formula_in_a_spreadsheet(place: str, tmp_path: Path) -> None:
    with Store.open(place) as store:
        fill(store)
        for number, begin in enumerate(("=", "+", "-", "@", "\t=", "\r=", "\n=", "＠")):
            session = store.enter(STUDY, "en", {"sex": f"{begin}1"})[0].id
            store.consent(session)
            store.answer(session, pair_answer(0, "q", f"{begin}a", f"{number}", "left"))
            store.exclude(session, f"{begin}cmd|' /C calc'!A0", "lab")
        export(store, STUDY, tmp_path / "akoya")
    path = tmp_path / "akoya" / "data" / "study-akoya2looks_data.csv"
    with path.open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert sum(row["excluded"].startswith("'") for row in rows) == 8
    for row in rows:
        for text in row.values():
            assert not text or text[0] not in "=+-@\t\r\n＝＋－＠"
    told = json.loads((tmp_path / "akoya/dataset_description.json").read_text(encoding="utf-8"))
    assert "so that no spreadsheet takes it for a formula" in told["description"]


def test_a_byte_order_mark_is_there_on_request_and_alters_nothing(
    store: Store, tmp_path: Path
) -> None:
    export(store, STUDY, tmp_path / "plain.csv")
    export(store, STUDY, tmp_path / "bom.csv", bom=True)
    plain = (tmp_path / "plain.csv").read_bytes()
    assert (tmp_path / "bom.csv").read_bytes() == b"\xef\xbb\xbf" + plain
    found = [exported_answers(tmp_path / name) for name in ("plain.csv", "bom.csv")]
    assert found[0] == found[1]
    for other in ("answers.parquet", "folder"):
        with pytest.raises(InputError, match=r"bom is for \.csv files"):
            export(store, STUDY, tmp_path / other, bom=True)


def test_a_scale_takes_pairs_of_people_who_count(store: Store) -> None:
    answers = answers_of(store, STUDY, "q")
    # Three people (one of them erased) with two pairs and a repeat each.
    assert (len(answers), len(answers.people)) == (9, 3)
    assert answers.groups["sex"].levels == ("f",)
    counted = counts(store, STUDY, "q")
    assert counted.stimuli == answers.stimuli
    assert counted.total == 9
    assert np.sum(counted.ties) == 3
    assert len(answers_of(store, STUDY, "q", simulated=True)) == 3
    with pytest.raises(InputError, match="no answers to 'other' count yet"):
        counts(store, STUDY, "other")


def test_the_scale_of_a_store_is_the_scale_of_its_answers(place: str) -> None:
    paper = nc.scaling.paper()
    with Store.open(place) as store:
        store.add_study({"design_hash": STUDY})
        store.set_registration(STUDY, "open", "lab")
        session = store.enter(STUDY, "en", {})[0].id
        store.consent(session)
        pairs = [
            (paper.stimuli[left], paper.stimuli[right], chosen)
            for left, right, *wins in zip(
                paper.left, paper.right, paper.left_wins, paper.right_wins, strict=True
            )
            for chosen, count in zip(("left", "right"), wins, strict=True)
            for _ in range(int(count))
        ]
        futures = [
            store.hand_in(session, pair_answer(n, "q", left, right, chosen))
            for n, (left, right, chosen) in enumerate(pairs)
        ]
        assert not any(future.result().again for future in futures)
        found = nc.scaling.thurstone(counts(store, STUDY, "q"))
    expected = nc.scaling.thurstone(paper)
    assert found.stimuli == expected.stimuli
    np.testing.assert_allclose(found.scale, expected.scale, atol=1e-9)


def test_a_study_without_answers_has_a_header(place: str, tmp_path: Path) -> None:
    with Store.open(place) as store:
        store.add_study({"design_hash": STUDY})
        assert export(store, STUDY, tmp_path / "none.parquet") == 0
        assert pyarrow.parquet.read_table(tmp_path / "none.parquet").num_columns == 24
        with pytest.raises(InputError, match=r"the ending is \.xlsx"):
            export(store, STUDY, tmp_path / "none.xlsx")
        with pytest.raises(InputError, match="is not in this store"):
            export(store, "00" * 32, tmp_path / "none.csv")


SCREEN = {
    "window": {
        **{"width_px": 1920.0, "height_px": 1080.0, "note": "Mikimoto's laptop"},
        **{"gamut": "Toba", "at": "Ise", "flags": ["Shima"], "phone": 5551234},
    },
    "screen": "Tokyo",
    "card": {"px_per_mm": 4.0, "Mr Ago": True, "more": {"px_per_mm": "Ago"}},
    "Mr Kashiko": 1,
    "phone": 5551234,
    "darkest_step": 819012345678,
    "agent": "Firefox 131.0",
    "gamut": "p3",
    "gamma": 2.2,
    "distance_tries_mm": [510.0, 530.0],
    "remark": "call me on 555-1234",
    "remarks": ["my name is Kokichi"],
    "flags": ["no-card"],
}
#: What was sent with an answer; only the first is of our pages.
NOTICED = {"away": 2, "early": "Nagasaki", "shrunk": [1], "Mr Omura": True, "fax": 5554321}
FREE = (
    *("laptop", "131.0", "555-1234", "Kokichi", "Mr Mikimoto", "Toba", "Ise", "Shima", "5551234"),
    *("Tokyo", "Ago", "Kashiko", "819012345678", "Nagasaki", "Omura", "5554321"),
)


@pytest.mark.parametrize("suffix", [".csv", ".parquet", ""])
def test_all_that_is_collected_of_people_is_exported_and_what_identifies_on_request_alone(
    place: str, tmp_path: Path, suffix: str
) -> None:
    plain, whole = tmp_path / f"plain{suffix}", tmp_path / f"whole{suffix}"
    with Store.open(place) as store:
        store.add_study({"design_hash": STUDY})
        [token] = store.invite(STUDY, 1, "Mr Mikimoto", "lab")
        session = store.enter(STUDY, "en", {"browser": "real"}, token)[0].id
        store.consent(session)
        store.screen(session, {"gamma": 1.0})
        store.screen(session, SCREEN)
        store.answer(session, pair_answer(0, "q", "a", "b", "left", flags=NOTICED))
        store.finish(session)
        known = store.session(session)
        export(store, STUDY, plain)
        export(store, STUDY, whole, identifying=True)
    paths = [
        path if suffix else min((path / "data").iterdir(), key=lambda one: len(one.name))
        for path in (plain, whole)
    ]
    read = pl.read_parquet if suffix == ".parquet" else pl.read_csv
    [row], [more] = (read(path).to_dicts() for path in paths)
    for name in ("consented_at", "finished_at"):
        assert datetime.fromisoformat(row[name]) == getattr(known, name)
    assert datetime.fromisoformat(row["entered_at"]) == known.started_at
    assert (row["browser"], row["group_browser"]) == ("Firefox", "real")
    first, last = json.loads(row["screen_checks"])
    assert first["gamma"] == 1.0
    kept = {name: last[name] for name in ("gamut", "gamma", "distance_tries_mm", "flags")}
    assert kept == {name: SCREEN[name] for name in kept}
    assert last["window"] == {"width_px": 1920.0, "height_px": 1080.0}
    assert last["card"] == {"px_per_mm": 4.0}
    assert json.loads(row["flags"]) == {"away": 2}
    assert not any(text in str(row) for text in FREE)
    assert json.loads(more["flags"]) == NOTICED
    assert (more["browser_name"], more["invitation"]) == ("Firefox 131.0", "Mr Mikimoto")
    assert {**json.loads(more["screen_checks"])[1], "at": None} == {**SCREEN, "at": None}
    assert paths[1].stat().st_mode & 0o077 == 0
    exported = exported_answers(paths[1])
    assert exported is not None
    assert list(exported.groups) == ["group_browser"]


def test_every_measurement_of_our_pages_is_in_every_export() -> None:
    def keys(model: type[BaseModel]) -> dict[str, object]:
        tables = {"window": Window, "screen": Monitor, "card": Card, "vision": Vision}
        plates = {"contrast": Plates, "colour": Plates}
        inner = tables if model is ScreenCheck else plates if model is Vision else {}
        return {name: keys(inner[name]) if name in inner else None for name in model.model_fields}

    def told(shape: object) -> object:
        if not isinstance(shape, Mapping):
            return None
        return {name: told(one) for name, one in shape.items()}

    told_of_check = told({name: SCREEN_CHECK[name] for name in SCREEN_CHECK if name != "flags"})
    wanted = keys(ScreenCheck)
    wanted.pop("agent")  # its family is a column of its own
    assert told_of_check == wanted
    assert SCREEN_CHECK["flags"] == frozenset(get_args(ScreenFlag))
    for name in ("distance_by", "gamut"):
        words = [get_args(one) for one in get_args(ScreenCheck.model_fields[name].annotation)]
        assert SCREEN_CHECK[name] == frozenset(word for some in words for word in some)


def test_nothing_of_an_erased_person_is_exported_with_the_answers(
    store: Store, tmp_path: Path
) -> None:
    export(store, STUDY, tmp_path / "a.csv", identifying=True)
    for row in pl.read_csv(tmp_path / "a.csv").filter(pl.col("erased")).to_dicts():
        for name in ("entered_at", "finished_at", "browser", "screen_checks", "browser_name"):
            assert row[name] is None
