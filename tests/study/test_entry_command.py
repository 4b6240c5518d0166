"""`nacreous study open | pause | close | invite | revoke | readmit`: what the lab's page can do."""

from pathlib import Path

import pytest

from nacreous import cli
from nacreous.problem import InputError
from nacreous.study.design import open_frozen
from nacreous.study.running import Running
from nacreous.study.store import NotAllowed, Store, UnknownToken
from tests.support.pairs import pair_answer
from tests.support.server_process import small_study


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A frozen study's folder that nobody has served yet."""
    return small_study(tmp_path / "study")


def hash_in(folder: Path) -> str:
    return open_frozen(folder).study_hash


def call(action: str, folder: Path, *more: str) -> int:
    return cli.main(["study", action, str(folder), *more])


def test_a_store_that_is_in_use_heeds_who_may_enter_at_once(folder: Path, capsys) -> None:
    study = hash_in(folder)
    with Store.open(folder) as serving:
        serving.add_study(open_frozen(folder).manifest())

        def enters() -> bool:
            try:
                serving.enter(study, "en", {})
            except NotAllowed:
                return False
            return True

        for action, option, told, may in (
            ("open", "--everyone", "open; anybody with the address may enter", True),
            ("pause", None, "paused; nobody enters, and who has entered goes on", False),
            ("open", None, "open; anybody with the address may enter", True),
            ("open", "--invited", "open; invited people alone may enter", False),
            ("close", None, "closed; nobody enters, and who has entered goes on", False),
            ("open", "--everyone", "open; anybody with the address may enter", True),
        ):
            assert call(action, folder, *([option] if option else [])) == 0
            assert capsys.readouterr().out == f"{folder}: {told}\n"
            assert enters() == may
        noted = [event.what for event in serving.events(study)]
    for what in ("study paused", "study closed", "study open", "registration invited"):
        assert what in noted


def test_each_link_lets_one_person_in(folder: Path, capsys) -> None:
    url = ["--url", "https://pearls.example/"]
    assert call("invite", folder, "2", "--label", "seat 3", *url) == 0
    first, second = capsys.readouterr().out.split()
    assert first.startswith("https://pearls.example/#")
    study = hash_in(folder)
    with Store.open(folder) as store:
        for number, link in enumerate((first, second, first)):
            session, _ = store.enter(study, "en", {}, link.partition("#")[2])
            assert session.number == number % 2
        assert [one.label for one in store.invitations(study)] == ["seat 3"] * 2


def test_a_revoked_invitation_and_a_revoked_link_let_nobody_in(folder: Path, capsys) -> None:
    assert call("invite", folder, "2", "--label", "seat 3") == 0
    used, unused = (link.partition("#")[2] for link in capsys.readouterr().out.split())
    study = hash_in(folder)
    with Store.open(folder) as store:
        store.enter(study, "en", {}, used)
    assert call("invitations", folder) == 0
    assert capsys.readouterr().out == "1  seat 3: used by person 0\n2  seat 3: not used\n"
    assert call("revoke", folder, "--invitation", "1") == 2
    assert "was used by person 0" in capsys.readouterr().err
    assert call("revoke", folder, "--invitation", "2") == 0
    assert call("revoke", folder, "--person", "0") == 0
    told = capsys.readouterr().out
    assert "invitation 2: revoked" in told
    assert "person 0: revoked" in told
    with Store.open(folder) as store:
        with pytest.raises(NotAllowed, match="the invitation was revoked"):
            store.enter(study, "en", {}, unused)
        with pytest.raises(UnknownToken):
            store.session_of(used)
    assert call("invitations", folder) == 0
    assert "2  seat 3: revoked" in capsys.readouterr().out


def test_an_invitation_is_one_line_of_the_list_whatever_it_is_called(folder: Path, capsys) -> None:
    assert call("invite", folder, "1", "--label", "a\n2  b: used by person 0") == 0
    capsys.readouterr()
    assert call("invitations", folder) == 0
    assert capsys.readouterr().out == "1  a\\u000a2  b: used by person 0: not used\n"


def test_whoever_is_readmitted_counts_again_unless_they_withdrew(folder: Path, capsys) -> None:
    assert call("open", folder, "--everyone") == 0
    study = hash_in(folder)
    with Store.open(folder) as store:
        for _ in range(2):
            session, _ = store.enter(study, "en", {})
            store.consent(session.id)
            store.answer(session.id, pair_answer(0, "q", "a", "b", "left"))
        store.withdraw(session.id)
    assert call("exclude", folder, "0", "--reason", "slept") == 0
    assert call("readmit", folder, "0") == 0
    assert "person 0: readmitted" in capsys.readouterr().out
    assert call("readmit", folder, "1") == 2
    assert "the person withdrew" in capsys.readouterr().err
    with Store.open(folder) as store:
        assert [row["excluded"] for row in store.answers(study)] == [None, "withdrew"]


