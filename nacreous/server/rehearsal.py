"""A rehearsal: simulated observers take part by HTTP, as browsers do, before people come.

They answer from a scale that is known, as the task has it (pairs by Thurstone's case V), and every
answer says that it is simulated. Numbers decide what each one answers: same seed and number, same
answers.
"""

from __future__ import annotations

import csv
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from nacreous.missing import missing
from nacreous.number import number_of, seed_of, whole_of
from nacreous.problem import InputError
from nacreous.scaling.data.fault import listed, quoted
from nacreous.scaling.data.label import label_of
from nacreous.scaling.data.spreadsheet import as_given
from nacreous.server.client import Client
from nacreous.server.observer import responses
from nacreous.study.design import Frozen
from nacreous.study.task.task import Task
from nacreous.study.task.tasks import TASKS

__all__ = ["Rehearsed", "rehearse", "scale_of"]

#: Who answers at the same time. More wait for each other in one process.
_THREADS = 6
_MOST_OBSERVERS = 10_000


@dataclass(frozen=True)
class Rehearsed:
    """What was done: how many took part, how many answers, how long it took."""

    observers: int
    answers: int
    seconds: float


def rehearse(
    url: str,
    frozen: Frozen,
    scale: Mapping[str, float],
    observers: int,
    *,
    seed: int = 1,
    sigma: float = 1.0,
    links: Sequence[str] = (),
    progress: Callable[[float], None] | None = None,
) -> Rehearsed:
    """Let simulated observers take part in the study that is served at a URL.

    frozen: that study, which says which picture has which label. scale: label -> value. sigma: the
    noise of an answer in the unit of the scale, as `Task.simulate` has it. links: invitations, one
    an observer; without them the study must be open. progress: called with the finished share.

    Raises `InputError` for values that cannot be used, where nobody answers at the URL, where
    another study is served there, and where the study lets nobody in.
    """
    count = whole_of("observers", observers, 1, _MOST_OBSERVERS)
    noise = number_of("sigma", sigma)
    if not 0 < noise <= 100:
        raise InputError(f"sigma is {noise:g}; allowed: above 0, to 100")
    if links and len(links) < count:
        raise InputError(f"links are {len(links)}; allowed: {count}, one for each observer")
    values = _by_picture(frozen, scale)
    begin = time.monotonic()
    crew = _Crew(url, TASKS[frozen.design.task], values, seed_of(seed), noise)
    tokens: list[str | None] = [link.rpartition("#")[2] for link in links[:count]]
    answers = crew.run(tokens or [None] * count, progress)
    return Rehearsed(count, answers, time.monotonic() - begin)


def scale_of(name: str) -> dict[str, float]:
    """The values of a scale: "paper" for table 1, or a CSV file with columns stimulus and scale.

    Such a file is what `nacreous scale -o scale.csv` writes.

    >>> list(scale_of("paper"))
    ['1', '2', '3', '4', '5', '6', '7']
    """
    if name == "paper":
        from nacreous.scaling import Comparisons, paper_proportions, thurstone

        # The number of answers does not move row means of shares that are not 0 or 1.
        table = Comparisons.of_proportions(paper_proportions(), answers=104)
        fit = thurstone(table, method="least-squares")
        return dict(zip(fit.stimuli, fit.scale.tolist(), strict=True))
    try:
        with Path(name).open(encoding="utf-8-sig", newline="") as lines:
            rows = list(csv.DictReader(lines))
        return {label_of(as_given(row["stimulus"])): float(row["scale"]) for row in rows}
    except FileNotFoundError:
        raise missing(name, "paper, or a CSV file") from None
    except OSError as problem:
        raise InputError(f"{name}: cannot be read ({problem.strerror})") from None
    except (AttributeError, KeyError, TypeError, ValueError, csv.Error):
        raise InputError(
            f"{name}: is no scale; wanted: paper, or CSV with the columns stimulus and scale"
        ) from None


def _by_picture(frozen: Frozen, scale: Mapping[str, float]) -> dict[str, float]:
    known = {label_of(label): value for label, value in scale.items()}
    values = {}
    for stimulus in frozen.stimuli:
        name = quoted(stimulus.label)
        if stimulus.label not in known:
            raise InputError(f"scale has no value for {name}; it has: {listed(known)}")
        values[stimulus.sha256] = number_of(f"scale[{name}]", known[stimulus.label])
    return values


