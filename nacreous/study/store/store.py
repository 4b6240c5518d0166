"""The store: one object for all that is kept of a study."""

from __future__ import annotations

import uuid
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Future
from datetime import timedelta
from functools import partial
from typing import TYPE_CHECKING, Any

from nacreous.problem import InputError
from nacreous.study.store import answers as answering
from nacreous.study.store import check, people, studies, tokens
from nacreous.study.store import progress as counting
from nacreous.study.store.engine import outside_transaction
from nacreous.study.store.fault import translated
from nacreous.study.store.lab import Lab
from nacreous.study.store.progress import Progress
from nacreous.study.store.record import Answer, Receipt, Session
from nacreous.study.store.schema import sessions
from nacreous.study.task.row import Row, Tallied

if TYPE_CHECKING:
    import pyarrow as pa


class Store(Lab):
    """Sessions and answers on the disk. Safe to share among threads; several may open one store.

    Every method that changes something returns after its commit is on the disk. Methods raise
    `InputError` for what cannot be stored, and `StoreError` where the machine refuses: then
    nothing, or all of it, is stored, and giving the same answer again is safe.

    >>> from tempfile import TemporaryDirectory
    >>> from nacreous.study.task.response import Response
    >>> pair = {"left": "a", "right": "b"}
    >>> with TemporaryDirectory() as folder, Store.open(folder) as store:
    ...     study = store.add_study({"nacreous_study": 1, "design_hash": "ab" * 32})
    ...     store.set_registration(study, "open", "lab")
    ...     session, token = store.enter(study, "en", {"seen": "real"})
    ...     store.consent(session.id)
    ...     receipt = store.answer(session.id, Answer(0, "deeper", pair, Response("left")))
    ...     again = store.answer(session.id, Answer(0, "deeper", pair, Response("left")))
    ...     receipt.again, again.again, store.progress(study).answers
    (False, True, 1)
    """

    def add_study(self, manifest: Mapping[str, Any]) -> str:
        """Keep a frozen design and return its hash; at once if it is kept already."""
        study = studies.hash_of(manifest)
        text = check.canonical("manifest", manifest, check.LARGEST_MANIFEST)
        self._do(partial(studies.add, at=self._at(), study=study, manifest=text))
        return study

    def manifest(self, study: str) -> dict[str, Any]:
        """A study's manifest."""
        with self.reading() as connection:
            return studies.manifest_of(connection, study)

    def studies(self) -> dict[str, str]:
        """Every study's hash, and whether it is open, paused or closed."""
        with self.reading() as connection:
            return studies.states(connection)

    def study(self, beginning: str | None = None) -> str:
        """The hash of the study whose hash begins so; None where there is but one."""
        known = self.studies()
        found = [study for study in known if study.startswith(beginning or "")]
        if len(found) != 1:
            which = "no study" if beginning is None else f"{len(found)} studies of {beginning!a}"
            if beginning is None and known:
                which = f"{len(known)} studies"
            here = ", ".join(study[:12] for study in known) or "none"
            raise InputError(f"{self.place}: has {which}; wanted: one of its studies ({here})")
        return found[0]

    def pause(self, study: str, who: str) -> bool:
        """Let nobody enter for now; False where it is paused already.

        Answers of those who have entered are still kept.
        """
        return self._set_state(study, "paused", who)

    def reopen(self, study: str, who: str) -> bool:
        """Let people enter again; False where they may."""
        return self._set_state(study, "open", who)

    def close_study(self, study: str, who: str) -> bool:
        """Let nobody enter any more; False where that is so already.

        An answer that comes late is still kept, for it was given.
        """
        return self._set_state(study, "closed", who)

    def enter(
        self,
        study: str,
        language: str,
        groups: Mapping[str, str],
        token: str | None = None,
        *,
        parameters: Mapping[str, str] | None = None,
        completion_code: str | None = None,
        idle_hours: float = 1.0,
    ) -> tuple[Session, str]:
        """Take in a participant: the session, with its number and slot, and the token.

        token: drawn beforehand (`nacreous.study.store.tokens.draw`), or an invitation's, which is
        used by that. The same token again gives the same session, whatever became of the study and
        whatever else is said; so who did not hear of having entered asks again. None: a new one is
        drawn, and told only here. Raises `NotAllowed` where the study is not open, or for invited
        people only and the token no invitation.

        parameters: of the address, each one line of up to 200 characters. completion_code: of the
        person's own, to be told at the end. idle_hours: who has not finished, and did nothing for
        longer, dropped out; their slot is given again (`nacreous.study.store.slots`).

        >>> from tempfile import TemporaryDirectory
        >>> with TemporaryDirectory() as folder, Store.open(folder) as store:
        ...     study = store.add_study({"design_hash": "ab" * 32})
        ...     store.set_registration(study, "open", "lab")
        ...     first, second = (store.enter(study, "en", {})[0] for _ in range(2))
        ...     _ = store.exclude(first.id, "left the room", "lab")
        ...     third, _ = store.enter(study, "en", {})
        ...     second.slot, third.number, third.slot
        (1, 2, 0)
        """
        token = tokens.draw() if token is None else tokens.fresh(token)
        row = {
            "id": str(uuid.uuid4()),
            "language": check.text("language", language, 35),
            "groups": check.levels(groups),
            "parameters": check.parameters(parameters or {}),
            "completion_code": completion_code,
        }
        now = self._clock()
        work = partial(
            people.enter,
            at=check.written("clock", now),
            study=study,
            hashed=tokens.hash_of(token),
            row=row,
            since=check.written("clock", now - timedelta(hours=idle_hours)),
        )
        return self.session(self._do(work)), token

    def settle(self, session: str, groups: Mapping[str, str], plan: list[dict[str, Any]]) -> None:
        """Keep all groups of a participant, drawn and recorded, and the plan, plain values.

        Set once: what is settled stays, whatever is given again.
        """
        text = check.levels(groups)
        made = check.canonical_list("plan", plan, check.LARGEST_PLAN)
        self._do(partial(people.settle, session=session, groups=text, plan=made))

    def plan(self, session: str) -> list[dict[str, Any]] | None:
        """The plan that was settled; None before, and of an erased person."""
        with self.reading() as connection:
            return people.plan(connection, session)

    def session_of(self, token: str) -> Session:
        """Whose token this is."""
        hashed = tokens.hash_of(token)
        with self.reading() as connection:
            found = people.find(connection, sessions.c.token_hash == hashed)
        if not found:
            raise tokens.unknown()
        return found[0]

    def session(self, session: str) -> Session:
        """A session by its id."""
        with self.reading() as connection:
            return people.one(connection, session)

    def sessions(self, study: str) -> list[Session]:
        """A study's sessions by number, erased and excluded ones too."""
        with self.reading() as connection:
            return people.find(connection, sessions.c.study == study)

    def screen_checks(self, study: str) -> dict[int, list[dict[str, Any]]]:
        """All screen checks by the person's number, in order, each with `at`, when it came."""
        with self.reading() as connection:
            return people.screen_checks(connection, study)

    def consent(self, session: str) -> None:
        """Note that a participant consented; no answer is taken before."""
        self._set_once(session, "consented_at", "consented")

    def finish(self, session: str) -> None:
        """Note that a participant has answered everything, where the last answer did not."""
        self._set_once(session, "finished_at", people.FINISHED)

    def screen(self, session: str, content: Mapping[str, Any]) -> None:
        """Keep a screen check."""
        text = check.canonical("screen", content)
        self._do(partial(people.add_screen, at=self._at(), session=session, content=text))

    def answer(self, session: str, answer: Answer) -> Receipt:
        """Store an answer; the receipt says that it is on the disk.

        The same answer again gets the same receipt, with `again`, and is not stored twice. Another
        answer to the same trial raises `Conflict` and is kept in the audit log.
        """
        return self.hand_in(session, answer).result()

    def hand_in(
        self, session: str, answer: Answer, in_turn: bool = False, last: bool = False
    ) -> Future[Receipt]:
        """As `answer`, without waiting; for an event loop, by `asyncio.wrap_future`.

        in_turn: an answer to a trial before which others are open raises `OutOfTurn`. last: of the
        plan; who has answered it has finished, which is stored with it.
        """
        work = partial(answering.put, at=self._at(), session=session, answer=answer)
        return self._writer.submit(partial(work, in_turn=in_turn, last=last))

    def answers(self, study: str, session: str | None = None) -> list[Row]:
        """Every answer of a study (or of one session) as a row, in the order of arrival.

        Excluded, simulated and erased ones are among them and say so: `excluded` (the reason or
        None), `simulated`, `erased_as` (a random name or None).
        """
        with self.reading() as connection:
            if study not in studies.states(connection):
                raise studies.unknown(study)
            return answering.rows(connection, study, session)

    def parts(self, study: str, names: Sequence[str]) -> Iterator[Mapping[str, Sequence[Any]]]:
        """Some columns of every answer, by name, as `answers` has them, some thousands at a time.

        However many there are, one part is in memory. All are of one state of the store.
        """
        with self.reading() as connection:
            yield from answering.parts(connection, study, names)

    def watched(self, study: str) -> Iterator[pa.Table]:
        """What flags hang on, of every answer in the order of arrival, some thousands at a time."""
        with self.reading() as connection:
            yield from answering.watched_parts(connection, study)

    def groups_of_answers(self, study: str) -> list[str]:
        """The groups, as JSON, of all who have given an answer, each once."""
        with self.reading() as connection:
            return people.groups_of_answers(connection, study)

    def tally(self, study: str) -> list[Tallied]:
        """Equal answers counted, whether they count or not; far less than all answers.

        Which of them count says `nacreous.study.task.counting`.
        """
        with self.reading() as connection:
            return answering.tally(connection, study)

    def answered(self, session: str) -> int:
        """How many answers of a session are stored."""
        with self.reading() as connection:
            return answering.count(connection, session)

    def simulated(self, session: str) -> bool:
        """Whether a simulated observer answered in a session."""
        with self.reading() as connection:
            return answering.any_simulated(connection, session)

    def progress(self, study: str) -> Progress:
        """Who, how far, how long."""
        with self.reading() as connection:
            state = studies.states(connection).get(study)
            if state is None:
                raise studies.unknown(study)
            return counting.progress(connection, study, state)

    def exclude(self, session: str, reason: str, who: str) -> bool:
        """Mark a person's answers as not to be counted. They stay, and so does the reason.

        False where they are marked with that reason already. Raises `NotAllowed` where the person
        withdrew, which is never written over.
        """
        work = partial(people.exclude, session=session, who=who, reason=check.reason(reason))
        return self._do(partial(work, at=self._at()))

    def readmit(self, session: str, who: str) -> bool:
        """Take an exclusion back, unless the person withdrew; the audit log keeps both.

        False where the person is not excluded.
        """
        return self._do(partial(people.readmit, at=self._at(), session=session, who=who))

    def withdraw(self, session: str) -> None:
        """Leave a person out at their own wish; the reason is "withdrew", and stays."""
        self._do(partial(people.withdraw, at=self._at(), session=session))

    def revoke(self, session: str, who: str) -> bool:
        """Make a participant's token worthless; False where it is already."""
        return self._do(partial(people.revoke, at=self._at(), session=session, who=who))

    def erase(self, session: str, who: str) -> bool:
        """Take away what leads from answers to a person; what was chosen stays, and is counted.

        False where the person is erased already.
        """
        erased = self._do(partial(people.erase, at=self._at(), session=session, who=who))
        if self.engine.dialect.name == "sqlite":
            # The log still holds the old pages until they are written over.
            with translated(self.place):
                outside_transaction(self.engine, "PRAGMA wal_checkpoint(TRUNCATE)")
        return erased

    def _set_state(self, study: str, state: str, who: str) -> bool:
        work = partial(studies.set_state, at=self._at(), study=study, state=state, who=who)
        return self._do(work)

    def _set_once(self, session: str, column: str, what: str) -> None:
        at = self._at()
        self._do(partial(people.set_once, at=at, session=session, column=column, what=what))
