"""The room measure: what is known beforehand is found, and what cannot be measured is named."""

import json
import math
import re
from functools import cache

import numpy as np
import pytest

import nacreous as nc
from nacreous.measure import HUES, Measures, measure
from tests.measure.changes import CHANGES, DARKER, SPOTS, area, least, moved
from tests.measure.changes import picture as lit
from tests.measure.synthetic import MIDDLE, RADIUS, SIDE, Light, ball, ellipse, spotted


@pytest.mark.parametrize("ground", [0.0, 0.05, 0.9])
def test_a_disc_is_found_to_a_tenth_of_a_pixel_on_dark_and_on_white(ground: float) -> None:
    found = measure(ellipse(ground=ground))
    circle = found.outline.circle
    assert math.hypot(circle.x_px - MIDDLE[0], circle.y_px - MIDDLE[1]) < 0.1
    assert found.size.mean.value == pytest.approx(2 * RADIUS, abs=0.15)
    assert found.roundness is not None
    assert found.roundness.value < 0.3
    assert found.outline.share > 0.99


@pytest.mark.parametrize("percent", [0, 1, 2, 5, 10, 30])
def test_roundness_is_that_of_the_ellipse(percent: float) -> None:
    short = RADIUS * (200 - percent) / (200 + percent)
    found = measure(ellipse(RADIUS, short))
    mean = np.hypot(RADIUS * np.cos(a := np.linspace(0, np.pi, 721)), short * np.sin(a)).mean()
    assert found.roundness is not None
    assert found.roundness.value == pytest.approx(100 * (RADIUS - short) / mean, abs=0.25)
    assert found.size.greatest.value == pytest.approx(2 * RADIUS, abs=0.3)
    assert found.size.least.value == pytest.approx(2 * short, abs=0.3)


def test_what_is_no_sphere_has_size_roundness_and_colour_alone() -> None:
    found = measure(ellipse(RADIUS, 45.0))
    assert not found.sphere
    assert found.colour is not None
    assert (found.rings, found.interference, found.lamp, found.blemishes) == (None,) * 4
    assert {"rings", "lamp", "blemishes"} == set(found.refused)
    assert "no sphere" in found.refused["rings"]


@pytest.mark.parametrize("sigma_deg", [3.0, 5.0, 9.0])
def test_the_half_width_is_that_of_the_gaussian(sigma_deg: float) -> None:
    lamp = measure(ball(sigma_deg)).lamp
    assert lamp is not None
    assert lamp.half_width_deg.value == pytest.approx(sigma_deg * math.sqrt(2 * math.log(2)), 0.04)
    assert lamp.peak == pytest.approx(2.0 * 0.975, rel=0.05)
    assert lamp.contrast_gloss.value == pytest.approx(80.0, abs=1.5)
    half = sigma_deg * math.sqrt(2 * math.log(2))
    beyond = 100 * math.exp(-0.5 * ((half + 2.5) / sigma_deg) ** 2)
    assert lamp.haze is not None
    assert lamp.haze.value == pytest.approx(beyond, abs=2.5)


def test_the_sharper_image_is_the_more_distinct_one() -> None:
    sharp, soft = (measure(ball(sigma)).lamp for sigma in (3.0, 9.0))
    assert sharp is not None
    assert soft is not None
    assert sharp.distinctness is not None
    assert soft.distinctness is not None
    assert sharp.distinctness.value > 2 * soft.distinctness.value


def test_colour_is_relative_to_the_white_given() -> None:
    picture = ellipse()
    white = (0.5, 0.45, 0.42)
    colour = measure(picture, white=white).colour
    assert colour is not None
    assert colour.lightness.value == pytest.approx(100, abs=0.1)
    assert colour.chroma.value < 0.1
    assert colour.hue_deg is None


