"""Whatever form answers come in, every function takes them, or says which form it wants."""

import csv
import inspect
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import polars as pl
import pytest

import nacreous as nc
from nacreous.problem import InputError
from nacreous.scaling import Answers, simulate

STIMULI = ("a", "b", "c", "d")
LUSTRE = {"a": {"lustre": 2.0}, "b": {"lustre": 0.3}, "c": {"lustre": 1.0}, "d": {"lustre": 0.0}}
#: How each function is called that counts alone would do for.
COUNTED: dict[str, Callable[[Any], Any]] = {
    "agreement": nc.scaling.agreement,
    "analyse": lambda data: nc.scaling.analyse(data, bootstrap=0),
    "bradley_terry": nc.scaling.bradley_terry,
    "circular_triads": nc.scaling.circular_triads,
    "cluster_ratio": lambda data: nc.scaling.cluster_ratio(data, ["a", "b"], ["c", "d"]),
    "compare_groups": lambda data: nc.scaling.compare_groups(
        {"x": data, "y": data}, same_people=False, permutations=99
    ),
    "compare_ratios": lambda data: nc.scaling.compare_ratios(
        {"x": data, "y": data}, ["a", "b"], ["c", "d"], same_people=False
    ),
    "compare_sets": lambda data: nc.scaling.compare_sets(data, data, same_people=False),
    "comparisons_of": nc.scaling.comparisons_of,
    "consistency": nc.scaling.consistency,
    "fit_attributes": lambda data: nc.scaling.fit_attributes(data, LUSTRE),
    "next_pairs": nc.scaling.next_pairs,
    "thurstone": nc.scaling.thurstone,
    "transitivity": nc.scaling.transitivity,
}
#: Those that ask who answered, when, or on which side.
ANSWERED: dict[str, Callable[[Any], Any]] = {
    "always_tied": nc.scaling.always_tied,
    "person_covariates": lambda data: nc.scaling.person_covariates(data, permutations=99),
    "population": lambda data: nc.scaling.population(data, most=2, starts=2),
    "response_time": nc.scaling.response_time,
    "retest": nc.scaling.retest,
    "shared_scale": lambda data: nc.scaling.shared_scale(data, permutations=99),
    "side_bias": nc.scaling.side_bias,
    "triads_by_person": nc.scaling.triads_by_person,
}
#: Those that take no answers, but fits, quadruples, matrices, designs or nothing.
OTHERS = {
    *("goodness", "interval_plot", "matrix_plot", "scale_plot", "simulate"),
    *("concordance", "plackett_luce", "simulate_rankings"),
    *("cyclic_design", "full_design", "random_design", "paper", "paper_proportions"),
    *("difference_scale", "difference_goodness", "six_points", "simulate_quadruples"),
    *("full_quadruples", "random_quadruples"),
}


@pytest.fixture(scope="module")
def frame() -> pd.DataFrame:
    """Answers with all that a function may ask for: people, sides, repeats, times and a column."""
    made = simulate(dict(zip(STIMULI, (0.6, 0.2, -0.2, -0.6), strict=True)), 16, repeats=2, seed=3)
    chosen = np.where(made.outcome == 1, made.left, made.right)
    labels = np.array(made.stimuli)
    return pd.DataFrame(
        {
            **{"left": labels[made.left], "right": labels[made.right], "chosen": labels[chosen]},
            "person": [f"p{person}" for person in made.person],
            "trial": np.arange(len(made)),
            "response_s": 0.5 + np.arange(len(made)) % 7,
            "eye": np.where(made.person % 2, "left-eyed", "right-eyed"),
        }
    )


def fields(found: Any) -> str:
    """All that was found, with numbers as far as a file keeps them."""
    with np.printoptions(precision=9, threshold=100_000):
        state = getattr(found, "__dict__", None)
        return str(found) if state is None else str({**state, "pair_model": None})


def test_every_public_function_is_known_to_take_answers_or_not() -> None:
    public = {name: getattr(nc.scaling, name) for name in nc.scaling.__all__}
    functions = {name for name, value in public.items() if inspect.isfunction(value)}
    assert functions == {*COUNTED, *ANSWERED, *OTHERS}


