"""A study that runs: the frozen folder and the store, and what a participant may do."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import Future
from typing import TYPE_CHECKING

from nacreous.number import whole_of
from nacreous.study.design import Frozen
from nacreous.study.design.multilingual import Words
from nacreous.study.plan import Trial, drawn_groups, trials
from nacreous.study.running.ending import Ending
from nacreous.study.running.entering import check_groups, check_language, check_parameters
from nacreous.study.running.plans import Plans, plain, shown, trials_of
from nacreous.study.running.screen_check import ScreenCheck
from nacreous.study.running.screening import ScreenFlag, flags_of, is_refused
from nacreous.study.store import (
    Answer,
    NotAllowed,
    OutOfTurn,
    Receipt,
    Response,
    Session,
    Store,
    UnknownToken,
)
from nacreous.study.store.people import WITHDREW
from nacreous.study.store.tokens import draw_code
from nacreous.study.task.counting import counts
from nacreous.study.task.task import SoFar
from nacreous.study.task.tasks import TASKS

if TYPE_CHECKING:
    from nacreous.scaling.report.settings import Settings

__all__ = ["Running"]


class Running:
    """A frozen study and its store. Safe to share among threads.

    What a participant says is checked against the study: a client answers what is asked, and
    nothing else is taken from it. Methods raise `InputError` and its kinds, and `StoreError`, as
    those of `Store`. A session is given as `session_of` tells it now, for what may be done hangs on
    it.

    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> from nacreous.study.design import freeze
    >>> file = '''purpose = "demo"
    ... questions = [{ id = "deeper", text = { en = "Which is deeper?", ja = "どちらが深い?" } }]
    ... stimuli = [{ label = "a", pearl = "akoya-r" }, { label = "b", pearl = "akoya-g" }]
    ... display = { size_px = 32, samples = 1 }
    ... sitting = { training = 0 }
    ... '''
    >>> place = TemporaryDirectory()
    >>> _ = Path(place.name, "my.toml").write_text(file, encoding="utf-8")
    >>> frozen = freeze(f"{place.name}/my.toml", f"{place.name}/my-study")
    >>> with Store.open(frozen.folder) as store:
    ...     running = Running(store, frozen)
    ...     [token] = store.invite(running.study, 1, "somebody", "lab")
    ...     session = running.enter(token, "en", {})
    ...     store.consent(session.id)
    ...     session = running.session_of(token)
    ...     receipt = running.hand_in(session, 0, Response("left")).result()
    ...     running.finish(session)
    >>> receipt.trial
    0
    >>> place.cleanup()
    """

    def __init__(self, store: Store, frozen: Frozen) -> None:
        self.store = store
        self.frozen = frozen
        self.study = store.add_study(frozen.manifest())
        self.task = TASKS[frozen.design.task]
        self._asked = frozen.design.asked
        self._plans = Plans()

    def __repr__(self) -> str:
        """Which study, and where."""
        return f"Running({self.frozen.design.name!r}, {self.study[:12]}, {self.store!r})"

    def enter(
        self,
        token: str,
        language: str,
        recorded: Mapping[str, str],
        parameters: Mapping[str, str] | None = None,
    ) -> Session:
        """Take in a participant, draw the groups and settle the plan.

        token: drawn beforehand, or an invitation's; the same again gives the same session.
        language: one of the study's. recorded: the value of each recorded group. parameters: of the
        address by which the person came, such as the study keeps.
        """
        design = self.frozen.design
        check_language(design, language)
        check_groups(design, recorded)
        check_parameters(design, parameters or {})
        session, _ = self.store.enter(
            self.study,
            language,
            recorded,
            token,
            parameters=parameters,
            completion_code=draw_code() if design.completion.own_code else None,
            idle_hours=design.entry.idle_hours,
        )
        self._settled(session)
        return self.store.session(session.id)  # as settled, whoever did it

    def session_of(self, token: str) -> Session:
        """Whose token this is, in this study."""
        session = self.store.session_of(token)
        if session.study != self.study:
            raise UnknownToken("token is of another study; wanted: one of this study")
        return self._settled(session)

    def plan(self, session: Session) -> tuple[Trial, ...]:
        """All trials of a participant; of an erased one none are left."""
        if session.erased_at is not None:
            return ()
        self._settled(session)
        return self._plans.get(session.id) or self._kept(session) or ()

    def answered(self, session: Session) -> int:
        """How many trials are answered: the number of the next one."""
        return self.store.answered(session.id)

    def notes(self, session: Session) -> tuple[Words, ...]:
        """What the participant is told about the groups that they are in."""
        given = [
            group.note(session.groups[group.name])
            for group in self.frozen.design.groups
            if group.name in session.groups
        ]
        return tuple(note for note in given if note is not None)

    def screen(self, session: Session, check: ScreenCheck) -> tuple[ScreenFlag, ...]:
        """Keep a screen check, and tell its flags. May be repeated: the last one counts.

        Kept is what was sent, keys that this version does not know included.
        """
        if (refusal := _withheld(session)) is not None:
            raise refusal
        flags = flags_of(self.frozen.design.screen, check)
        content = check.model_dump(exclude_unset=True)
        self.store.screen(session.id, {**content, "flags": list(flags)})
        return flags

    def screen_flags(self, session: Session) -> tuple[str, ...]:
        """The flags of the last screen check."""
        return tuple((session.screen or {}).get("flags", ()))

    def refused(self, session: Session) -> bool:
        """Whether the study's rules let the participant not go on, by the last screen check."""
        return is_refused(self.frozen.design.screen, self.screen_flags(session))

    def due(self, session: Session) -> frozenset[str]:
        """The pictures, by SHA-256, that a participant may see now: those of the plan, or none."""
        if self._barred(session) is not None:
            return frozenset()
        labels = {label for trial in self.plan(session) for label in trial.stimuli}
        return frozenset(one.sha256 for one in self.frozen.stimuli if one.label in labels)

    def hand_in(self, session: Session, trial: int, response: Response) -> Future[Receipt]:
        """Store an answer to a trial; question, stimuli and places are those of the plan.

        The next trial, or again one that is answered. What may be answered says the task.
        """
        if (refusal := self._barred(session)) is not None:
            raise refusal
        plan = self.plan(session)
        trial = whole_of("trial", trial, 0, len(plan) - 1)
        self.task.check(self._asked, response.given)
        asked = plan[trial]
        answer = Answer(trial, asked.question, shown(asked, self.task), response, asked.kind)
        last = trial == len(plan) - 1
        return self.store.hand_in(session.id, answer, in_turn=True, last=last)

    def finish(self, session: Session) -> None:
        """Note that a participant has answered every trial, where the last answer did not."""
        count, wanted = self.answered(session), len(self.plan(session))
        if count < wanted:
            raise OutOfTurn(f"{count} trials are answered; wanted: all {wanted} before the end")
        self.store.finish(session.id)

    def ending(self, session: Session) -> Ending | None:
        """What a participant is given at the end; None before it, and of an erased one.

        Simulated observers are given nothing: whoever pays by the code would pay them.
        """
        if session.finished_at is None or session.erased_at is not None:
            return None
        if self.store.simulated(session.id):
            return None
        completion = self.frozen.design.completion
        code = completion.code or session.completion_code
        return Ending(code, completion.filled(session.parameters, code))

    def _barred(self, session: Session) -> NotAllowed | None:
        """Why a participant may not go on, if anything stands against it."""
        if (refusal := _withheld(session)) is not None:
            return refusal
        if self.refused(session):
            flags = ", ".join(self.screen_flags(session))
            return NotAllowed(f"the screen is refused ({flags}); wanted: one that passes")
        screen = self.frozen.design.screen
        if session.screen is None and screen.refuses:
            return NotAllowed("the screen check is missing; wanted: one that passes")
        return None

    def _settled(self, session: Session) -> Session:
        """The session with its groups and its plan, made now where a crash left it without."""
        if self._plans.get(session.id) is not None:
            return session
        if self._kept(session) is not None or session.slot is None:
            return session
        design = self.frozen.design
        groups = {**session.groups, **drawn_groups(design, session.slot)}
        plan = trials(design, session.slot, self._so_far())
        self.store.settle(session.id, groups, plain(plan, self.task))
        self._kept(session)
        return self.store.session(session.id)

    @property
    def settings(self) -> Settings:
        """How a report fits the answers, as the choice of items asks for it."""
        return self.task.settings(self.task.chosen_by(self._asked))

    def _so_far(self) -> SoFar | None:
        """What the next participant's plan hangs on; nothing where it hangs on no answers."""
        if not self.task.adapts(self._asked):
            return None
        tally = [
            one for one in self.store.tally(self.study) if counts(one, simulated=one["simulated"])
        ]
        return self.task.so_far(self._asked, tally)

    def _kept(self, session: Session) -> tuple[Trial, ...] | None:
        """The plan in the store, from now on in memory too."""
        plan = self.store.plan(session.id)
        if plan is None:
            return None
        made = trials_of(plan, self.task)
        self._plans.put(session.id, made)
        return made


def _withheld(session: Session) -> NotAllowed | None:
    """Consent that was never given, or taken back."""
    if session.consented_at is None:
        return NotAllowed("consent is missing; wanted: consent before anything else")
    if session.excluded_reason == WITHDREW:
        return NotAllowed("the participant withdrew; nothing more is taken")
    return None