def test_spots_are_found_with_their_area_and_a_clean_ball_has_none() -> None:
    clean = ball(4.0)
    spotted = clean.copy()
    rows, columns = np.ogrid[:SIDE, :SIDE]
    for x, y in ((125, 115), (112, 80), (95, 130)):
        away = np.hypot(columns + 0.5 - x, rows + 0.5 - y)
        spotted *= (1 - 0.3 * np.clip(5.5 - away, 0, 1))[..., None].astype(np.float32)
    one, other = measure(clean).blemishes, measure(spotted).blemishes
    assert one is not None
    assert other is not None
    assert one.count == 0
    assert other.count == 3
    seen = 3 * math.pi * 5**2 / (2 * math.pi * RADIUS**2) / other.looked_at * 100
    assert other.area.value == pytest.approx(seen, rel=0.35)  # seen from aside they cover more


@pytest.mark.parametrize("rough", [0.0, 0.03])
def test_domes_of_another_colour_are_told_in_texture_of_lightness(rough: float) -> None:
    rows, columns = np.ogrid[:SIDE, :SIDE]
    noise = rough * np.random.default_rng(1).standard_normal((SIDE, SIDE, 1))
    clean = ball(4.0) * (1 + noise).astype(np.float32)
    found = []
    for radius in (0, 5, 7, 9):
        risen = clean.copy()
        for x, y in ((125, 115), (112, 80), (95, 130)):
            away = np.hypot(columns + 0.5 - x, rows + 0.5 - y)
            dome = np.maximum(1 - (away / max(radius, 0.1)) ** 2, 0)[..., None] ** 2
            risen *= 1 + dome * np.float32([0.24, -0.12, 0.12])
        found.append(measure(risen.astype(np.float32)))
    spots = [one.blemishes for one in found if one.blemishes is not None]
    assert [one.count for one in spots] == [0, 3, 3, 3]
    areas = [one.area.value for one in spots]
    assert areas == sorted(areas)
    assert "no spot" in found[0].refused["blemishes.relief"]
    assert "blemishes.relief" not in found[3].refused


def test_the_parts_of_a_score_lie_in_the_regions_of_their_hue() -> None:
    picture = ellipse()
    picture[picture[..., 0] > 0.3] = nc.colour.rgb_from_xyz(
        nc.colour.xyz_from_lab(np.array([70.0, 0.0, -30.0]))
    )
    spread = measure(picture).interference
    assert spread is not None
    by_hue = dict(zip(HUES, spread.by_hue, strict=True))
    assert by_hue["blue"] == pytest.approx(100, abs=1)
    assert spread.score.value == pytest.approx(sum(spread.by_hue))


@cache
def rendered(size: int = 320, pearl: str = "tahitian") -> Light:
    return nc.render(nc.Pearl.load(pearl), "north-window-black", size=size, samples=4).linear


@pytest.mark.parametrize("change", CHANGES)
def test_measures_stay_within_five_percent(change: str) -> None:
    for name, (before, after) in moved(rendered(), change).items():
        assert after == pytest.approx(before, rel=0.05, abs=0.05 * least(name)), name


@cache
def blemished(spots: str) -> Light:
    return lit("akoya-rg", "north-window-black", 384, spots)


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("spots", SPOTS)
def test_the_blemished_area_stays_within_five_percent(spots: str, change: str) -> None:
    before, after = moved(blemished(spots), change, DARKER, area)["area"]
    assert 2 < before < 7  # 6 on all of the pearl
    assert after == pytest.approx(before, rel=0.05)
    assert "blemishes.relief" not in measure(blemished(spots), white=(DARKER,) * 3).refused


@pytest.mark.parametrize(
    ("radius_rad", "count", "within"),
    [(0.04, 8, 1 / 3), (0.05, 8, 0.15), (0.07, 8, 0.15), (0.1, 6, 0.15), (0.13, 4, 0.15)],
)
def test_the_area_of_dark_spots_is_theirs(radius_rad: float, count: int, within: float) -> None:
    spots = measure(spotted(radius_rad, count)).blemishes
    assert spots is not None
    area = 100 * count * (1 - math.cos(radius_rad)) / spots.looked_at  # of half a ball
    assert spots.area.value == pytest.approx(area, rel=within)
    assert spots.count == count