class _Crew:
    """Simulated observers of one rehearsal, and the lines that they share."""

    def __init__(
        self, url: str, task: Task[Any], values: Mapping[str, float], seed: int, sigma: float
    ) -> None:
        self._url = url
        self._task = task
        self._values = values
        self._seed = seed
        self._sigma = sigma
        self._own = threading.local()
        self._lines: list[Client] = []

    def run(self, tokens: Sequence[str | None], progress: Callable[[float], None] | None) -> int:
        """Everyone enters in order, so that numbers do not hang on threads; then all answer."""
        show = progress or (lambda _: None)
        study = self._client.ask("GET", "/api/study")
        sittings: list[Future[int]] = []
        pool = ThreadPoolExecutor(_THREADS, thread_name_prefix="observer")
        try:
            for place, token in enumerate(tokens):
                sittings.append(pool.submit(self._take_part, *self._enter(study, place, token)))
                show((place + 1 + _finished(sittings)) / (2 * len(tokens)))
            for sitting in as_completed(sittings):
                sitting.result()
                show((len(tokens) + _finished(sittings)) / (2 * len(tokens)))
        finally:
            pool.shutdown(cancel_futures=True)
            for line in self._lines:
                line.close()
        return sum(sitting.result() for sitting in sittings)

    @property
    def _client(self) -> Client:
        """The line of the thread that asks."""
        if not hasattr(self._own, "client"):
            self._own.client = Client(self._url)
            self._lines.append(self._own.client)
        client: Client = self._own.client
        return client

    def _enter(self, study: Any, place: int, token: str | None) -> tuple[str, int, Any]:
        """Enter as a person would who answers what is asked by chance; the token and the number."""
        random = np.random.default_rng([self._seed, 0, place])
        groups = {
            factor["name"]: str(random.choice([one["value"] for one in factor["choices"]]))
            for factor in study["groups"]
        }
        languages = study["languages"]
        content = {"language": languages[place % len(languages)], "groups": groups}
        if token is None:
            token = str(self._client.ask("GET", "/api/study")["token"])
        entered = self._client.ask("POST", "/api/enter", token, content)
        return token, int(entered["number"]), study["screen"]

    def _take_part(self, token: str, number: int, screen: Mapping[str, Any]) -> int:
        """From consent to the last page; how many answers were given."""
        client = self._client
        client.ask("POST", "/api/consent", token)
        client.ask("POST", "/api/screen", token, {"content": _good_screen(screen)})
        sitting = client.ask("GET", "/api/sitting", token)
        told, places = sitting["trials"], self._task.places
        trials = [tuple(trial[place] for place in places) for trial in told]
        if not all(stimulus in self._values for shown in trials for stimulus in shown):
            raise InputError(f"{self._url}: serves another study; wanted: the one given")
        answers = responses(
            self._task, trials, self._values, number, seed=self._seed, sigma=self._sigma
        )
        for trial, one in zip(told, answers, strict=True):
            content = {"chosen": one.given, "response_ms": one.response_ms, "simulated": True}
            client.ask("PUT", f"/api/answers/{trial['trial']}", token, content)
        client.ask("POST", "/api/finish", token)
        return len(trials)


def _finished(sittings: Sequence[Future[int]]) -> int:
    return sum(sitting.done() for sitting in sittings)


def _good_screen(wanted: Mapping[str, Any]) -> dict[str, Any]:
    """A check that finds nothing, of a screen that is not there."""
    width_px, height_px = wanted["least_width_px"], wanted["least_height_px"]
    return {
        "window": {"width_px": width_px, "height_px": height_px, "device_pixel_ratio": 1},
        "full_screen": True,
        "card": {"px_per_mm": 4.0},
        "distance_mm": 600,
        "distance_by": "none",
        "gamma": 2.2,
        "darkest_step": 1,
        "gamut": "srgb",
        "vision": {test: {"right": 1, "of": 1} for test in wanted["vision"]},
        "agent": "simulated",
    }
