"""Who is excluded in an export that somebody filled in anew, and what is said where none counts."""

import csv
from pathlib import Path

import numpy as np
import pytest

from nacreous.problem import InputError
from nacreous.study.results import exported_answers
from nacreous.study.store import Store, export
from nacreous.study.store.check import reason
from tests.support.gathering import by_scale, frozen_study, opened, take_part

SCALE = {"a": 0.5, "b": 0.0, "c": -0.5}
NO = ("no", "FALSE", "0", "NEIN", "いいえ", "faux", "Off", "0.0")
YES = ("yes", "TRUE", "1", "JA", "はい", "slept")


@pytest.fixture(scope="module")
def rows(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, str]]:
    """The rows of an export with three people, without their practice."""
    folder = tmp_path_factory.mktemp("made")
    frozen = frozen_study(folder, "abc")
    with Store.open(frozen.folder) as store:
        running = opened(store, frozen)
        for _ in range(3):
            take_part(running, by_scale(SCALE, np.random.default_rng(8)))
        export(store, running.study, folder / "out.csv")
    lines = (folder / "out.csv").read_text("utf-8").splitlines()
    return [row for row in csv.DictReader(lines) if row["kind"] != "training"]


def saved(rows: list[dict[str, str]], path: Path) -> Path:
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    return path


@pytest.mark.parametrize("word", NO)
def test_a_word_for_no_in_excluded_is_refused_by_row(
    rows: list[dict[str, str]], word: str, tmp_path: Path
) -> None:
    changed = [dict(row) for row in rows]
    changed[1]["excluded"] = word
    with pytest.raises(InputError, match=r"row 3: excluded is .*wanted: an empty cell") as caught:
        exported_answers(saved(changed, tmp_path / "no.csv"))
    assert len(str(caught.value).splitlines()) == 1


@pytest.mark.parametrize("word", YES)
def test_a_word_for_yes_in_excluded_leaves_out_those_answers_alone(
    rows: list[dict[str, str]], word: str, tmp_path: Path
) -> None:
    changed = [row | {"excluded": word if row["person"] == "1" else ""} for row in rows]
    answers = exported_answers(saved(changed, tmp_path / "yes.csv"))
    assert answers is not None
    assert len(answers) == sum(row["person"] != "1" for row in rows)
    assert "1" not in answers.people


def test_where_no_answer_counts_it_is_said_how_many_do_not_and_why(
    rows: list[dict[str, str]], tmp_path: Path
) -> None:
    three = [row | {"excluded": "yes"} for row in rows]
    said = f"count: {len(rows)} of excluded people; wanted: at least one that does"
    with pytest.raises(InputError, match=said):
        exported_answers(saved(three, tmp_path / "all.csv"))
    three[0] |= {"kind": "training"}
    three[1] |= {"kind": "catch"}
    three[2] |= {"simulated": "true", "excluded": ""}
    with pytest.raises(InputError) as caught:
        exported_answers(saved(three, tmp_path / "mixed.csv"))
    assert (
        f"1 of practice, 1 of catch trials, 1 of simulated observers, {len(rows) - 3} of excluded "
        "people; wanted: at least one that does; those of simulated observers do with --simulated"
    ) in str(caught.value)
    with pytest.raises(InputError, match=r"of people; .*those of people do without --simulated"):
        exported_answers(saved(rows, tmp_path / "people.csv"), simulated=True)


@pytest.mark.parametrize("word", NO)
def test_a_reason_for_an_exclusion_is_no_word_for_no(word: str) -> None:
    with pytest.raises(InputError, match="a word for no; wanted: a reason"):
        reason(word)