def test_an_area_that_hangs_on_faint_spots_is_named_and_its_error_holds_what_jpeg_changes() -> None:
    linear = lit("tahitian", "north-window-black", 384, "chalky_spots")
    found = measure(linear, white=(DARKER,) * 3)
    assert found.blemishes is not None
    assert "JPEG" in found.refused["blemishes.relief"]
    before, after = moved(linear, "jpeg", DARKER, area)["area"]
    error = found.blemishes.area.error
    assert error is not None
    assert abs(after - before) < error


def test_spots_that_are_closed_in_part_are_named_as_unsure() -> None:
    found = moved(lit("tahitian", "north-window-black", 384, "pits"), "jpeg", DARKER, area)
    assert any(found["is unsure"])
    before, after = found["area"]
    assert abs(after / before - 1) > 0.05  # else there is nothing to name


def test_the_colour_of_a_pearl_lighter_than_the_white_is_refused_by_name() -> None:
    found = measure(rendered(), white=(0.02, 0.02, 0.02))
    assert found.colour is None
    assert re.search(r"lighter than the white .* L\* 1\d\d; allowed", found.refused["colour"])


def test_the_colour_of_a_pearl_that_is_clipped_over_a_quarter_is_refused_by_name() -> None:
    ends = float(np.quantile(rendered()[rendered().max(-1) > 0.05].max(-1), 0.5))
    found = measure(np.minimum(rendered(), ends), white=(ends,) * 3, clipped_at=ends)
    assert found.colour is None
    assert re.search(r"clipped in \d\d % of its pixels; allowed", found.refused["colour"])


def test_spots_of_a_pearl_under_forty_pixels_of_radius_are_refused_by_name() -> None:
    found = measure(rendered(96))
    assert found.blemishes is None
    assert "wanted: 40 or more" in found.refused["blemishes"]


def test_a_picture_without_a_pearl_is_refused_by_name() -> None:
    noise = np.random.default_rng(1).random((200, 200, 3)).astype(np.float32)
    rows, columns = np.ogrid[:200, :200]
    checks = np.where(((rows // 25 + columns // 25) % 2)[..., None], 0.3, 0.1) * np.ones(3)
    for picture in (noise, checks, np.full((64, 64, 3), 0.2)):
        with pytest.raises(nc.InputError, match="no pearl"):
            measure(picture)


def test_two_pearls_are_refused_by_name_and_measured_one_by_one_where_a_circle_is_given() -> None:
    one = ellipse()
    both = np.concatenate([one, one], axis=1)
    with pytest.raises(nc.InputError, match=r"more than one pearl: at \(.*\), radius 60"):
        measure(both)
    second = measure(both, circle=(MIDDLE[0] + SIDE + 2, MIDDLE[1] - 1, 58.0))
    assert second.outline.circle.x_px == pytest.approx(MIDDLE[0] + SIDE, abs=0.1)
    assert second.outline.given


def test_a_clipped_highlight_is_named_and_colours_are_measured_all_the_same() -> None:
    found = measure(np.minimum(ball(5.0), 1.0), clipped_at=0.97)
    assert found.lamp is None
    assert "clipped in" in found.refused["lamp"]
    assert found.rings is not None
    assert found.colour is not None


def test_a_pearl_that_is_cut_off_is_refused() -> None:
    with pytest.raises(nc.InputError, match=r"leaves the picture|no pearl|cannot be followed"):
        measure(ellipse()[:, 90:])


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"white": (0, 1, 1)}, "white is"),
        ({"white": (1, 1)}, "white has 2 numbers"),
        ({"mm_per_pixel": -1}, "mm_per_pixel is -1"),
        ({"clipped_at": 0}, "clipped_at is 0"),
        ({"circle": (1, 2, float("nan"))}, "radius is nan"),
        ({"circle": (10, 10, 50)}, "leaves the picture"),
        ({"circle": (64, 64, -4)}, "radius is -4; allowed: 12 pixels and more"),
    ],
)
def test_a_wrong_number_is_told(wrong: dict[str, object], said: str) -> None:
    with pytest.raises(nc.InputError, match=said):
        measure(ellipse(), **wrong)  # type: ignore[arg-type]


