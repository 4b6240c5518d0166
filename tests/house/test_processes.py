"""Work goes to other processes, forked ones too, and comes back as it would be done here."""

from __future__ import annotations

import multiprocessing
import os
import signal
from typing import Any

import joblib
import numpy as np
import pytest
from dask import delayed
from dask.base import compute

import nacreous as nc

ANGLE, NM = [0.0, 1.0], np.linspace(400.0, 700.0, 40)
#: What hangs for ever would hang the tests too.
PATIENCE_S = 300


def dispersed(nm: Any) -> Any:
    return 1.5 + 1e4 / nm**2


def stacks() -> list[nc.LayerStack]:
    return [nc.LayerStack([nm] * 30, 20.0, (1.683, 1.53), dispersed) for nm in (380.0, 400.0)]


def light_of(stack: nc.LayerStack) -> nc.optics.Energies:
    return nc.optics.energies(stack, ANGLE, NM)


def all_rooms(seed: int) -> tuple[object, ...]:
    """A result of each room that works on several threads."""
    answers = nc.scaling.simulate([0.5, 0.0, -0.5], people=8, seed=seed)
    fit = nc.scaling.thurstone(answers)
    picture = nc.render("akoya-rg", size=8, samples=1)
    codes, _ = picture.develop()
    return (
        light_of(stacks()[0]),
        nc.iridescence.illuminant_model(nc.LayerStack([420.0] * 10)),
        picture,
        codes.tobytes(),
        fit,
        fit.bootstrap(10, seed=seed),
        nc.texture.synthesise(nc.texture.GrainSpectrum.procedural(), 1.0, seed, 0.1),
    )


def pooled(method: str, work: Any, items: list[Any]) -> list[Any]:
    with multiprocessing.get_context(method).Pool(2) as pool:
        return pool.map_async(work, items).get(timeout=PATIENCE_S)


@pytest.mark.parametrize("method", ["spawn", "forkserver"])
def test_a_process_pool_answers_as_this_process_does(method: str) -> None:
    assert pooled(method, light_of, stacks()) == [light_of(stack) for stack in stacks()]


@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_process_forked_while_threads_were_at_work_answers_as_this_one_does() -> None:
    here = [all_rooms(seed) for seed in (1, 2)]
    assert pooled("fork", all_rooms, [1, 2]) == here
    assert pooled("fork", all_rooms, [1, 2]) == here  # and again, from a parent that was forked


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork here")
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_child_of_a_child_has_threads_too() -> None:
    """Each has a pool of its own; the exit code says whether its numbers are the parent's."""

    def exit_code(generations: int) -> int:
        child = os.fork()
        if child == 0:
            signal.alarm(PATIENCE_S)
            same = light_of(stacks()[0]) == here
            deeper = exit_code(generations - 1) if generations > 1 else 0
            os._exit(0 if same and deeper == 0 else 1)
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])

    here = light_of(stacks()[0])
    assert exit_code(2) == 0


def test_joblib_takes_stacks_out_and_brings_results_back() -> None:
    work = [joblib.delayed(light_of)(stack) for stack in stacks()]
    assert joblib.Parallel(n_jobs=2)(work) == [light_of(stack) for stack in stacks()]


def test_joblib_remembers_a_stack_by_its_numbers() -> None:
    first, second = (joblib.hash(nc.LayerStack([400.0] * 5)) for _ in range(2))
    assert first == second != joblib.hash(nc.LayerStack([401.0] * 5))


@pytest.mark.parametrize("scheduler", ["processes", "threads"])
def test_dask_takes_stacks_out_and_brings_results_back(scheduler: str) -> None:
    found = compute(*(delayed(light_of)(stack) for stack in stacks()), scheduler=scheduler)
    assert list(found) == [light_of(stack) for stack in stacks()]
