"""Where one participant is, as their browser is told."""

from __future__ import annotations

from collections.abc import Sequence

from nacreous.server.facts import words
from nacreous.server.responses import EndingTold, PictureTold, SittingTold, TrialTold
from nacreous.server.service import Service
from nacreous.study.plan import Trial
from nacreous.study.running.plans import shown
from nacreous.study.store import Session


def sitting_of(service: Service, session: Session) -> SittingTold:
    """All that somebody needs to begin or to go on. Reads the store: for threads alone."""
    running = service.running
    consented = session.consented_at is not None
    trials = running.plan(session) if consented else ()
    ending = running.ending(session)
    return SittingTold(
        sitting=session.id,
        number=session.number,
        language=session.language or running.frozen.design.languages[0],
        consented=consented,
        screened=session.screen is not None,
        screen_flags=list(running.screen_flags(session)),
        refused=running.refused(session),
        finished=session.finished_at is not None,
        ending=None if ending is None else EndingTold(**vars(ending)),
        answered=running.answered(session),
        groups_notes=[words(note) for note in running.notes(session)],
        trials=_trials(service, trials),
        pictures=_pictures(service, trials),
    )


def _trials(service: Service, trials: Sequence[Trial]) -> list[TrialTold]:
    sha256, task = service.pictures.of_label, service.running.task
    return [
        TrialTold(
            trial=trial.number,
            question=trial.question,
            training=trial.kind == "training",
            break_before=trial.break_before,
            **{place: sha256[label] for place, label in shown(trial, task).items()},
        )
        for trial in trials
    ]


def _pictures(service: Service, trials: Sequence[Trial]) -> dict[str, PictureTold]:
    sizes = service.pictures.sizes
    labels = {label for trial in trials for label in trial.stimuli}
    shown = sorted(service.pictures.of_label[label] for label in labels)
    return {sha256: sizes[sha256] for sha256 in shown}