def test_a_small_pearl_has_size_and_colour_but_no_rings_and_no_lamps_image() -> None:
    found = measure(nc.render("akoya-rg", "north-window-black", size=112, samples=4))
    assert found.size.mean.value < 80
    assert found.rings is None
    assert found.lamp is None
    assert found.colour is not None
    for quantity in ("rings", "lamp"):
        assert found.refused[quantity] == "the pearl has 37 pixels of radius; wanted: 40 or more"


def test_a_lamps_image_narrower_than_its_pixels_is_named() -> None:
    found = measure(nc.render("tahitian", "paper", size=160, samples=4))
    assert found.lamp is None
    assert "3.1 pixels wide" in found.refused["lamp"]


def test_the_same_picture_gives_the_same_json() -> None:
    picture = rendered(128)
    text = measure(picture).to_json()
    assert text == measure(picture).to_json()
    assert json.loads(text)["size"]["unit"] == "px"


@pytest.mark.parametrize("scene", ["paper", "north-window-black", "north-window-white", "booth"])
@pytest.mark.parametrize("pearl", ["akoya-rg", "tahitian"])
def test_a_rendered_pearl_is_found_on_every_table(pearl: str, scene: str) -> None:
    found = measure(nc.render(pearl, scene, size=192, samples=4))
    circle = found.outline.circle
    assert math.hypot(circle.x_px - 96, circle.y_px - 96) < 1
    assert found.lamp is not None
    # It is a ball; an eye 12 diameters away sees it as wide as one 1/1152 wider.
    true = 192 * nc.Pearl.load(pearl).diameter_mm / nc.image.field_mm(pearl, scene) * (1 + 1 / 1152)
    roundness, width = found.roundness, found.size.mean
    assert roundness is not None
    assert roundness.error is not None
    assert width.error is not None
    assert width.value == pytest.approx(true, abs=2.5 * width.error)
    assert width.value == pytest.approx(true, rel=0.006)
    assert roundness.value < 3 * roundness.error


@pytest.mark.parametrize(
    ("shape", "scene"),
    [
        ({"length": 1.5}, "north-window-black"),
        ({"length": 1.45, "taper": 0.6}, "north-window-black"),
        ({"length": 0.74, "flattening": 0.8}, "booth"),
    ],
)
def test_the_outline_of_what_is_not_round_is_the_renders_own(
    shape: dict[str, float], scene: str
) -> None:
    picture = nc.render(nc.Pearl(nacre={"preset": "akoya-rg-1.0"}, shape=shape), scene, size=128)
    rows, columns = np.nonzero(np.reshape(picture.layers["coverage"], (128, 128)) >= 0.5)
    turns = np.linspace(0, np.pi, 180, endpoint=False)
    widths = np.array([np.ptp(columns * np.cos(a) + rows * np.sin(a)) + 0.9 for a in turns])
    found = measure(picture)
    assert found.size.mean.value == pytest.approx(widths.mean(), rel=0.02)
    assert found.roundness is not None
    assert found.roundness.value == pytest.approx(100 * np.ptp(widths) / widths.mean(), abs=4)


@pytest.mark.parametrize("beside", [1, 2])
def test_small_dark_pearls_among_checks_are_refused_rather_than_guessed(beside: int) -> None:
    one = nc.render("tahitian", "paper", size=64, samples=4).linear
    with pytest.raises(nc.InputError, match=r"no pearl|cannot be followed|more than one"):
        measure(np.concatenate([one] * beside, axis=1))


def test_wider_facets_give_wider_images_and_more_disorder_less_colour() -> None:
    def of(**keys: object) -> Measures:
        pearl = nc.Pearl(nacre={"preset": "akoya-rg-1.0"}, body={"nacre_mm": 0.5}, **keys)
        return measure(nc.render(pearl, "north-window-black", size=128, samples=4))

    images = [of(surface={"facet_spread_rad": spread}).lamp for spread in (0.04, 0.08, 0.14)]
    widths = [image.half_width_deg.value for image in images if image is not None]
    assert len(widths) == 3
    assert widths == sorted(widths)
    spreads = [of(film={"column_spread_nm": spread}).interference for spread in (10, 30, 50)]
    orient = [spread.orient.value for spread in spreads if spread is not None]
    assert len(orient) == 3
    assert orient == sorted(orient, reverse=True)
