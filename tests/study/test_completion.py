"""Parameters of the address are kept as declared; code and way back are told at the end."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from nacreous.problem import InputError
from nacreous.study.design import Design, freeze, open_frozen
from nacreous.study.running import Running
from nacreous.study.store import Response, Session, Store
from nacreous.study.store.tokens import draw

STUDY = """
purpose = "demo"
questions = [{ id = "deeper", text = { en = "Which looks deeper?", ja = "どちらが深い?" } }]
stimuli = [{ label = "a", pearl = "akoya-r" }, { label = "b", pearl = "akoya-g" }]
display = { size_px = 32, samples = 1 }
sitting = { training = 0 }

[entry]
parameters = ["PROLIFIC_PID", "SONA"]

[completion]
own_code = true
return_url = "https://platform.example/done?cc={CODE}&id={PROLIFIC_PID}&sona={SONA}"
"""
GIVEN = {"PROLIFIC_PID": "5f/0 c&é"}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("completion")
    (made / "my.toml").write_text(STUDY, encoding="utf-8")
    freeze(made / "my.toml", made / "study")
    return made / "study"


@pytest.fixture
def running(folder: Path, place: str) -> Iterator[Running]:
    with Store.open(place) as store:
        made = Running(store, open_frozen(folder))
        store.set_registration(made.study, "open", "lab")
        yield made


def finished(running: Running, parameters: dict[str, str], simulated: bool = False) -> Session:
    """Somebody who came by an address with these parameters, and answered everything."""
    token = draw()
    session = running.enter(token, "en", {}, parameters)
    running.store.consent(session.id)
    session = running.session_of(token)
    for trial in running.plan(session):
        assert running.ending(session) is None
        response = Response("left", simulated=simulated)
        running.hand_in(session, trial.number, response).result()
    return running.session_of(token)


def test_simulated_observers_are_given_no_code(running: Running) -> None:
    assert running.ending(finished(running, GIVEN, simulated=True)) is None


def test_who_has_finished_is_told_a_code_of_their_own_and_goes_back_with_it(
    running: Running,
) -> None:
    one, other = finished(running, GIVEN), finished(running, {})
    ending = running.ending(one)
    assert one.parameters == GIVEN
    assert ending is not None
    assert len(ending.code or "") == 10
    address = f"https://platform.example/done?cc={ending.code}&id=5f%2F0%20c%26%C3%A9&sona="
    assert ending.return_url == address
    assert running.ending(running.store.session(one.id)) == ending  # however often it is asked for
    without = running.ending(other)
    assert without is not None
    assert without.code != ending.code


def test_nothing_is_kept_but_declared_parameters_that_say_something_and_can_be_printed(
    running: Running,
) -> None:
    for given, told in (
        ({"utm_source": "mail"}, "parameter 'utm_source' is not kept; allowed: PROLIFIC_PID, SONA"),
        ({"SONA": "7" * 201}, "parameter SONA is 201 characters long; allowed: 1 to 200"),
        ({"SONA": ""}, "parameter SONA is 0 characters long; allowed: 1 to 200"),
        *(
            ({"SONA": blank}, "parameter SONA is blank; allowed: text, or no such parameter")
            for blank in (" ", "   ", "\u3000", "\xa0 ")
        ),
        *(
            ({"SONA": f"secret{letter}"}, "parameter SONA has control characters; allowed: none")
            for letter in "\0\n\x1b\x7f\x85\u202e\u200b\ue000\ud800"
        ),
    ):
        with pytest.raises(InputError) as caught:
            running.enter(draw(), "en", {}, given)
        assert str(caught.value) == told
    assert running.store.sessions(running.study) == []
    assert len(running.enter(draw(), "en", {}, {"SONA": "7" * 200}).parameters["SONA"]) == 200


def test_a_study_that_declares_none_keeps_none() -> None:
    design = Design.load("paper")
    assert design.entry.parameters == ()
    assert (design.completion.code, design.completion.return_url) == (None, None)


def test_the_parameters_of_the_first_time_stay(running: Running) -> None:
    token = draw()
    running.enter(token, "en", {}, {"SONA": "1"})
    assert running.enter(token, "en", {}, {"SONA": "2"}).parameters == {"SONA": "1"}


def test_parameters_and_code_go_with_the_person(running: Running) -> None:
    session = finished(running, GIVEN)
    code = session.completion_code
    running.store.erase(session.id, "lab")
    left = running.store.session(session.id)
    assert (left.parameters, left.completion_code, running.ending(left)) == ({}, None, None)
    if running.store.engine.dialect.name == "sqlite":
        kept = Path(running.store.place).read_bytes()
        assert GIVEN["PROLIFIC_PID"].encode() not in kept
        assert str(code).encode() not in kept


def loaded(tmp_path: Path, **keys: Any) -> Design:
    """The study with other keys of [entry] and [completion]."""
    text = STUDY.partition("[entry]")[0]
    lines = [f"{name} = {json.dumps(value)}" for name, value in keys.items()]
    entry = [line for line in lines if line.startswith("parameters")]
    completion = [line for line in lines if not line.startswith("parameters")]
    text += "\n".join(["[entry]", *entry, "[completion]", *completion])
    path = tmp_path / "my.toml"
    path.write_text(text, encoding="utf-8")
    return Design.load(path)


@pytest.mark.parametrize(
    "address",
    [
        "http://platform.example/done",
        "javascript:alert(1)",
        "https:///done",
        "https://{SONA}/done",
        "https://platform.example{SONA}/done",
        "https://somebody@platform.example/done",
        "https://platform.example/a b",
        "https://platform.example/{SONA",
        "https://platform.example/真珠",
        "//platform.example",
    ],
)
def test_a_return_address_is_https_and_its_host_is_the_studys(tmp_path: Path, address: str) -> None:
    with pytest.raises(InputError, match=r"completion\.return_url is .*; allowed: an https"):
        loaded(tmp_path, parameters=["SONA"], return_url=address)


@pytest.mark.parametrize(
    ("keys", "told"),
    [
        ({"return_url": "https://a.example/{SONA}"}, 'has the field "SONA"; allowed: none'),
        (
            {"return_url": "https://a.example/{CODE}", "parameters": ["SONA"]},
            'has the field "CODE"; allowed: SONA',
        ),
        ({"code": "C1", "own_code": True}, 'completion.code is "C1" while'),
        ({"code": "C 1"}, 'completion.code is "C 1"; allowed: 1 to 40 of'),
        ({"parameters": ["SONA", "SONA"]}, "entry.parameters are"),
        ({"parameters": ["simulate"]}, 'entry.parameters name "simulate"; allowed: other names'),
        ({"parameters": ["a b"]}, 'entry.parameters.0 is "a b"; allowed: 0 to 12'),
    ],
)
def test_what_cannot_be_is_refused_by_name(tmp_path: Path, keys: dict[str, Any], told: str) -> None:
    with pytest.raises(InputError) as caught:
        loaded(tmp_path, **keys)
    assert told in str(caught.value)


def test_a_fixed_code_is_everyones(place: str, tmp_path: Path) -> None:
    text = STUDY.replace("own_code = true", 'code = "C1X9"')
    (tmp_path / "my.toml").write_text(text, encoding="utf-8")
    frozen = freeze(tmp_path / "my.toml", tmp_path / "study")
    with Store.open(place) as store:
        running = Running(store, frozen)
        store.set_registration(running.study, "open", "lab")
        endings = [running.ending(finished(running, {"SONA": "1"})) for _ in range(2)]
    assert {ending.code for ending in endings if ending is not None} == {"C1X9"}
