"""Nothing that is read is ever written over, by whatever name or link."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous import cli
from nacreous.problem import InputError
from nacreous.study.store import Store, backup, export

ANSWERS = "left,right,chosen\na,b,a\nb,c,b\nc,a,c\na,b,b\n"


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("answers.csv").write_text(ANSWERS, "utf-8")
    return tmp_path


def refused(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    assert cli.main(arguments) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1
    return said.err


@pytest.mark.parametrize("kind", ["same", "dotted", "symbolic", "hard", "through"])
def test_answers_are_not_written_over_by_their_scale(
    kind: str, capsys: pytest.CaptureFixture[str]
) -> None:
    given, output = "answers.csv", "other.csv"
    if kind == "same":
        output = given
    elif kind == "dotted":
        output = "./answers.csv"
    elif kind == "symbolic":
        Path(output).symlink_to(given)
    elif kind == "hard":
        os.link(given, output)
    else:
        Path("away").symlink_to(".", target_is_directory=True)
        output = "away/answers.csv"
    said = refused(capsys, "scale", given, "--bootstrap", "0", "-o", output)
    assert said == (
        f"nacreous: {output}: is the same file as the input {given}; allowed: another name\n"
    )
    assert Path(given).read_text("utf-8") == ANSWERS


def test_answers_from_a_redirected_file_are_not_written_over() -> None:
    with Path("answers.csv").open("rb") as stream:
        done = subprocess.run(
            [sys.executable, "-m", "nacreous", "scale", "-", "-o", "answers.csv"],
            stdin=stream,
            capture_output=True,
            check=False,
        )
    assert done.returncode == 2
    assert b"the same file as standard input" in done.stderr
    assert Path("answers.csv").read_text("utf-8") == ANSWERS


@pytest.mark.parametrize("second", ["report.html", "./report.html", "link.html"])
def test_two_outputs_are_not_one_file(second: str, capsys: pytest.CaptureFixture[str]) -> None:
    Path("link.html").symlink_to("report.html")
    said = refused(capsys, "scale", "answers.csv", "-o", "report.html", "-o", second)
    assert "is the same file as the output report.html" in said
    assert not Path("report.html").exists()


def test_standard_output_takes_one_table(capsys: pytest.CaptureFixture[str]) -> None:
    assert "allowed: once" in refused(capsys, "scale", "answers.csv", "-o", "-", "-o", "-")


def test_a_picture_is_not_made_again_over_itself(capsys: pytest.CaptureFixture[str]) -> None:
    nc.render("paper", size=8, samples=1).save("pearl.png")
    before = Path("pearl.png").read_bytes()
    assert "the input pearl.png" in refused(capsys, "render", "pearl.png", "-o", "pearl.png")
    assert Path("pearl.png").read_bytes() == before


def test_a_photograph_that_a_pearl_names_is_not_painted_over(
    capsys: pytest.CaptureFixture[str],
) -> None:
    pixels = np.random.default_rng(1).integers(90, 250, (200, 200, 3)).astype(np.uint8)
    nc._core.write_png("photograph.png", pixels, "srgb", [])
    before = Path("photograph.png").read_bytes()
    Path("my.toml").write_text('[texture]\nsource = "photograph.png"\n', "utf-8")
    said = refused(capsys, "render", "my.toml", "--size", "8", "-o", "photograph.png")
    assert "is the same file as the input" in said
    assert Path("photograph.png").read_bytes() == before


def test_a_pearl_file_is_not_written_over_by_its_growth(
    capsys: pytest.CaptureFixture[str],
) -> None:
    Path("my.toml").write_text("depth = 0.8\n", "utf-8")
    Path("growth.png").symlink_to("my.toml")
    assert "the input my.toml" in refused(capsys, "grow", "my.toml")
    assert Path("my.toml").read_text("utf-8") == "depth = 0.8\n"


def test_a_crop_is_not_cut_over_itself(capsys: pytest.CaptureFixture[str]) -> None:
    nc.render("paper", size=64, samples=1).save("pearl.png")
    assert cli.main(["crops", "pearl.png", "-o", "parts"]) == 0
    capsys.readouterr()
    before = Path("parts/crop-1.png").read_bytes()
    said = refused(capsys, "crops", "parts/crop-1.png", "-o", "parts")
    assert "is the same file as the input" in said
    assert Path("parts/crop-1.png").read_bytes() == before


@pytest.mark.parametrize("ending", [".sqlite", ".csv"])
def test_a_store_is_not_written_over_by_what_comes_out_of_it(ending: str) -> None:
    place = f"store{ending}"
    with Store.open(place) as store:
        study = store.add_study({"nacreous_study": 1, "design_hash": "ab" * 32})
        before = Path(place).stat().st_ino
        with pytest.raises(InputError, match="is the same file as the input"):
            backup(place, place) if ending == ".sqlite" else export(store, study, place)
    assert Path(place).stat().st_ino == before
