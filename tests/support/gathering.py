"""Small frozen studies of grey pictures, and made-up people who answer them. No data of people."""

from __future__ import annotations

import json
import secrets
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
from PIL import Image

from nacreous.study.design import Frozen, freeze
from nacreous.study.plan import Trial
from nacreous.study.running import Running
from nacreous.study.store import Response, Store

#: Chooses at a trial: "left", "right" or "tie".
Choosing = Callable[[Trial], str]


def frozen_study(folder: Path, labels: str = "abcde", **keys: Any) -> Frozen:
    """A study of so many pictures, frozen; keys as in a study file, the last ones tables."""
    for place, label in enumerate(labels):
        Image.new("RGB", (16, 16), (40 + 20 * place,) * 3).save(folder / f"{label}.png")
    design: dict[str, Any] = {
        "purpose": "demo",
        "questions": [{"id": "deeper", "text": {"en": "Which is deeper?", "ja": "どちらが深い?"}}],
        **keys,
    }
    design["stimuli"] = [{"label": label, "picture": f"{label}.png"} for label in labels]
    text = "\n".join(f"{name} = {_toml(value)}" for name, value in design.items())
    (folder / "study.toml").write_text(text + "\n", encoding="utf-8")
    return freeze(folder / "study.toml", folder / "study")


def _toml(value: Any) -> str:
    """A value as TOML, tables inline."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{name} = {_toml(one)}" for name, one in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return json.dumps(value, ensure_ascii=False)


def table_of(rows: list[dict[str, Any]]) -> pa.Table:
    """Rows as a task takes them for its flags."""
    text = ("kind", "question", "left", "right", "chosen", "excluded")
    kinds = {"number": pa.int64(), "response_ms": pa.float64(), "simulated": pa.bool_()}
    columns = {**dict.fromkeys(text, pa.string()), **kinds}
    return pa.table(
        {name: pa.array([row[name] for row in rows], kind) for name, kind in columns.items()}
    )


def opened(store: Store, frozen: Frozen) -> Running:
    """The study with its store, open for everyone."""
    running = Running(store, frozen)
    store.set_registration(running.study, "open", "test")
    return running


def take_part(
    running: Running, choose: Choosing, recorded: dict[str, str] | None = None, **more: Any
) -> int:
    """One made-up person answers everything; returns the number. more: of `Response`."""
    token = secrets.token_urlsafe(32)
    session = running.enter(token, "en", recorded or {})
    running.store.consent(session.id)
    session = running.session_of(token)
    waiting = [
        running.hand_in(
            session, trial.number, Response(choose(trial), **{"response_ms": 900.0, **more})
        )
        for trial in running.plan(session)
    ]
    for one in waiting:
        one.result()
    return session.number


def by_scale(scale: dict[str, float], random: np.random.Generator) -> Choosing:
    """Somebody who chooses by Thurstone's case V."""

    def choose(trial: Trial) -> str:
        lead = scale[trial.stimuli[0]] - scale[trial.stimuli[1]] + random.standard_normal()
        return "left" if lead > 0 else "right"

    return choose
