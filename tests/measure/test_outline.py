"""The outline of a pearl: where it is under blur, and where it is refused rather than guessed."""

import math
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import nacreous as nc
from nacreous.cli import main
from nacreous.measure import measure
from nacreous.trade import with_words
from tests.measure.synthetic import MIDDLE, RADIUS, SIDE, Light, ball, binned, ellipse, places


def blurred(linear: Light, sigma_px: float) -> Light:
    """By a Gaussian, the border going on."""
    reach = math.ceil(4 * sigma_px)
    offs = np.arange(-reach, reach + 1)
    weights = np.exp(-0.5 * (offs / max(sigma_px, 0.01)) ** 2)
    for axis in (0, 1):
        at = [
            np.clip(np.arange(linear.shape[axis]) + off, 0, linear.shape[axis] - 1) for off in offs
        ]
        parts = zip(weights / weights.sum(), at, strict=True)
        linear = np.sum([weight * linear.take(one, axis) for weight, one in parts], axis=0)
    return linear.astype(np.float32)


def of_word(word: str, pearl: str, scene: str, size: int = 192) -> nc.Image:
    """A pearl of a shape by the trade's word."""
    sets = with_words([f"shape={word}"], [])
    keys = [(key, value) for key, _, value in (one.partition("=") for one in sets)]
    return nc.render(nc.Pearl.load(pearl, keys), scene, size=size, samples=4)


@pytest.mark.parametrize("ground", [0.03, 0.9])
@pytest.mark.parametrize("sigma_px", [0.0, 1.0, 1.5, 2.0, 3.0])
def test_blur_moves_no_diameter(sigma_px: float, ground: float) -> None:
    linear = ball(5.0)
    x, y = places()
    outside = binned(
        np.repeat((np.hypot(x - MIDDLE[0], y - MIDDLE[1]) > RADIUS)[..., None], 3, 2) * 1.0
    )
    linear = (linear + (ground - 0.03) * outside).astype(np.float32)
    found = measure(blurred(linear, sigma_px))
    assert found.size.mean.value == pytest.approx(2 * RADIUS, abs=0.3)
    assert found.roundness.value < 0.3


def test_the_error_of_a_diameter_grows_with_blur_and_holds_what_it_is_off_by() -> None:
    picture = nc.render("tahitian", "north-window-black", size=192, samples=4).linear
    true = (
        192
        * nc.Pearl.load("tahitian").diameter_mm
        / nc.image.field_mm("tahitian", "north-window-black")
    )
    errors = []
    for sigma_px in (0.0, 1.5, 3.0):
        width = measure(blurred(picture, sigma_px)).size.mean
        assert width.error is not None
        assert width.value == pytest.approx(true, abs=2 * width.error)
        errors.append(width.error)
    assert errors == sorted(errors)
    assert errors[2] > 2 * errors[0]


@pytest.mark.parametrize(
    ("word", "pearl", "scene"),
    [
        ("drop", "akoya-cream", "north-window-white"),
        ("button", "akoya-rg", "north-window-white"),
        ("button", "tahitian", "booth"),
        ("oval", "tahitian", "north-window-white"),
    ],
)
def test_half_a_pearl_or_a_pearl_with_its_shadow_is_refused_by_name(
    word: str, pearl: str, scene: str
) -> None:
    with pytest.raises(nc.InputError, match=r"no pearl|cannot be followed"):
        measure(of_word(word, pearl, scene))


def test_a_shadow_at_a_pearls_foot_does_not_bend_its_outline() -> None:
    found = measure(of_word("near-round", "tahitian", "booth"))
    assert found.roundness.value == pytest.approx(2.3, abs=1)


def test_a_circle_about_no_pearl_is_refused() -> None:
    both = np.concatenate([ellipse()] * 2, axis=1)
    with pytest.raises(
        nc.InputError, match=r"cannot be followed: .* in [0-3]?[0-9] % of all directions"
    ):
        measure(both, circle=(SIDE, SIDE / 2, 60.0))


def test_a_flat_ring_is_no_pearl() -> None:
    x, y = places()
    away = np.hypot(x - MIDDLE[0], y - MIDDLE[1])
    ring = binned(
        np.where(((away < RADIUS) & (away > 0.7 * RADIUS))[..., None], [0.5] * 3, [0.05] * 3)
    )
    with pytest.raises(nc.InputError, match=r"no pearl: within the outline .* as in a ring"):
        measure(ring)


@pytest.mark.parametrize("pearl", ["akoya-rg", "tahitian"])
def test_alpha_is_the_outline_of_what_is_cut_out(
    pearl: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    picture = nc.render(pearl, "booth", size=160, samples=4)
    picture.save(str(tmp_path / "cut.png"), alpha=True)
    assert main(["measure", str(tmp_path / "cut.png")]) == 0
    line = next(one for one in capsys.readouterr().out.splitlines() if one.startswith("diameter"))
    assert float(line.split()[1]) == pytest.approx(nc.Pearl.load(pearl).diameter_mm, rel=0.004)


def test_a_picture_with_nothing_opaque_has_no_pearl(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    codes = (255 * nc.colour.encode(np.clip(ellipse(), 0, 1))).astype(np.uint8)
    clear = np.concatenate([codes, np.zeros_like(codes[..., :1])], axis=-1)
    Image.fromarray(clear).save(tmp_path / "clear.png")
    assert main(["measure", str(tmp_path / "clear.png")]) == 2
    assert "no pearl" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("opacity", "said"),
    [
        (np.ones((3, 4)), r"opacity has the shape \(3, 4\); allowed: \(200, 200\), as the picture"),
        (np.full((SIDE, SIDE), 2.0), "opacity has numbers outside 0 to 1"),
    ],
)
def test_a_wrong_opacity_is_told(opacity: Light, said: str) -> None:
    with pytest.raises(nc.InputError, match=said):
        measure(ellipse(), opacity=opacity)
