"""Lots as tables, and the command line."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import kstest, truncnorm

import nacreous as nc
from nacreous import cli
from nacreous.spec import Scene
from nacreous.strand import AKOYA, Form, Lot, read_lot, read_sorted, sort_lot, write_lot
from nacreous.strand.lot_file import write_sorted
from nacreous.strand.picture import hung, laid_out

HEAD = "name,size_mm,L,a,b,facet_spread_rad\n"
PLACED = f"strand,place,target_mm,{HEAD}"


def test_a_lot_is_read_as_it_was_written(tmp_path: Path) -> None:
    lot = AKOYA.draw(50, seed=1)
    names = ("=1+1", "'a", "真珠", *lot.names[3:])
    lot = Lot(names, np.round(lot.values, 5))
    write_lot(tmp_path / "lot.csv", lot)
    assert read_lot(tmp_path / "lot.csv") == lot


def test_sorted_strands_are_read_as_they_were_written(tmp_path: Path) -> None:
    lot = AKOYA.draw(50, seed=1)
    sorting = sort_lot(lot, Form(16, 0.3))
    write_sorted(tmp_path / "sorted.csv", lot, sorting)
    again, found = read_sorted(tmp_path / "sorted.csv")
    for one, other in zip(sorting.strands, found.strands, strict=True):
        assert lot.take(one.pearls).names == again.take(other.pearls).names
        assert other.matching.score == pytest.approx(one.matching.score, abs=1e-3)
    assert len(found.spare) == 2
    write_lot(tmp_path / "lot.csv", lot)
    assert len(read_sorted(tmp_path / "lot.csv")[1].strands) == 1


def test_instruments_columns_and_the_trades_words_are_understood(tmp_path: Path) -> None:
    path = tmp_path / "lot.csv"
    path.write_text("size_mm;L*;a*;b*;luster\n7,25;94;0,5;4;最上\n7,3;93,5;0;4;fair\n", "utf-8")
    assert read_lot(path).values.tolist() == [[7.25, 94, 0.5, 4, 0.018], [7.3, 93.5, 0, 4, 0.116]]
    assert read_lot(path).names == ("1", "2")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("size_mm,L,a\n7,94,1\n", "has no column b; .*no column facet_spread_rad or luster"),
        (HEAD + "a,77,94,1,2,.03\n", 'row 2: size_mm is "77"; allowed: 1 to 30'),
        (HEAD + "a,7,,1,2,.03\n", "row 2: L is empty; allowed: 0 to 100"),
        (HEAD + "a,7,x,1,2,.03\nb,7,,1,2,.03\nc,7,999,1,2,.03\n", "row 2: L is .*row 3.*row 4: L"),
        (HEAD + "a,7,x,1,2,3\n", 'L is "x"; allowed: a number.*facet_spread_rad is "3"'),
        (HEAD + "a,7,94,1,2,.03\na,7,94,1,2,.03\n", 'row 3: name is "a"; allowed: a name for'),
        ("size_mm,L,a,b,luster\n7,94,1,2,Excelent\n", 'row 2: luster is "Excelent"; did you mean'),
        ("strand,place," + HEAD + "1,1,a,7,94,1,2,.03\n", "has no column target_mm"),
        ("strand,place,target_mm," + HEAD + "1,,7,a,7,94,1,2,.03\n", "place or target_mm is empty"),
        (PLACED + "1.5,1,7,a,7,94,1,2,.03\n", "row 2: strand is 1.5; allowed: a whole"),
        (PLACED + "1,0,7,a,7,94,1,2,.03\n", "row 2: place is 0; allowed: a whole"),
        (PLACED + "1,1,7,a,7,94,1,2,.03\n", "row 2: strand is 1 for this pearl alone"),
        (
            PLACED + "1,1,7,a,7,94,1,2,.03\n1,1,7,b,7,94,1,2,.03\n",
            "row 3: place is 1 in strand 1 again; allowed: each once",
        ),
        (HEAD + "a,7,94,1,2,.03\n", "holds 1 pearl; allowed in a strand: at least two"),
        ("strand,place,target_mm," + HEAD + ",,,a,7,94,1,2,.03\n", "no pearl is in a strand"),
    ],
)
def test_a_bad_table_is_told_with_its_row(tmp_path: Path, text: str, said: str) -> None:
    path = tmp_path / "lot.csv"
    path.write_text(text)
    with pytest.raises(nc.InputError, match=f"(?s)lot.csv: .*{said}"):
        read_sorted(path)


def test_draw_sort_and_show_go_together(tmp_path: Path, capsys, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert cli.main(["strand", "draw", "--count", "60", "--mean", "size_mm=8"]) == 0
    assert cli.main(["strand", "sort", "lot.csv", "--length", "20", "-o", "sorted.csv"]) == 0
    said = capsys.readouterr().out
    assert "sorted.csv: 3 strands of 20 pearls, 0 left over" in said
    assert cli.main(["strand", "show", "sorted.csv", "--json"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert [one["strand"] for one in record["strands"]] == [1, 2, 3]
    scores = [one["score"] for one in record["strands"]]
    assert scores == sorted(scores)
    before = Path("sorted.csv").read_bytes()
    assert cli.main(["strand", "sort", "lot.csv", "--length", "20"]) == 0
    assert Path("sorted.csv").read_bytes() == before


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["draw", "--mean", "size=7"], "did you mean size_mm?"),
        (["draw", "--spread", "L"], '--spread "L": wanted: key=number'),
        (["draw", "--mean", "size_mm=nan"], "mean size_mm is nan; allowed: 1 to 30"),
        (["draw", "--count", "0"], "count is 0; allowed: a whole number, 1 to 5000"),
        (["sort", "lot.csv", "--length", "90"], "length is 90; allowed: up to 4, the lot's pearls"),
        (["sort", "lot.csv", "-o", "lot.csv"], "lot.csv"),
        (["show", "lot.csv", "--strand", "2"], "--strand 2; allowed: 1 to 1"),
        (["show", "lot.csv", "-o", "a.png", "--pearl", "paper"], "allowed: model = "),
        (["show", "lot.csv", "-o", "a.png", "--scene", "two-tier"], "has rows of its own"),
    ],
)
def test_mistakes_end_with_one_line_and_no_file(
    tmp_path: Path, capsys, monkeypatch, arguments: list[str], said: str
) -> None:
    monkeypatch.chdir(tmp_path)
    write_lot(Path("lot.csv"), AKOYA.draw(4))
    assert cli.main(["strand", *arguments]) == 2
    err = capsys.readouterr().err
    assert said in err
    assert err.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == ["lot.csv"]


def test_hung_pearls_have_their_sizes_lusters_and_nearest_colours() -> None:
    lot = Lot(("a", "b"), [[7.2, 97.3, -0.3, 0.8, 0.03], [7.4, 91.0, 0.9, 25.0, 0.05]])
    found = hung(lot, nc.Pearl.load("akoya-rg"), seed=5)
    assert [pearl.diameter_mm for pearl in found.pearls] == [7.2, 7.4]
    assert [pearl.surface.facet_spread_rad for pearl in found.pearls] == [0.03, 0.05]
    assert [pearl.body.pigment for pearl in found.pearls] == ["white", "gold"]
    assert [pearl.nacre.seed for pearl in found.pearls] == [5, 6]
    assert found.colour_off < 0.5


def test_neighbours_lie_side_by_side_in_rows_that_turn() -> None:
    rows = laid_out(7, Scene.load("north-window-black")).rows
    numbers = [[int(name[1:]) for name in row.pearls] for row in rows]
    assert numbers == [[0, 1, 2], [5, 4, 3], [6]]


def test_around_a_neck_lies_one_row_and_a_second_is_refused() -> None:
    scene = laid_out(5, Scene.load("north-window-black"), "neck")
    assert [(row.form, len(row.pearls)) for row in scene.rows] == [("neck", 5)]
    two = scene.replace(rows=(scene.rows[0], scene.rows[0]))
    pearls = [nc.Pearl.load("akoya-rg")] * 5
    with pytest.raises(nc.InputError, match=r"has 2 rows, one of them around a neck; allowed"):
        nc.render(pearls, two, size=16)
    with pytest.raises(nc.InputError, match='laid is "knot"; allowed: folds or neck'):
        laid_out(5, Scene.load("north-window-black"), "knot")


def test_a_strand_becomes_a_picture(tmp_path: Path) -> None:
    write_lot(tmp_path / "lot.csv", AKOYA.draw(4))
    output = tmp_path / "strand.png"
    options = ["--size", "24", "--samples", "1", "-o", str(output)]
    assert cli.main(["strand", "show", str(tmp_path / "lot.csv"), *options]) == 0
    assert output.read_bytes().startswith(b"\x89PNG")


def test_what_falls_out_of_the_range_is_drawn_again_as_a_truncated_normal() -> None:
    wide = AKOYA.replace({"size_mm": 29.0}, {"size_mm": 5.0})
    drawn = wide.draw(5000, seed=1).size_mm
    ends = (np.array([1.0, 30.0]) - 29) / 5
    assert drawn.max() < 30
    assert kstest(drawn, truncnorm(*ends, 29, 5).cdf).pvalue > 0.01
    assert np.array_equal(wide.draw(300, seed=1).size_mm, drawn[:300])
    with pytest.raises(nc.InputError, match=r"facet_spread_rad is 100, with which 1\.9% of the"):
        AKOYA.replace({}, {"facet_spread_rad": 100.0})


@pytest.mark.parametrize(
    ("columns", "cells", "said"),
    [
        ("L,L*,facet_spread_rad", "94,93,0.03", 'row 2: L\\* is "93" and L 94; allowed: both'),
        ("L,facet_spread_rad,luster", "94,0.3,Excellent", "row 2: luster is .*0.3; allowed: both"),
        ("L,L*,facet_spread_rad,luster", "94,94,0.03,上", None),
    ],
)
def test_one_quantity_said_twice_is_refused_unless_both_agree(
    columns: str, cells: str, said: str | None, tmp_path: Path
) -> None:
    path = tmp_path / "lot.csv"
    path.write_text(f"size_mm,a,b,{columns}\n7,1,2,{cells}\n", "utf-8")
    if said is None:
        assert read_lot(path).values[0, -1] == 0.03
        return
    with pytest.raises(nc.InputError, match=said):
        read_lot(path)


def test_a_lot_without_pearls_is_told_to_want_pearls(tmp_path: Path) -> None:
    (tmp_path / "lot.csv").write_text(HEAD)
    with pytest.raises(nc.InputError, match=r"has no rows; allowed: 1 to 5000 pearls"):
        read_lot(tmp_path / "lot.csv")


@pytest.mark.parametrize(
    "words", [["sort", "x.csv", "--graduated", "-1"], ["sort", "x.csv", "--length", "1"]]
)
def test_numbers_out_of_range_are_told_by_their_option(
    words: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["strand", *words]) == 2
    assert f"{words[2]} is {words[3]}; allowed" in capsys.readouterr().err


def test_pearls_in_folds_touch_along_the_thread_and_rows_lie_apart() -> None:
    scene = laid_out(7, Scene.load("north-window-black"), "folds", 7.4)
    assert scene.pitch_mm == 7.4
    assert scene.row_gap_mm > 1.1 * 7.4