def test_an_erased_person_is_called_by_number(folder: Path, capsys) -> None:
    with Store.open(folder) as store:
        study = store.add_study(open_frozen(folder).manifest())
        store.set_registration(study, "open", "lab")
        store.enter(study, "en", {})
    assert call("erase", folder, "0") == 0
    for words in (
        ("revoke", folder, "--person", "0"),
        ("readmit", folder, "0"),
        ("exclude", folder, "0", "--reason", "slept"),
    ):
        capsys.readouterr()
        assert call(*words) == 2
        assert "person 0 was erased; nothing can be" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("invite", "0", "--label", "x"), "count is 0; allowed: a whole number, 1 to 1000"),
        (("invite", "1", "--label", "x", "--url", "ftp://a"), "url is 'ftp://a'"),
        *(
            (("invite", "1", "--label", "x", "--url", f"http://{host}"), "url is 'http://")
            for host in (
                *("a b", "exa mple", "pearls.example\\x", "<b>", "a_b..c", "a%20b", "a,b", "-"),
                *("a.-b", "a-.b", "999.1.1.1", "a\tb", "[::1", "u@a", "a:0"),
            )
        ),
        (("close", "--store", "no/such/folder/a.sqlite"), "does not exist"),
        (("open", "--everyone", "--invited"), "not allowed with"),
        (("readmit", "3"), "does not exist; wanted: a store"),
        (("revoke", "--invitation", "7"), "invitation is 7; allowed: those that"),
        (("revoke", "--person", "7"), "person is 7; allowed: none, for nobody has entered"),
        (("revoke",), "one of the arguments --invitation --person is required"),
    ],
)
def test_mistakes_are_told_and_change_nothing(
    folder: Path, capsys, arguments: tuple[str, ...], told: str
) -> None:
    action, *more = arguments
    try:
        code = call(action, folder, *more)
    except SystemExit as end:  # argparse's own
        code = end.code
    assert code == 2
    assert told in capsys.readouterr().err
    with Store.open(folder) as store:
        study = store.add_study(open_frozen(folder).manifest())
        assert store.invitations(study) == []
        assert store.registration(study) == "invited"


def test_what_is_so_already_is_said_and_not_logged(folder: Path, capsys) -> None:
    study = hash_in(folder)
    with Store.open(folder) as store:
        store.add_study(open_frozen(folder).manifest())
        store.set_registration(study, "open", "lab")
        for _ in range(2):
            store.enter(study, "en", {})
    capsys.readouterr()
    for action, more, said in (
        ("readmit", ["0"], "person 0: is not excluded; nothing was changed"),
        ("exclude", ["0", "--reason", "slept"], "person 0: excluded; the answers stay, marked"),
        ("exclude", ["0", "--reason", "slept"], "person 0: was excluded so; nothing was changed"),
        ("exclude", ["0", "--reason", "left"], "person 0: excluded; the answers stay, marked"),
        ("readmit", ["0"], "person 0: readmitted; the answers count again"),
        ("revoke", ["--person", "0"], "person 0: revoked; the link"),
        ("revoke", ["--person", "0"], "person 0: has no link any more; the link"),
        ("erase", ["1"], "person 1: erased; backups"),
        ("erase", ["1"], "person 1: was erased before; backups"),
        ("open", ["--everyone"], f"{folder}: open already; anybody"),
        ("pause", [], f"{folder}: paused; nobody"),
        ("pause", [], f"{folder}: paused already; nobody"),
        ("close", [], f"{folder}: closed; nobody"),
        ("close", [], f"{folder}: closed already; nobody"),
    ):
        assert call(action, folder, *more) == 0
        assert capsys.readouterr().out.startswith(said)
    with Store.open(folder) as store:
        done = [event.what for event in store.events(study) if event.who != "participant"]
    assert done[2:] == [
        *("excluded", "excluded", "readmitted", "token revoked", "erased"),
        *("study paused", "study closed"),
    ]


@pytest.mark.parametrize("reason", ["NA", "n/a", "-", "None", " nan "])
def test_a_reason_that_programs_read_as_an_empty_cell_is_refused(
    folder: Path, capsys, reason: str
) -> None:
    with Store.open(folder) as store:
        study = store.add_study(open_frozen(folder).manifest())
        store.set_registration(study, "open", "lab")
        store.enter(study, "en", {})
    assert call("exclude", folder, "0", f"--reason={reason}") == 2
    assert "which programs read as an empty cell; wanted: words" in capsys.readouterr().err


def test_a_session_that_is_not_there_is_named_in_whole_quotation_marks(folder: Path) -> None:
    with Store.open(folder) as store:
        for refused in (
            lambda: store.consent("nonsense"),
            lambda: store.exclude("nonsense", "slept", "lab"),
            lambda: store.session("nonsense"),
        ):
            with pytest.raises(InputError, match=r"^session 'nonsense' is not in this store$"):
                refused()
        with pytest.raises(InputError, match=r"^study 'nonsense' is not in this store; wanted"):
            store.registration("nonsense")


def test_a_store_of_a_mistyped_name_is_said_to_be_new(folder: Path, tmp_path: Path, capsys) -> None:
    place = tmp_path / "answer.sqlite"
    for said in (f"{place}: a new store, with no answers yet\n", ""):
        assert call("open", folder, "--store", str(place)) == 0
        assert capsys.readouterr().err == said
    assert call("open", folder) == 0
    assert capsys.readouterr().err == ""


def test_a_study_and_its_store_are_told_in_short(folder: Path) -> None:
    with Store.open(folder) as store:
        running = Running(store, open_frozen(folder))
        assert repr(store) == f"Store('{folder / 'answers.sqlite'}')"
        assert repr(running).startswith("Running('")
        assert running.study[:12] in repr(running)
        assert len(repr(running)) < 80 + len(repr(store))
