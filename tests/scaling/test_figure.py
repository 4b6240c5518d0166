"""Drawings of scales and matrices: nothing overlaps, nothing is lost, the same data give the same
bytes."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

import nacreous as nc
from nacreous.scaling.figure import interval_plot, matrix_plot, scale_plot
from nacreous.scaling.figure.lettering import elided, spread, ticks, width_pt


def fit(values, stimuli=None, unit="z"):
    labels = stimuli or tuple(str(at) for at in range(1, len(values) + 1))
    return SimpleNamespace(stimuli=labels, scale=np.array(values, float), unit=unit)


def texts(path: Path) -> list[tuple[float, float, str, str]]:
    """x, y, style and words of each text of an SVG."""
    found = []
    for look, words in re.findall(r"<text ([^>]*)>([^<]*)</text>", path.read_text()):
        style = re.search(r'style="([^"]*)"', look)[1]
        x, y = re.search(r'(?:x="|translate\()([-\d.]+)"? ?(?:y=")?([-\d.]+)', look).groups()
        found.append((float(x), float(y), style, words))
    return found


# --- where labels go


@settings(deadline=None, max_examples=200)
@given(
    some.lists(some.floats(0, 400), min_size=1, max_size=30),
    some.lists(some.floats(4, 40), min_size=30, max_size=30),
)
def test_spread_labels_never_overlap_nor_leave_the_sheet(places, sizes):
    at, widths = np.sort(places), np.array(sizes[: len(places)])
    centres = spread(at, widths, 0.0, 400.0)
    if widths.sum() > 400:
        assert centres is None
        return
    edges = np.stack([centres - widths / 2, centres + widths / 2], axis=1)
    assert edges[0, 0] > -1e-9
    assert edges[-1, 1] < 400 + 1e-9
    assert np.all(edges[1:, 0] - edges[:-1, 1] > -1e-9)


def test_labels_with_room_stay_where_they_belong():
    at = np.array([50.0, 100.0, 300.0])
    assert spread(at, np.full(3, 20.0), 0.0, 400.0).tolist() == at.tolist()


def test_words_are_cut_to_their_room_and_to_one_line():
    assert elided("pearl", 1000.0) == "pearl"
    assert width_pt(elided("真珠" * 40, 60.0)) <= 60.0
    assert "\n" not in elided("two\nlines", 1000.0)


def test_ticks_are_round_and_inside():
    found = ticks(-0.943, 0.858, 5)
    assert all(-0.943 <= tick <= 0.858 for tick in found)
    assert 0.0 in found


# --- what is drawn


@pytest.mark.parametrize("count", [2, 7, 30, 200])
@pytest.mark.parametrize("width", [200.0, 480.0])
def test_labels_of_a_scale_never_overlap(tmp_path, count, width):
    values = np.random.default_rng(count).normal(size=count).round(1)
    labels = tuple(f"stimulus {at}" for at in range(count))
    scale_plot(fit(values, labels), tmp_path / "a.svg", width_pt=width)
    placed = sorted(
        (x, style, words) for x, _, style, words in texts(tmp_path / "a.svg") if "stim" in words
    )
    assert placed
    upright = "rotate(-90 " in (tmp_path / "a.svg").read_text()
    for (x, _, words), (after, _, later) in pairwise(placed):
        room = width_pt("M") if upright else (width_pt(words) + width_pt(later)) / 2
        assert after - x >= room


def test_every_stimulus_has_its_point_where_labels_are_left_out(tmp_path):
    scale_plot(fit(np.linspace(-1, 1, 200)), tmp_path / "a.svg", width_pt=200)
    text = (tmp_path / "a.svg").read_text()
    assert re.search(r">\(\d+ / 200\)<", text)
    assert text.count("<use ") >= 200


def test_places_on_the_line_are_in_proportion(tmp_path):
    scale_plot(fit([-1.0, 0.0, 3.0]), tmp_path / "a.svg")
    points = re.findall(r'<use xlink:href="#[^"]*" x="([\d.]+)"', (tmp_path / "a.svg").read_text())
    low, middle, high = (float(x) for x in points[:3])
    assert (high - middle) / (middle - low) == pytest.approx(3, abs=1e-3)


def test_groups_stand_below_each_other_on_one_axis(tmp_path):
    both = {"women": fit([0.0, 1.0]), "men": fit([0.0, 2.0])}
    scale_plot(both, tmp_path / "a.svg")
    points = re.findall(
        r'<use xlink:href="#[^"]*" x="([\d.]+)" y="([\d.]+)"', (tmp_path / "a.svg").read_text()
    )
    x, y = np.array(points, float).T
    assert x[0] == x[2]
    assert x[3] - x[2] == pytest.approx(2 * (x[1] - x[0]), abs=1e-3)
    assert y[0] < y[2]
    words = [words for *_, words in texts(tmp_path / "a.svg")]
    assert "women" in words
    assert "men" in words


def test_dollars_angles_and_japanese_are_text_as_they_stand(tmp_path):
    labels = ("$x$", "<b>&", "真珠")
    scale_plot(fit([0, 1, 2], labels, "心理尺度値"), tmp_path / "a.svg")
    words = [words for *_, words in texts(tmp_path / "a.svg")]
    for expected in ("$x$", "&lt;b&gt;&amp;", "真珠", "心理尺度値"):
        assert expected in words


def test_intervals_reach_from_end_to_end(tmp_path):
    ends = [[-0.5, 0.5], [0.5, 1.5]]
    interval_plot(fit([0.0, 1.0]), tmp_path / "a.svg", intervals=ends)
    bars = re.findall(
        r'd="M ([\d.]+) ([\d.]+) \nL ([\d.]+) ([\d.]+)', (tmp_path / "a.svg").read_text()
    )
    flat = [(float(a), float(c)) for a, b, c, d in bars if b == d and float(a) > 0]
    assert len(flat) == 2
    # The more preferred one is on top, so its bar comes first; both have one length.
    assert flat[0][0] == pytest.approx(flat[1][1], abs=1e-3)
    assert flat[0][1] - flat[0][0] == pytest.approx(flat[1][1] - flat[1][0], abs=1e-3)


def test_a_matrix_shows_its_numbers_where_there_is_room(tmp_path):
    share = np.array([[np.nan, 0.77], [0.23, np.nan]])
    matrix_plot(share, ["a", "b"], tmp_path / "a.svg", order=[1, 0])
    words = [words for *_, words in texts(tmp_path / "a.svg")]
    assert words.index("23") < words.index("77")
    matrix_plot(np.full((100, 100), 0.5), [f"s{at}" for at in range(100)], tmp_path / "b.svg")
    assert "50" not in [words for *_, words in texts(tmp_path / "b.svg")]


@pytest.mark.parametrize("ending", [".svg", ".png", ".pdf"])
def test_the_same_data_give_the_same_bytes(tmp_path, ending):
    scale = nc.scaling.thurstone(nc.scaling.paper())
    for name in ("a", "b"):
        scale_plot(scale, tmp_path / f"{name}1{ending}")
        interval_plot(scale, tmp_path / f"{name}2{ending}", intervals=scale.intervals())
        matrix_plot(scale.proportions, scale.stimuli, tmp_path / f"{name}3{ending}")
    for number in "123":
        first, second = (tmp_path / f"{name}{number}{ending}" for name in "ab")
        assert first.read_bytes() == second.read_bytes()
        assert first.stat().st_size > 1000


# --- what is refused


@pytest.mark.parametrize(
    ("draw", "message"),
    [
        (lambda p: scale_plot(fit([0, 1]), p / "a.gif"), "the ending is .gif; allowed: .svg"),
        (lambda p: scale_plot(fit([0, 1]), p / "a.svg", width_pt=10), "width_pt is 10; allowed"),
        (lambda p: scale_plot({}, p / "a.svg"), "there are 0 scales to draw; allowed: 1 or more"),
        (
            lambda p: scale_plot({"a": fit([0, 1]), "b": fit([0, 1, 2])}, p / "a.svg"),
            "scale 'b' is of other stimuli; allowed: the same for all",
        ),
        (
            lambda p: scale_plot({"a": fit([0, 1]), "b": fit([0, 1], unit="JOD")}, p / "a.svg"),
            "scale 'b' is in JOD; allowed: z",
        ),
        (
            lambda p: interval_plot(fit([0, 1]), p / "a.svg", intervals=[[0, 1]]),
            "intervals is an array of 1 x 2; allowed: 2 x 2 finite numbers",
        ),
        (
            lambda p: interval_plot(fit([0, 1]), p / "a.svg", intervals=[[0, np.inf]] * 2),
            "allowed: 2 x 2 finite numbers",
        ),
        (
            lambda p: matrix_plot(np.eye(3), ["a", "b"], p / "a.svg"),
            "values is an array of 3 x 3; allowed: 2 x 2",
        ),
        (
            lambda p: matrix_plot(np.eye(2), ["a", "b"], p / "a.svg", order=[0, 0]),
            "order is no arrangement of 0 to 1",
        ),
        (
            lambda p: matrix_plot(np.eye(2), ["a", "b"], p / "a.svg", kind="heat"),
            "kind is 'heat'; allowed: proportions, residuals",
        ),
    ],
)
def test_what_cannot_be_drawn_is_refused_and_leaves_no_file(tmp_path, draw, message):
    with pytest.raises(nc.InputError, match=re.escape(message)):
        draw(tmp_path)
    assert not list(tmp_path.iterdir())