@pytest.mark.parametrize("name", [*COUNTED, *ANSWERED])
def test_a_table_and_a_file_say_what_their_answers_say(
    name: str, frame: pd.DataFrame, tmp_path: Path
) -> None:
    asked = (COUNTED | ANSWERED)[name]
    path = tmp_path / "answers.csv"
    frame.to_csv(path, index=False)
    wanted = fields(asked(Answers.of_table(frame)))
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    for given in (frame, frame.to_dict("list"), frame.to_dict("records"), rows, path, str(path)):
        assert fields(asked(given)) == wanted


@pytest.mark.parametrize("name", ANSWERED)
@pytest.mark.parametrize(
    "data", [[[0, 3], [2, 0]], nc.scaling.paper(), np.ones((3, 3)) - np.eye(3)]
)
def test_counts_are_refused_by_what_asks_for_each_answer(name: str, data: Any) -> None:
    with pytest.raises(InputError, match=r"are counts.*Answers\.read\(path\) or Answers\.of_table"):
        ANSWERED[name](data)


@pytest.mark.parametrize("name", [*COUNTED, *ANSWERED])
@pytest.mark.parametrize("data", [7, object(), {"left": ["a"]}])
def test_what_holds_no_answers_is_refused_in_plain_words(name: str, data: Any) -> None:
    with pytest.raises(InputError):
        (COUNTED | ANSWERED)[name](data)


@pytest.mark.parametrize("form", ["pandas", "polars", "pyarrow", "rows", "column"])
def test_no_message_shows_what_a_table_holds(form: str, frame: pd.DataFrame) -> None:
    table = {
        "pandas": frame,
        "polars": pl.DataFrame(frame.to_dict("list")),
        "pyarrow": pl.DataFrame(frame.to_dict("list")).to_arrow(),
        "rows": frame.to_dict("records"),
        "column": frame["left"],
    }[form]
    held = f"a {type(table).__name__} of {len(table)} {'dicts' if form == 'rows' else 'rows'}; "
    for begin, asked in (
        ("groups is ", lambda: nc.scaling.compare_groups(table, "eye")),
        ("groups is ", lambda: nc.scaling.compare_ratios(table, ["a"], ["b"])),
        ("fit is ", lambda: nc.scaling.goodness(table)),
        ("fits holds ", lambda: nc.scaling.scale_plot(table, "scale.svg")),
        ("scale is ", lambda: nc.scaling.simulate(table, 4)),
        ("path is ", lambda: nc.scaling.Answers.read(table)),
        ("path is ", lambda: nc.scaling.Comparisons.read_counts(table)),
    ):
        with pytest.raises(InputError) as refused:
            asked()
        assert str(refused.value).startswith(begin + held)
        assert len(str(refused.value)) < 150


def test_people_of_a_table_of_winners_are_people(frame: pd.DataFrame) -> None:
    loser = frame["right"].where(frame["chosen"] == frame["left"], frame["left"])
    table = pd.DataFrame({"winner": frame["chosen"], "loser": loser, "person": frame["person"]})
    fit = nc.scaling.thurstone(Answers.of_table(table, repeats=True))
    assert fit.answers.people
    table["trial"] = frame["trial"]
    assert nc.scaling.thurstone(table).answers.people == fit.answers.people


def test_answers_in_place_of_a_fit_are_refused_with_what_makes_one(
    frame: pd.DataFrame, tmp_path: Path
) -> None:
    path = tmp_path / "scale.svg"
    for data in (frame, Answers.of_table(frame), [("a", "b")]):
        for drawn in (
            lambda fit: nc.scaling.scale_plot(fit, path),
            lambda fit: nc.scaling.interval_plot({"x": fit}, path, intervals={"x": [[0, 1]]}),
            nc.scaling.goodness,
        ):
            with pytest.raises(InputError, match=r"such as thurstone\(answers\)"):
                drawn(data)
    assert not path.exists()
