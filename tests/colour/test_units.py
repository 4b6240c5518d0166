"""Numbers in another unit than the one that is wanted are refused by name."""

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from nacreous import colour
from nacreous.problem import InputError


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: colour.hvc_from_rgb([255, 0, 0]), "rgb[0] is 255; allowed: -10 to 10"),
        (lambda: colour.decode([[0.5, 0.5, 0.5], [12, 40, 7]]), "encoded[1][0] is 12; allowed"),
        (lambda: colour.hvc_from_xyz([41.2, 21.3, 1.9]), "xyz[0] is 41.2; allowed: -10 to 10"),
        (lambda: colour.munsell_notation([[0.1, 5, 5], [90, 5, 5]]), "hue of hvc[1] is 90"),
        (lambda: colour.rgb_from_hvc([270, 5, 5]), "hue of hvc is 270"),
        (lambda: colour.rgb_from_hvc([0.1, 62, 5]), "value of hvc is 62; allowed: up to 25 (10"),
        (lambda: colour.munsell_notation([[0.1, 62, 5]]), "value of hvc is 62"),
        (lambda: colour.xyz_from_hvc([270, 5, 5]), "hue of hvc is 270"),
        (lambda: colour.xyz_from_lab([255, 0, 0]), "lab[0] is 255; allowed: L* up to 234, of whic"),
        (lambda: colour.delta_e_2000([255, 0, 0], [0, 0, 255]), "first[0] is 255; allowed: L* up"),
        (lambda: colour.delta_e_2000([50, 0, 0], [[1, 2, 3], [240, 0, 0]]), "second[1][0] is 240"),
    ],
)
def test_codes_percentages_and_degrees_are_refused_where_one_is_white_and_hue_in_rad(
    call: Callable[[], object], said: str
) -> None:
    with pytest.raises(InputError) as refusal:
        call()
    assert str(refusal.value).startswith(said)


def test_lab_of_surfaces_up_to_ten_times_white_comes_back() -> None:
    xyz = np.full(3, 10.0)
    lab = colour.lab_from_xyz(xyz, white=[1, 1, 1])
    np.testing.assert_allclose(colour.xyz_from_lab(lab, white=[1, 1, 1]), xyz, rtol=1e-12)
    assert colour.delta_e_2000(lab, lab) == 0.0


LIGHT: tuple[Callable[[Any], Any], ...] = (
    colour.encode,
    colour.map_to_gamut,
    colour.out_of_gamut_share,
    colour.p3_from_srgb,
    colour.rgb_from_xyz,
    colour.srgb_from_p3,
    colour.xyz_from_rgb,
    lambda light: colour.adapt(light, colour.white_xyz("A"), colour.white_xyz("D65")),
)


@pytest.mark.parametrize("function", LIGHT)
@pytest.mark.parametrize(
    "codes",
    [
        [[0, 1, 0], [0, 0, 255]],
        [[95, 100, 108]] * 2,
        [[0, 0, -100]] * 2,
        np.full((2, 3), 65535, np.uint16),
        np.full((2, 3), 300, np.int32),
    ],
)
def test_whole_numbers_that_no_light_is_counted_in_are_refused(
    function: Callable[[Any], Any], codes: object
) -> None:
    with pytest.raises(InputError, match=r"\[[01]\]\[[0-2]\] is -?\d+, of type u?int\d+; allowed"):
        function(codes)


@pytest.mark.parametrize("function", LIGHT)
def test_light_hundreds_of_times_as_bright_as_white_is_taken(
    function: Callable[[Any], Any],
) -> None:
    """What a renderer's picture has where a pearl mirrors a lamp."""
    assert np.isfinite(function([[300.0, 255.0, 100.0]])).all()
    assert np.isfinite(function([[1, 0, 1]])).all()


def test_xyz_in_percent_are_taken_beside_a_white_in_percent() -> None:
    percent = colour.lab_from_xyz([41, 21, 2], white=[95, 100, 109])
    assert percent == pytest.approx(colour.lab_from_xyz([0.41, 0.21, 0.02], [0.95, 1.0, 1.09]))
    seen = colour.adapt([41, 21, 2], [95, 100, 109], [96, 100, 82])
    assert seen == pytest.approx(
        100 * colour.adapt([0.41, 0.21, 0.02], [0.95, 1, 1.09], [0.96, 1, 0.82])
    )


@pytest.mark.parametrize(
    "xyz", [[41.2, 21.3, 1.9], [[0.2, 0.2, 0.2], [9.0, 0.0, -19.5]], [95, 100, 108]]
)
def test_lab_is_of_surfaces_and_not_of_percentages_beside_a_white_of_1(xyz: list[float]) -> None:
    for white in (None, [0.95, 1.0, 1.09]):
        with pytest.raises(InputError, match=r"xyz\S* is -?\d+\S*( beside a white of 1|, of type)"):
            colour.lab_from_xyz(xyz, white)
    assert np.isfinite(colour.lab_from_xyz([9.0, 9.0, 9.0])).all()


def test_a_white_in_percent_beside_xyz_that_are_not_is_noticed() -> None:
    with pytest.warns(UserWarning, match="xyz is at most 0.41 beside a white of 109"):
        colour.lab_from_xyz([0.41, 0.21, 0.02], [95, 100, 109])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        colour.lab_from_xyz([[0.4, 0.4, 0.4], [41, 21, 2]], [95, 100, 109])
        colour.lab_from_xyz([0.001, 0.001, 0.001])
        colour.lab_from_xyz(np.zeros((0, 3)), [95, 100, 109])


@pytest.mark.parametrize(
    "code", ["#+f+f+f", "#f f f ", "#1_1_1_", "#１１１１１１", "red", 0xFF0000, None]
)
def test_a_colours_code_is_six_hexadecimal_digits_and_nothing_else(code: Any) -> None:
    with pytest.raises(InputError, match=r'colour is .*; allowed: "#rrggbb"'):
        colour.linear_from_hex(code)


@pytest.mark.parametrize(
    "function",
    [
        colour.decode,
        colour.encode,
        colour.hvc_from_rgb,
        colour.map_to_gamut,
        colour.p3_from_srgb,
        colour.xyz_from_rgb,
    ],
)
def test_bytes_of_a_picture_are_refused_even_where_light_may_be_brighter_than_white(
    function: Callable[[object], object],
) -> None:
    with pytest.raises(InputError, match="uint8, the codes 0 to 255 of a picture"):
        function(np.array([[1, 2, 3]], np.uint8))
    with pytest.raises(InputError, match="has masked values; allowed: numbers"):
        function(np.ma.array([0.5, 0.9, 0.1], mask=[False, True, False]))


def test_lab_is_relative_to_the_white_of_d65_unless_another_is_given() -> None:
    xyz = colour.white_xyz("D65")
    assert colour.lab_from_xyz(xyz).tolist() == [100.0, 0.0, 0.0]
    assert colour.xyz_from_lab([100.0, 0.0, 0.0]) == pytest.approx(xyz, abs=1e-15)
    # sRGB's white is D65 as IEC 61966-2-1 rounds it.
    assert colour.lab_from_xyz(colour.xyz_from_rgb([1, 1, 1])) == pytest.approx(
        [100, 0, 0], abs=0.04
    )
