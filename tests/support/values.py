"""One example of every public class of results, by the modules that offer them."""

from __future__ import annotations

import importlib
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

import nacreous as nc
from nacreous import medium, nacre, optics, scaling, spec, texture

#: What people reach as `nc.` and one step beyond.
MODULES = (
    "nacreous",
    "nacreous.body",
    "nacreous.colour",
    "nacreous.file",
    "nacreous.image",
    "nacreous.iridescence",
    "nacreous.medium",
    "nacreous.nacre",
    "nacreous.optics",
    "nacreous.scaling",
    "nacreous.spec",
    "nacreous.texture",
)


def public_classes() -> dict[str, type]:
    """Every class of ours that a public module offers, by module and name."""
    found = {}
    for module in MODULES:
        offering = importlib.import_module(module)
        for name in getattr(offering, "__all__", dir(offering)):
            item = getattr(offering, name)
            if isinstance(item, type) and item.__module__.startswith("nacreous"):
                found[f"{item.__module__}.{item.__qualname__}"] = item
    return found


def index_of(nm: Any) -> Any:
    """A medium that is a function."""
    return 1.5 + 1e4 / nm**2


def glass() -> medium.PublishedIndex:
    """N-BK7 as refractiveindex.info publishes it, in few words."""
    coefficients = "0 1.03961212 0.00600069867 0.231792344 0.0200179144 1.01046945 103.560653"
    with TemporaryDirectory() as folder:
        file = Path(folder, "N-BK7.yml")
        file.write_text(
            "DATA:\n  - type: formula 2\n    wavelength_range: 0.3 2.5\n"
            f"    coefficients: {coefficients}\n"
        )
        return medium.read(file)


@cache
def examples() -> tuple[object, ...]:
    """Results as users get them; each class of `public_classes` is among them."""
    return (*_of_layers(), *_of_pictures(), *_of_files(), *_of_answers(), *_of_plans())


def _of_layers() -> list[object]:
    table = medium.IndexTable([400.0, 800.0], [1.5 + 0.01j, 1.5], [1.6, 1.6])
    stack = nc.LayerStack([380.0] * 20, 20.0, (1.683, 1.53), table, 1.0, "aragonite")
    light = ([0.0, 1.0], [450.0, 550.0])
    return [
        table,
        stack,
        nc.LayerStack([400.0], protein=index_of),
        nacre.diary(spec.Growth(seed=7)),
        optics.fresnel(1.0, 1.5, [0.0, 0.5]),
        optics.energies(stack, *light),
        optics.amplitudes(stack, *light),
        optics.depth_profile(stack, [0.0, 500.0], *light),
        nc.LayerStack([380.0, 390.0], [20.0, 30.0], cover=[(table, 100.0), (1.33, 50.0)]),
        glass(),
        optics.ensemble("akoya-rg", *light, columns=2),
        nc.iridescence.illuminant_model(nc.LayerStack([420.0] * 10)),
    ]


def _of_pictures() -> list[object]:
    grain = texture.GrainSpectrum.procedural()
    noise = np.random.default_rng(1).uniform(0.3, 0.5, (64, 64, 3))
    return [
        nc.render("paper", size=8, samples=1),
        grain,
        texture.synthesise(grain, radius_mm=1.0, seed=3, footprint_rad=0.1),
        texture.analyse(noise, side_px=32, corners=[(0, 0), (16, 16)]),
    ]


def _of_files() -> list[object]:
    pearl, scene = nc.Pearl.load("akoya-rg"), nc.Scene.load("booth")
    made = (getattr(spec, name) for name in spec.__all__ if isinstance(getattr(spec, name), type))
    needed = {"Lamp", "Layers", "Pearl", "Row", "Scene", "Uniaxial", "Window"}
    plain = [kind() for kind in made if isinstance(kind, type) and kind.__name__ not in needed]
    layers = spec.Layers(thickness_nm=[400.0, 410.0])
    sides = {"azimuth_deg": 30.0, "elevation_deg": 40.0}
    lamp, window = spec.Lamp(**sides), spec.Window(**sides)
    uniaxial = spec.Uniaxial(n_o=1.68, n_e=1.53)
    return [pearl, scene, lamp, window, layers, uniaxial, spec.Row(pearls=["akoya-rg"]), *plain]


