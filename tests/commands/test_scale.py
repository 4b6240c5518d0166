"""`nacreous scale` as its users meet it: what it writes, says and refuses."""

from __future__ import annotations

import base64
import json
import re
import shlex
import subprocess
import sys
from html import unescape
from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous import cli
from tests.support.terminal import at_terminal

HEAD = "person,left,right,chosen,time,place\n"


def answers(count: int = 4, people: int = 12, seed: int = 1) -> str:
    """Simulated answers as a CSV file."""
    chance = np.random.default_rng(seed)
    rows = []
    for person in range(people):
        for i in range(count):
            for j in range(i):
                chosen = i if i - j + 2 * chance.normal() > 0 else j
                rows.append(f"p{person},{i},{j},{chosen},{len(rows)},{'NS'[person % 2]}\n")
    return HEAD + "".join(rows)


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with good and bad files, which is where commands run."""
    files = {
        "answers.csv": answers(),
        "counts.csv": ",a,b,c\na,0,7,9\nb,3,0,6\nc,1,4,0\n",
        "empty.csv": "",
        "no-chosen.csv": "left,right\n1,2\n",
        "self.csv": "left,right,chosen\n1,1,1\n",
        "one-place.csv": HEAD + "p,1,2,1,1,N\nq,1,2,2,1,N\n",
        "unanimous.csv": "left,right,chosen\na,b,a\na,b,a\n",
        "ragged.csv": ",a,b\na,0,7\nb,3\n",
        "renamed.csv": answers().replace(HEAD, "who,first,second,better,time,place\n"),
    }
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    return tmp_path


# --- what is written


def test_the_papers_example_makes_a_report_and_says_the_order(
    desk: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = set(desk.iterdir())
    assert cli.main(["scale", "paper", "--bootstrap", "100"]) == 0
    said = capsys.readouterr()
    assert said.err == ""
    assert re.findall(r"^(\d) ", said.out, re.MULTILINE) == list("2431567")
    assert "case V does not describe these data; largest misfit 1-3" in said.out
    assert {path.name for path in set(desk.iterdir()) - before} == {"report.html"}
    assert Path("report.html").read_text(encoding="utf-8").startswith("<!DOCTYPE html>")


def test_report_table_and_record_come_together_and_agree(desk: Path) -> None:
    outputs = [word for name in ("a.html", "a.csv", "a.json") for word in ("-o", name)]
    assert cli.main(["scale", "answers.csv", "--bootstrap", "100", *outputs]) == 0
    header, *rows = Path("a.csv").read_text().splitlines()
    assert header == "place,stimulus,scale,unit,low,high,se,chosen,passed,ties"
    found = json.loads(Path("a.json").read_text())
    for row, stimulus in zip(rows, found["stimuli"], strict=True):
        cells = row.split(",")
        assert cells[1] == stimulus["stimulus"]
        assert float(cells[2]) == pytest.approx(stimulus["scale"], abs=1e-6)


def test_the_same_command_gives_the_same_bytes(desk: Path) -> None:
    command = ["scale", "answers.csv", "--group", "place", "--bootstrap", "100"]
    for name in ("a.html", "b.html"):
        assert cli.main([*command, "-o", name]) == 0
    assert Path("a.html").read_bytes() == Path("b.html").read_bytes()


def test_the_command_in_the_report_makes_the_report_again(desk: Path) -> None:
    options = ['--question=-Which\'s "more"?', "--language", "ja", "--unit", "d'"]
    options += ["--model", "logit", "--level", "0.9", "--bootstrap", "100", "--seed", "7"]
    options += ["--ties", "--prior", "2.5", "--group", "place"]
    assert cli.main(["scale", "answers.csv", "-o", "report.html", *options]) == 0
    first = Path("report.html").read_text(encoding="utf-8")
    command = unescape(re.findall(r"<code>(.*?)</code>", first)[-1])
    script = command.replace("nacreous", f"'{sys.executable}' -m nacreous", 1)
    subprocess.run(["sh", "-c", script], check=True, capture_output=True)
    assert Path("report.html").read_text(encoding="utf-8") == first


def test_awkward_data_are_read_again_as_they_were_meant(desk: Path) -> None:
    """A stimulus called tie, answers that nothing tells apart, pairs without sides."""
    pairs = ["tie,b,tie", "b,tie,b", "tie,b,none", "b,c,b", "c,b,c", "b,tie,b"]
    Path("answers.csv").write_text(
        "person,left,right,chosen\n" + "".join(f"mika,{row}\n" for row in pairs)
    )
    options = ["--tie", "none", "--repeats", "--no-sides", "--bootstrap", "0"]
    assert cli.main(["scale", "answers.csv", "-o", "report.html", *options]) == 0
    first = Path("report.html").read_text(encoding="utf-8")
    data = re.search(r'download="answers.csv" href="data:[^,]*,([^"]*)"', first)
    assert data is not None
    Path("answers.csv").write_bytes(base64.b64decode(data[1]))
    words = shlex.split(unescape(re.findall(r"<code>(.*?)</code>", first)[-1]))
    assert cli.main(words[1:]) == 0
    assert Path("report.html").read_text(encoding="utf-8") == first


def test_columns_may_have_other_names(desk: Path) -> None:
    roles = {"person": "who", "left": "first", "right": "second", "chosen": "better"}
    columns = [word for role, name in roles.items() for word in ("--column", f"{role}={name}")]
    assert cli.main(["scale", "renamed.csv", "-o", "a.csv", "--bootstrap", "100", *columns]) == 0
    assert cli.main(["scale", "answers.csv", "-o", "b.csv", "--bootstrap", "100"]) == 0
    assert Path("a.csv").read_text() == Path("b.csv").read_text()


def test_counts_come_as_a_square_table(desk: Path) -> None:
    assert cli.main(["scale", "counts.csv", "--counts", "-o", "a.csv", "--bootstrap", "0"]) == 0
    assert [line.split(",")[1] for line in Path("a.csv").read_text().splitlines()[1:]] == list(
        "abc"
    )


def test_options_reach_the_fit(desk: Path) -> None:
    command = ["scale", "answers.csv", "-o", "a.json", "--bootstrap", "0", "--order", "--ties"]
    assert cli.main([*command, "--model", "logit", "--prior", "1.5", "--no-sides"]) == 2
    assert cli.main([*command, "--model", "logit", "--prior", "1.5", "--unit", "JND"]) == 0
    found = json.loads(Path("a.json").read_text())
    assert found["unit"] == "JND"
    assert found["order_effect"] is not None
    own = nc.scaling.bradley_terry("answers.csv", ties=True, order=True, prior=1.5).to("JND")
    for row in found["stimuli"]:
        assert row["scale"] == pytest.approx(own.scale[own.stimuli.index(row["stimulus"])])


# --- what is refused


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["gone.csv"], "gone.csv: does not exist"),
        (["papre"], "papre: does not exist; wanted: .csv, .tsv, .txt, .parquet"),
        (["empty.csv"], "empty.csv: "),
        (["no-chosen.csv"], "no-chosen.csv: has no column chosen; columns here: "),
        (["self.csv"], 'self.csv: row 2: "1" is paired with itself'),
        (["unanimous.csv"], 'no scale holds "b": was never preferred when compared with "a"'),
        (["ragged.csv", "--counts"], "ragged.csv: "),
        (["counts.csv", "--counts", "--group", "place"], "--group is place; allowed: none, for"),
        (["counts.csv", "--counts", "--column", "left=a"], "--column is given with counts"),
        (["paper", "--no-sides"], "--no-sides is given with counts"),
        (
            ["answers.csv", "--group", "plaec"],
            '"plaec" is no group of these answers; did you',
        ),
        (["answers.csv", "--column", "left"], '--column "left": wanted: role=name, such as'),
        (
            ["answers.csv", "--column", "lfet=a"],
            '"lfet" is no role of a column; did you mean',
        ),
        (["answers.csv", "--level", "95"], "--level is 95; allowed: 0.5 to 0.9999"),
        (["answers.csv", "--level", "nan"], "--level is nan; allowed: 0.5 to 0.9999"),
        (["answers.csv", "--prior", "wide"], "argument --prior: 'wide' is none of: none, hier"),
        (
            ["answers.csv", "--bootstrap", "-5"],
            "--bootstrap is -5; allowed: a whole number, 0 to 100000",
        ),
        (["answers.csv", "--seed", "-1"], "--seed is -1; allowed: a whole number, 0 to "),
        (["answers.csv", "--prior", "-1"], "--prior is -1"),
        (["answers.csv", "--prior", "nan"], "--prior is nan"),
        (
            ["answers.csv", "--model", "logit", "--method", "least-squares"],
            "--method is least-squares; allowed: with --model probit, without t",
        ),
        (["answers.csv", "-o", "a.pdf"], "a.pdf: the ending is .pdf; allowed: .html, .csv, .json"),
        (["answers.csv", "-o", "gone/a.html"], "gone/a.html: the folder "),
        (["answers.csv", "-o", "a.html", "-o", "gone/a.csv"], "gone/a.csv: the folder "),
        (["answers.csv", "--model", "cauchy"], "--model is 'cauchy'; allowed: "),
        (
            ["answers.csv", "--prior", "-1"],
            "--prior is -1.0; allowed: a spread, 0.001 to 1000, hier",
        ),
        (["answers.csv", "--order", "--no-sides"], "--order, but left and right are no sides here"),
        (
            ["answers.csv", "--group", "person", "--ties", "--method", "least-squares"],
            "--method is",
        ),
        (
            ["one-place.csv", "--group", "place"],
            '--group is place, a column that holds "N"; allowed',
        ),
        (
            ["answers.csv", "--left", "f", "--right", "f"],
            "--left f is given with --right f; allowed",
        ),
        (["answers.csv", "--left", ""], "--left is empty; allowed: a word"),
        (["answers.csv", "--tie", "1"], "answers.csv: --tie 1 is the label of a stimulus; allowed"),
        (["answers.csv", "--counts"], "answers.csv: row 1 has the names of a table of answers ("),
        (["answers.csv", "--encoding", "utf-9"], "--encoding is utf-9; did you mean utf-8?"),
        (["no\nsuch.csv"], "no\\u000asuch.csv: does not exist"),
    ],
    ids=lambda case: " ".join(case)[:40] if isinstance(case, list) else "",
)
def test_bad_input_is_refused_in_one_line_and_leaves_no_file(
    desk: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], message: str
) -> None:
    before = sorted(desk.iterdir())
    assert cli.main(["scale", *arguments]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    (line,) = said.err.splitlines()
    assert line.startswith(f"nacreous: {message}")
    assert sorted(desk.iterdir()) == before


@pytest.mark.parametrize(
    ("content", "pasted"),
    [
        (
            "stim l,stim_r,key_resp.keys\n1,2,left\n2,1,left\n",
            "--column 'left=stim l' --column right=stim_r --column chosen=key_resp.keys",
        ),
        ("left,right,chosen\n1,2,links\n1,2,rechts\n", "--left links --right rechts"),
        ("left,right,chosen\n1,2,1\n1,2,2\n1,2,=\n", "--tie ="),
        ("left,right,chosen,time\n1,2,1,1.3.2024\n1,2,2,x\n", "--column time="),
        ("left,right,chosen\n1,2,1\n1,2,2\n1,2,\n", "--skip-unanswered"),
        ("a,b,c\nx,y,z\nleft,right,chosen\n1,2,1\n1,2,2\n", "--skip-rows 2"),
        ("left,right,chosen\na,b,a\n", "--prior 1"),
        (
            "participant,PROLIFIC_PID,left,right,chosen\n1,1,a,b,a\n1,2,b,a,a\n2,2,a,b,b\n",
            "--column person=participant",
        ),
    ],
)
def test_the_option_that_a_refusal_names_can_be_pasted(
    desk: Path, capsys: pytest.CaptureFixture[str], content: str, pasted: str
) -> None:
    Path("a file.csv").write_text(content)
    command = ["scale", "a file.csv", "--bootstrap", "0"]
    assert cli.main(command) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert pasted in line
    assert cli.main([*command, *shlex.split(pasted)]) == 0


def test_an_old_report_survives_a_refusal(desk: Path) -> None:
    Path("report.html").write_text("the old report")
    assert cli.main(["scale", "unanimous.csv"]) == 2
    assert Path("report.html").read_text() == "the old report"


def test_a_long_bootstrap_shows_progress_and_ctrl_c_leaves_nothing(tmp_path: Path) -> None:
    (tmp_path / "answers.csv").write_text(answers(40, 30))
    command = [sys.executable, "-m", "nacreous", "scale", "answers.csv", "--bootstrap", "100000"]
    with at_terminal(command, tmp_path) as watched:
        watched.shows(b"resampling [")
        code, seconds = watched.interrupted()
        assert (code, seconds < 5) == (130, True), seconds
        shown = watched.shows(b"nothing was written")
        assert shown.endswith(b"nacreous: interrupted; nothing was written\r\n")
    assert [path.name for path in tmp_path.iterdir()] == ["answers.csv"]


def test_a_small_scale_loads_neither_all_of_scipys_statistics_nor_databases_nor_pandas(tmp_path):
    (tmp_path / "a.csv").write_text("left,right,chosen\na,b,a\na,b,b\n", encoding="utf-8")
    code = (
        "import sys; from nacreous.__main__ import run;"
        "sys.argv = ['nacreous', 'scale', 'a.csv', '--bootstrap', '0', '-o', 'b.csv'];"
        "assert run() == 0;"
        "print(sorted({'scipy.stats', 'sqlalchemy', 'alembic', 'pandas'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    assert done.stdout.splitlines()[-1] == "[]"
