"""A rehearsal by HTTP: who is simulated, what is refused, what happens when nobody is there."""

from __future__ import annotations

import http.server
import subprocess
import threading
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import nacreous as nc
from nacreous.problem import InputError
from nacreous.server.client import Client, RefusedError
from nacreous.server.observer import responses
from nacreous.server.rehearsal import rehearse, scale_of
from nacreous.study.design import Frozen, open_frozen
from nacreous.study.store import Store
from nacreous.study.task.tasks import TASKS
from tests.support.documentation import COMMAND
from tests.support.server_process import Served, served, small_study

SCALE = {"secret-r": 0.0, "secret-g": -0.4, "secret-rg": 0.4}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return small_study(tmp_path_factory.mktemp("rehearsal") / "study")


@pytest.fixture(scope="module")
def server(folder: Path) -> Iterator[Served]:
    with served(folder) as made:
        yield made


@pytest.fixture(scope="module")
def frozen(folder: Path) -> Frozen:
    return open_frozen(folder)


def test_observers_go_from_entering_to_the_end_and_every_answer_is_simulated(
    folder: Path, server: Served, frozen: Frozen
) -> None:
    shares: list[float] = []
    done = rehearse(server.url, frozen, SCALE, 4, seed=3, progress=shares.append)
    assert (done.observers, done.answers) == (4, 20)
    assert shares == sorted(shares)
    assert shares[-1] == 1
    with Store.open(folder) as store:
        found = store.progress(frozen.study_hash)
        assert (found.finished, found.answers, found.simulated) == (4, 20, 20)
        assert {person.session.groups["trade"] for person in found.people} <= {"yes", "no"}
        assert all(row["response_ms"] > 0 for row in store.answers(frozen.study_hash))


def test_invited_observers_come_with_their_links(
    folder: Path, server: Served, frozen: Frozen
) -> None:
    with Store.open(folder) as store:
        store.set_registration(frozen.study_hash, "invited", "test")
        with pytest.raises(RefusedError, match="invit"):
            rehearse(server.url, frozen, SCALE, 1)
        tokens = store.invite(frozen.study_hash, 2, "rehearsal", "test")
        links = [f"{server.url}/#{token}" for token in tokens]
        with pytest.raises(InputError, match="links are 2; allowed: 3"):
            rehearse(server.url, frozen, SCALE, 3, links=links)
        assert rehearse(server.url, frozen, SCALE, 2, links=links).answers == 10
        used = [one.number is not None for one in store.invitations(frozen.study_hash)]
        assert used == [True, True]
        store.set_registration(frozen.study_hash, "open", "test")


def test_a_paused_study_lets_no_observer_in(folder: Path, server: Served, frozen: Frozen) -> None:
    with Store.open(folder) as store:
        store.pause(frozen.study_hash, "test")
        with pytest.raises(RefusedError, match="paused") as refused:
            rehearse(server.url, frozen, SCALE, 1)
        assert refused.value.status == 403
        store.reopen(frozen.study_hash, "test")


@pytest.mark.parametrize(
    ("asked", "message"),
    [
        ({"observers": 0}, "observers is 0; allowed"),
        ({"sigma": 0.0}, "sigma is 0; allowed: above 0"),
        ({"sigma": float("nan")}, "sigma is"),
        ({"scale": {"secret-r": 0.0}}, 'scale has no value for "secret-'),
        ({"url": "ftp://lab"}, "url is 'ftp://lab'; allowed: http"),
        ({"url": "http://lab:0x1"}, "url is"),
    ],
)
def test_what_cannot_be_is_refused_before_anyone_enters(
    folder: Path, server: Served, frozen: Frozen, asked: dict, message: str
) -> None:
    given = {"url": server.url, "frozen": frozen, "scale": SCALE, "observers": 1, **asked}
    with Store.open(folder) as store:
        before = store.progress(frozen.study_hash).entered
        with pytest.raises(InputError, match=message):
            rehearse(**given)
        assert store.progress(frozen.study_hash).entered == before


def test_where_nobody_answers_one_line_says_so(frozen: Frozen) -> None:
    with pytest.raises(InputError, match=r"http://127.0.0.1:9: nobody answers \(.+\)"):
        rehearse("http://127.0.0.1:9", frozen, SCALE, 1)