TRUTH = {"a": 0.6, "b": 0.2, "c": -0.2, "d": -0.6}


@cache
def _answers() -> scaling.Answers:
    simulated = scaling.simulate(TRUTH, people=8, repeats=2)
    label = np.array(simulated.stimuli)
    left, right = label[simulated.left], label[simulated.right]
    seconds = np.random.default_rng(2).uniform(0.5, 3, len(simulated))
    table = {
        "left": left,
        "right": right,
        "chosen": np.where(simulated.outcome > 0, left, right),
        "person": np.array(simulated.people)[simulated.person],
        "response_s": seconds,
        "trial": np.arange(len(simulated)),
        "lamp": np.where(seconds > 1, "D50", "D65"),
    }
    return scaling.Answers.of_table(table)


def _of_answers() -> list[object]:
    answers, other = _answers(), scaling.simulate(TRUTH, 6, seed=3)
    fit = scaling.thurstone(answers)
    checks = scaling.consistency(answers, fit.scale)
    attributes = {label: {"lustre": float(k)} for k, label in enumerate(answers.stimuli)}
    weighed = scaling.fit_attributes(answers, attributes)
    two = {"one": answers, "two": other}
    rankings = scaling.simulate_rankings(TRUTH, 8, seed=3)
    people = scaling.population(answers, most=2, starts=2)
    groups = scaling.compare_groups(two, same_people=False, permutations=99)
    return [
        answers,
        answers.groups["lamp"],
        answers.comparisons(),
        fit,
        fit.difference("a", "b"),
        fit.bootstrap(20, seed=1),
        checks,
        *(getattr(checks, name) for name in ("triads", "transitivity", "agreement", "retest")),
        *(checks.people[0], checks.side, checks.side.left, checks.response),
        scaling.transitivity([("a", "b"), ("b", "c"), ("c", "a")]).worst[0],
        scaling.goodness(fit),
        scaling.goodness(fit).largest,
        weighed,
        weighed.weights[0],
        weighed.misfit,
        weighed.predict({"lustre": 1.5}),
        groups,
        groups.tests[0],
        groups.differences[0],
        scaling.GroupStyle("ties", {"a": 0.4, "b": 0.1}, 9.5, 1, 0.01, 0.02),
        people,
        people.candidates[0],
        scaling.PersonClass(0.4, ("mika", "jun"), np.array([0.5, 0.0, -0.5]), -0.9),
        scaling.AlwaysTied("mika", 3, 3),
        scaling.Covariate("age", 6, "number", 40.0, 2.5, 0.1, 0.2),
        scaling.shared_scale(answers),
        scaling.cluster_ratio(answers, "ab", "cd"),
        scaling.compare_ratios(two, "ab", "cd", same_people=False),
        scaling.compare_sets(answers, other, same_people=False, samples=200),
        scaling.analyse(answers, bootstrap=100),
        rankings,
        scaling.plackett_luce(rankings),
        scaling.concordance(rankings, 99),
    ]


def _of_plans() -> list[object]:
    plan = scaling.Plan({"a": -0.5, "b": 0.0, "c": 0.5}, people=6)
    judged = scaling.simulate_quadruples([0.0, 0.4, 0.9, 1.5, 2.2, 3.0], people=20)
    differences = scaling.difference_scale(judged)
    return [
        plan,
        plan.power("a", "c", studies=20),
        plan.precision(studies=20),
        plan.people_needed("a", "c", studies=20),
        scaling.full_design(["a", "b", "c"]),
        judged,
        differences,
        scaling.difference_goodness(differences, samples=20),
        scaling.six_points(differences, samples=20),
        scaling.full_quadruples(5),
        *scaling.next_pairs(stimuli=["a", "b", "c"]),
    ]