class Busy(http.server.BaseHTTPRequestHandler):
    """Busy at first, then there; speaks no JSON when asked for anything else."""

    protocol_version = "HTTP/1.1"
    asked = 0

    def do_GET(self) -> None:
        Busy.asked += 1
        if self.path == "/strange":
            body, status = b"<html>", 404
        elif Busy.asked < 3:
            body, status = b'{"problem": "too often", "kind": "busy"}', 429
        else:
            body, status = b'{"there": true}', 200
        self.send_response(status)
        self.send_header("Retry-After", "0")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_: object) -> None:
        return


def test_a_client_waits_where_the_server_is_busy_and_says_where_it_is_none() -> None:
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Busy) as other:
        thread = threading.Thread(target=other.serve_forever)
        thread.start()
        client = Client(f"http://127.0.0.1:{other.server_address[1]}")
        assert client.ask("GET", "/") == {"there": True}
        assert Busy.asked == 3
        with pytest.raises(RefusedError, match="answers 404, which no study's server does"):
            client.ask("GET", "/strange")
        client.close()
        other.shutdown()
        thread.join()


def test_choices_follow_case_v_and_hang_on_seed_and_number_alone() -> None:
    pair = TASKS["pair"]
    trials = [("a", "b")] * 20_000
    found = list(responses(pair, trials, {"a": 0.5, "b": 0.0}, 3, seed=1, sigma=1.0))
    share = np.mean([one.given == "left" for one in found])
    assert share == pytest.approx(0.6915, abs=0.012)  # Phi(0.5), within 3.6 standard errors
    wide = responses(pair, trials, {"a": 0.5, "b": 0.0}, 3, seed=1, sigma=2.0)
    assert np.mean([one.given == "left" for one in wide]) == pytest.approx(0.5987, abs=0.012)
    again = list(responses(pair, trials, {"a": 0.5, "b": 0.0}, 3, seed=1, sigma=1.0))
    assert again == found
    other = list(responses(pair, trials, {"a": 0.5, "b": 0.0}, 4, seed=1, sigma=1.0))
    assert other != found


def test_a_scale_is_the_papers_or_a_file_that_nacreous_scale_wrote(tmp_path: Path) -> None:
    path = tmp_path / "scale.csv"
    subprocess.run(
        [COMMAND, "scale", "paper", "-o", path, "--method", "least-squares", "--bootstrap", "0"],
        check=True,
        capture_output=True,
    )
    fit = nc.scaling.thurstone(nc.scaling.paper(), method="least-squares")
    written = dict(zip(fit.stimuli, fit.scale.tolist(), strict=True))
    assert scale_of(str(path)) == pytest.approx(written, abs=1e-6)
    # The shares of the printed table, and not the counts they were rounded to.
    assert scale_of("paper") == pytest.approx(written, abs=0.02)
    for text in ("", "stimulus,value\na,1\n", "stimulus,scale\na,much\n", "stimulus,scale\na\n"):
        path.write_text(text, encoding="utf-8")
        if text:
            with pytest.raises(InputError, match="is no scale; wanted: paper, or CSV"):
                scale_of(str(path))
    with pytest.raises(InputError, match="does not exist; wanted: paper, or a CSV file"):
        scale_of(str(tmp_path / "none.csv"))


def test_the_command_says_how_many_answers_were_simulated(
    folder: Path, server: Served, tmp_path: Path
) -> None:
    guess = tmp_path / "guess.csv"
    lines = [f"{label},{value}" for label, value in SCALE.items()]
    guess.write_text("stimulus,scale\n" + "\n".join(lines) + "\n", encoding="utf-8")
    command = [COMMAND, "study", "rehearse", server.url, folder, "--observers", "2"]
    done = subprocess.run([*command, "--scale", guess], capture_output=True, text=True, check=True)
    assert "2 simulated observers gave 10 answers" in done.stdout
    assert "each is marked as simulated" in done.stdout
    wrong = subprocess.run([*command, "--scale", "paper"], capture_output=True, text=True)
    assert wrong.returncode == 2
    assert "scale has no value for" in wrong.stderr
