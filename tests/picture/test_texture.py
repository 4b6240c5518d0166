"""Laws of the grain: spectrum in, the same spectrum out, and nothing to see of poles and seams."""

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy import stats
from scipy.special import sph_harm_y

from nacreous import _core
from nacreous.colour import rgb_from_hvc
from nacreous.problem import InputError
from nacreous.texture import GrainSpectrum, Texture, analyse, synthesise

Array = NDArray[np.float64]

CORRELATION = [[1.0, 0.0, 0.3], [0.0, 1.0, -0.6], [0.3, -0.6, 1.0]]
SMALL = GrainSpectrum(
    np.array([0.5, 1.0, 2.0, 3.8]),
    np.array([[0.0, 0.004, 0.002, 0.0], [0.0, 0.01, 0.01, 0.0], [0.0, 0.0, 0.01, 0.0]]),
    np.array(CORRELATION),
)
"""On a sphere of radius 1 mm: degrees 3 to 23."""


def angles(rows: int) -> tuple[Array, Array]:
    theta = (np.arange(rows) + 0.5) * np.pi / rows
    return theta[:, None], (np.arange(2 * rows) * np.pi / rows)[None, :]


def solid_angles(rows: int) -> Array:
    """Fejér's weights: integrals over the sphere, exact for any band limit below `rows`."""
    theta, _ = angles(rows)
    j = np.arange(1, rows // 2 + 1)
    end = np.where(2 * j == rows, 0.5, 1.0)
    ring = 2 / rows * (1 - 2 * np.sum(end * np.cos(2 * j * theta) / (4 * j**2 - 1), axis=1))
    return np.repeat(ring[:, None], 2 * rows, axis=1) * np.pi / rows


def expected_c(spectrum: GrainSpectrum, radius_mm: float, top: int) -> Array:
    """C_l [channel, l]: the power between l and l + 1 cycles round the pearl, integrated finely."""
    c = np.zeros((3, top + 1))
    for degree in range(1, top + 1):
        f = np.linspace(degree, degree + 1, 4001) / (2 * np.pi * radius_mm)
        for channel in range(3):
            s = np.interp(f, spectrum.cycles_per_mm, spectrum.density[channel], left=0, right=0)
            c[channel, degree] = np.trapezoid(s, f) * 4 * np.pi / (2 * degree + 1)
    return c


def harmonic_coefficients(fields: Array, top: int) -> NDArray[np.complex128]:
    """a_lm [field, channel, l, m >= 0] by integration against scipy's harmonics."""
    rows = fields.shape[1]
    theta, phi = angles(rows)
    weighted = fields * solid_angles(rows)[..., None]
    a = np.zeros((len(fields), 3, top + 1, top + 1), complex)
    for degree in range(top + 1):
        for m in range(degree + 1):
            harmonic = sph_harm_y(degree, m, theta, phi).conj()
            a[:, :, degree, m] = np.tensordot(weighted, harmonic, ((1, 2), (0, 1)))
    return a


def directions(theta: Array, phi: Array) -> Array:
    theta, phi = np.broadcast_arrays(theta, phi)
    xyz = np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)
    return np.stack(xyz, axis=-1).reshape(-1, 3)


@pytest.mark.parametrize(("top", "rows"), [(1, 4), (11, 24), (20, 32)])
def test_harmonics_sum_to_what_scipy_sums(top: int, rows: int) -> None:
    random = np.random.default_rng(5)
    a = random.normal(size=(3, top + 1, top + 1)) + 1j * random.normal(size=(3, top + 1, top + 1))
    a[:, :, 0] = a[:, :, 0].real
    expected = np.zeros((rows, 2 * rows, 3))
    theta, phi = angles(rows)
    for degree in range(top + 1):
        for m in range(degree + 1):
            wave = sph_harm_y(degree, m, theta, phi)[..., None] * a[:, degree, m]
            expected += wave.real * (2 if m else 1)
    np.testing.assert_allclose(_core.synthesise_harmonics(a, rows), expected, atol=1e-10)


def test_mean_over_the_sphere_is_zero() -> None:
    grid = synthesise(GrainSpectrum.procedural(), 4.0, seed=3).grid()
    mean = np.einsum("rc,rck->k", solid_angles(len(grid)), grid) / (4 * np.pi)
    assert np.abs(mean).max() < 1e-8


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_variance_is_the_integral_of_the_spectrum_within_sampling_error(seed: int) -> None:
    spectrum = GrainSpectrum.procedural()
    texture = synthesise(spectrum, 4.0, seed)
    grid = texture.grid().astype(float)
    variance = np.einsum("rc,rck->k", solid_angles(len(grid)), grid**2) / (4 * np.pi)
    c = expected_c(spectrum, 4.0, texture.band_limit)
    degrees = 2 * np.arange(texture.band_limit + 1) + 1
    error = np.sqrt(np.sum(2 * degrees * c**2, axis=1)) / (4 * np.pi)
    assert texture.lost_variance == pytest.approx([0, 0, 0], abs=1e-9)
    assert np.all(np.abs(variance - spectrum.variance) < 3.5 * error)
    assert np.all(error < 0.01 * spectrum.variance)


def test_power_of_each_degree_and_correlation_come_back() -> None:
    top, seeds = 23, 8
    grids = np.stack([synthesise(SMALL, 1.0, seed).grid() for seed in range(seeds)])
    a = harmonic_coefficients(grids.astype(float), top)
    weight = np.where(np.arange(top + 1) == 0, 1, 2)
    powers = np.einsum("sclm,m->cl", np.abs(a) ** 2, weight)
    c = expected_c(SMALL, 1.0, top)
    # Degrees 7 to 11 lie where all three densities are positive: whitened, then correlated.
    white = a[:, :, 7:12] / np.sqrt(c[:, 7:12, None])
    products = np.einsum("silm,sjlm,m->ij", white, white.conj(), weight).real
    freedom = seeds * (2 * np.arange(top + 1) + 1)
    seen = c > 1e-6
    assert np.abs(powers[~seen]).max() < 1e-4 * powers.max()
    probability = stats.chi2.cdf(powers[seen] / c[seen], np.broadcast_to(freedom, c.shape)[seen])
    assert stats.kstest(probability, "uniform").pvalue > 0.001
    assert np.all((probability > 1e-4) & (probability < 1 - 1e-4))
    # Sampling error of a correlation over n values: (1 - r^2) / sqrt(n).
    correlation = products / freedom[7:12].sum()
    assert np.abs(correlation - CORRELATION).max() < 4 / np.sqrt(freedom[7:12].sum())


def test_differences_across_the_date_line_are_like_those_elsewhere() -> None:
    line, elsewhere = [], []
    for seed in range(150):
        grid = synthesise(SMALL, 1.0, seed).grid()
        squared = (np.roll(grid, -1, axis=1) - grid) ** 2
        mean = squared[len(grid) // 4 : -len(grid) // 4].mean(axis=0)
        half = len(grid)
        line.append(mean[[half - 1, -1]].mean(axis=0))  # at longitudes 180 and 0
        elsewhere.append(mean[[half // 2, half // 4, -half // 2, -half // 4]].mean(axis=0))
    assert np.all(stats.ttest_rel(line, elsewhere).pvalue > 0.001)


@pytest.mark.parametrize("statistic", ["variance", "differences"])
def test_a_cap_at_the_pole_is_like_a_cap_at_the_equator(statistic: str) -> None:
    ring, around = np.meshgrid(np.linspace(0.005, 0.3, 12), np.arange(24) * np.pi / 12)
    pole = directions(ring, around)
    caps = {
        "pole": pole,
        "south": -pole,
        "equator": pole[:, [2, 0, 1]],
        "date": -pole[:, [2, 0, 1]],
    }
    seen: dict[str, list[Array]] = {name: [] for name in caps}
    for seed in range(150):
        texture = synthesise(SMALL, 1.0, seed)
        for name, cap in caps.items():
            values = texture.at(np.ascontiguousarray(cap), 0.0).reshape(24, 12, 3)
            if statistic == "differences":
                values = np.roll(values, 1, axis=0) - values
            seen[name].append((values**2).mean(axis=(0, 1)))
    assert np.all(stats.ttest_rel(seen["pole"], seen["equator"]).pvalue > 0.001)
    assert np.all(stats.ttest_rel(seen["south"], seen["date"]).pvalue > 0.001)


def test_look_up_keeps_the_variance_everywhere() -> None:
    texture = synthesise(GrainSpectrum.procedural(), 4.0, seed=1)
    z = np.random.default_rng(0).normal(size=(200_000, 3))
    looked_up = texture.at(z, 0.0).var(axis=0)
    assert looked_up == pytest.approx(GrainSpectrum.procedural().variance, rel=0.02)


def test_far_samples_see_the_low_degrees_exactly() -> None:
    f = SMALL.cycles_per_mm
    cut = 12 / (2 * np.pi)  # degrees up to 11, the lower half of 23
    fine = np.unique([*f, cut, np.nextafter(cut, 9)])
    density = np.stack([np.where(fine <= cut, np.interp(fine, f, d), 0) for d in SMALL.density])
    low = synthesise(GrainSpectrum(fine, density, SMALL.correlation), 1.0, seed=4)
    whole = synthesise(SMALL, 1.0, seed=4)
    towards = np.random.default_rng(1).normal(size=(500, 3))
    seen, expected = whole.at(towards, np.pi / 11), low.at(towards, 0.0)
    assert np.abs(seen - expected).max() < 0.03 * expected.std()
    assert np.abs(whole.at(towards, 1e9)).max() < 1e-6


def test_same_seed_same_bytes_and_other_seed_another_texture() -> None:
    first, again, other = (synthesise(SMALL, 1.0, seed).grid() for seed in (7, 7, 8))
    assert first.tobytes() == again.tobytes()
    assert abs(np.corrcoef(first[..., 1].ravel(), other[..., 1].ravel())[0, 1]) < 0.2


def test_what_lies_above_degree_512_is_reported_as_lost() -> None:
    wide = GrainSpectrum(np.array([10.0, 20.0, 60.0]), np.array([[0.0, 0.01, 0.0]] * 3))
    texture = synthesise(wide, 4.0)
    assert texture.band_limit == 512
    f = np.linspace(513 / (8 * np.pi), 60, 20001)
    lost = np.trapezoid(np.interp(f, wide.cycles_per_mm, wide.density[0]), f)
    assert texture.lost_variance == pytest.approx([lost] * 3, rel=1e-6)


# From a photograph to its spectrum


def photograph(hue: Array | float, value: Array | float, chroma: Array | float) -> Array:
    return rgb_from_hvc(np.stack(np.broadcast_arrays(hue, value, chroma), axis=-1))


def noise(seed: int, side: int = 64) -> Array:
    return np.random.default_rng(seed).normal(size=(side, side))


def test_flat_photograph_has_no_texture() -> None:
    shade = np.linspace(0.5, 0.6, 64)
    for flat in (np.full((64, 64, 3), [0.7, 0.6, 0.55]), np.ones((64, 64, 3)) * 0.4):
        assert np.abs(analyse(flat).textures).max() < 1e-12
    shaded = shade[:, None, None] ** 3 * np.full((64, 64, 3), [1.0, 1.0, 1.0])
    assert analyse(shaded).spectrum.variance[1] < 1e-7  # a slope of lightness is shading


@pytest.mark.parametrize(("across", "down"), [(9, 0), (0, 12), (8, 6), (-5, 12)])
@pytest.mark.parametrize("channel", [0, 1, 2])
def test_grating_shows_at_its_frequency_with_its_variance(
    channel: int, across: int, down: int
) -> None:
    step = np.arange(64) / 64
    wave = np.cos(2 * np.pi * (across * step + down * step[:, None]) + 0.3)
    hvc = [0.8 + 0.05 * wave, 7 * (1 + 0.01 * wave), 3 * (1 + 0.05 * wave)]
    flat = [np.full((64, 64), x) for x in (0.8, 7.0, 3.0)]
    flat[channel] = hvc[channel]
    spectrum = analyse(photograph(*flat), mm_per_pixel=0.05).spectrum
    frequency = np.hypot(across, down) / (64 * 0.05)
    amplitude = [0.05, 0.01, 0.05][channel]
    density = spectrum.density[channel]
    peak = spectrum.cycles_per_mm[density.argmax()]
    assert peak == pytest.approx(frequency, abs=0.51 / (64 * 0.05))
    assert spectrum.variance[channel] == pytest.approx(amplitude**2 / 2, rel=0.02)
    assert np.delete(spectrum.variance, channel).max() < 1e-3 * amplitude**2


def test_variance_is_the_integral_of_the_density_by_parseval() -> None:
    rgb = photograph(0.3 + 0.1 * noise(1), 6 + 0.2 * noise(2), 2 + 0.1 * noise(3))
    found = analyse(rgb, mm_per_pixel=0.02, low=3.0, high=20.0)
    power = (found.textures**2).mean(axis=(0, 1, 2))
    assert found.spectrum.variance == pytest.approx(power, rel=1e-12)
    assert np.abs(found.textures.mean(axis=(1, 2))).max() < 1e-15


def test_band_pass_keeps_white_noise_by_the_area_of_its_ring() -> None:
    variance = np.mean(
        [
            analyse(photograph(0.5, 6 + 0.06 * noise(seed), 2.0), low=8, high=24).spectrum.variance
            for seed in range(40)
        ],
        axis=0,
    )
    ring = np.pi * (24**2 - 8**2) / 64**2
    assert variance[1] == pytest.approx(0.01**2 * ring, rel=0.03)


def test_hue_that_straddles_pi_gives_the_same_texture_as_the_same_hue_turned() -> None:
    near_zero = photograph(0.2 * noise(4), 6 + 0.1 * noise(5), 2 + 0.1 * noise(6))
    turned = photograph(np.pi + 0.2 * noise(4), 6 + 0.1 * noise(5), 2 + 0.1 * noise(6))
    one, other = analyse(near_zero), analyse(turned)
    np.testing.assert_allclose(one.textures, other.textures, atol=1e-8)
    assert one.spectrum.variance[0] > 0.001


def test_hue_of_a_grey_means_nothing() -> None:
    grey = photograph(np.pi * noise(7), 6.0, 1e-4)
    assert analyse(grey).spectrum.variance[0] < 1e-4


def test_one_cause_of_value_and_chroma_is_seen_as_correlation() -> None:
    # More light on one colour: V + 1.6 and C grow together, H stays (MTM is a cube root).
    light = np.exp(0.05 * noise(8))[..., None] * [0.5, 0.4, 0.35]
    spectrum = analyse(light).spectrum
    assert spectrum.correlation[1, 2] == pytest.approx(1, abs=2e-3)
    assert spectrum.variance[0] < 1e-6 * spectrum.variance[1]


def test_photograph_of_a_synthetic_pearl_gives_its_spectrum_back() -> None:
    """Full loop: spectrum, texture, photograph of its middle, analysis, spectrum."""
    true = GrainSpectrum.procedural()
    radius_mm, mm_per_pixel, side = 4.0, 0.02, 64
    offset = (np.arange(side) - side / 2) * mm_per_pixel / radius_mm
    x, y = np.meshgrid(offset, offset)
    middle = np.stack([x, y, np.sqrt(1 - x**2 - y**2)], axis=-1).reshape(-1, 3)
    found = []
    for seed in range(10):
        texture = synthesise(true, radius_mm, seed)
        for towards in (middle, middle[:, [2, 0, 1]], middle[:, [1, 2, 0]], -middle):
            grain = texture.at(np.ascontiguousarray(towards), 0.0).reshape(side, side, 3) / 2
            rgb = photograph(0.5 + grain[..., 0], 6 * (1 + grain[..., 1]), 3 * (1 + grain[..., 2]))
            found.append(analyse(rgb, mm_per_pixel=mm_per_pixel, low=1.6, high=13).spectrum)
    density = np.mean([4 * spectrum.density for spectrum in found], axis=0)
    variance = np.mean([4 * spectrum.variance for spectrum in found], axis=0)
    assert variance == pytest.approx(true.variance, rel=0.05)
    f = found[0].cycles_per_mm
    inside = (f > 3.5) & (f < 8)  # below, the window (0.8 cycles per mm wide) blurs the peak
    expected = np.stack([np.interp(f[inside], true.cycles_per_mm, d) for d in true.density])
    assert density[:, inside] == pytest.approx(expected, rel=0.2)
    correlation = np.mean([spectrum.correlation for spectrum in found], axis=0)
    assert np.abs(correlation - true.correlation).max() < 0.05


def test_patches_lie_inside_the_pearl_and_off_its_highlight() -> None:
    row, column = np.mgrid[:500, :600]
    distance = np.hypot(row - 240, column - 330)
    picture = np.where((distance < 200)[..., None], [0.5, 0.45, 0.4], [0.02, 0.03, 0.05])
    picture[np.hypot(row - 200, column - 300) < 20] = 1.0
    found = analyse(picture).corners
    assert len(found) >= 5
    for top, left in found:
        assert distance[top : top + 64, left : left + 64].max() < 200
        assert picture[top : top + 64, left : left + 64].max() < 1
    assert analyse(picture[200:300, 300:420]).corners == ((18, 28),)


# What is refused, each in one line


PLAIN = np.full((80, 80, 3), 0.5)
NAN = np.where(np.arange(80)[:, None, None] == 3, np.nan, PLAIN)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"photograph": PLAIN, "side_px": 81}, "80 x 80 pixels; allowed: at least side_px = 81"),
        ({"photograph": PLAIN, "side_px": 7}, "side_px is 7; allowed: a whole number, 8 to 1024"),
        ({"photograph": NAN}, r"not a number at \(3, 0, 0\)"),
        ({"photograph": PLAIN[..., 0]}, r"allowed: numbers \[row, column, 3\]"),
        ({"photograph": PLAIN.astype(str)}, r"allowed: numbers \[row, column, 3\]"),
        ({"photograph": PLAIN, "low": 5, "high": 5}, "band is 5 to 5 cycles per patch"),
        ({"photograph": PLAIN, "high": 33}, "band is 2 to 33 .*<= 32"),
        ({"photograph": PLAIN, "low": float("nan")}, "band is NaN"),
        ({"photograph": PLAIN, "low": -1.0}, "band is -1"),
        ({"photograph": PLAIN, "mm_per_pixel": 0.1, "high": 6}, "cycles per mm; .*<= 5"),
        ({"photograph": PLAIN, "mm_per_pixel": 0.0}, "mm_per_pixel is 0; allowed: greater than 0"),
        ({"photograph": PLAIN, "mm_per_pixel": float("nan")}, "mm_per_pixel is NaN"),
        ({"photograph": PLAIN, "corners": [(17, 0)]}, r"corner \(17, 0\) .* to \(16, 16\)"),
        ({"photograph": PLAIN, "corners": [(0, 0), (0, -1)]}, r"corner \(0, -1\) puts"),
        ({"photograph": PLAIN, "corners": [(10**30, 0)]}, "corner's row or column is 10"),
        ({"photograph": PLAIN, "corners": [(0, 0.5)]}, "corner's row or column is 0.5; allowed: a"),
        ({"photograph": PLAIN * 510}, r"is 255 at \(8, 8, 0\); allowed: -10 to 10 \(1 is white"),
        ({"photograph": PLAIN, "mm_per_pixel": 1e-6}, "cycles_per_mm.*allowed: 0 to 10000"),
        ({"photograph": PLAIN, "corners": []}, "corners is empty"),
        ({"photograph": np.tile(PLAIN, (3, 3, 1))}, "no patch of 64 px"),
    ],
)
def test_analysis_refuses_with_one_line(arguments: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message) as caught:
        analyse(**arguments)  # type: ignore[arg-type]
    assert "\n" not in str(caught.value)


RAMP, ONES = np.array([1.0, 2.0, 3.0]), np.ones((3, 3))


@pytest.mark.parametrize(
    ("spectrum", "radius_mm", "seed", "message"),
    [
        (GrainSpectrum(RAMP, ONES), 0.0, 0, "radius_mm is 0; allowed: 0.1 to 100"),
        (GrainSpectrum(RAMP, ONES), np.nan, 0, "radius_mm is NaN"),
        (GrainSpectrum(RAMP, ONES), 4.0, -1, "seed is -1"),
        (GrainSpectrum(RAMP, -ONES), 4.0, 0, "density of hue at index 0 is -1"),
        (GrainSpectrum(RAMP, ONES * np.nan), 4.0, 0, "density of hue at index 0 is NaN"),
        (GrainSpectrum(RAMP[::-1], ONES), 4.0, 0, r"cycles_per_mm\[1\] is 2"),
        (GrainSpectrum(RAMP, ONES[:, :2]), 4.0, 0, "2 densities for 3 frequencies"),
        (GrainSpectrum(RAMP, ONES[:2]), 4.0, 0, "density has 2 rows"),
        (GrainSpectrum(RAMP, ONES[0]), 4.0, 0, r"allowed: \(k,\) and \(3, k\)"),
        (GrainSpectrum(RAMP[:1], ONES[:, :1]), 4.0, 0, "allowed: equally many, 2 to 4096"),
        (GrainSpectrum(RAMP, ONES, 2 * ONES), 4.0, 0, "correlation is"),
    ],
)
def test_synthesis_refuses_with_one_line(
    spectrum: GrainSpectrum, radius_mm: float, seed: int, message: str
) -> None:
    with pytest.raises(InputError, match=message) as caught:
        synthesise(spectrum, radius_mm, seed)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("directions", "footprint_rad", "message"),
    [
        ([[0.0, 0.0, 0.0]], 0.0, r"directions\[0\] is"),
        ([[0.0, 0.0, 1.0], [np.nan, 0.0, 1.0]], 0.0, r"directions\[1\] is"),
        ([[0.0, 1.0]], 0.0, "2 numbers; allowed: 3"),
        ([[0.0, 0.0, 1.0]], -1.0, "footprint_rad is -1"),
        ([[0.0, 0.0, 1.0]], np.nan, "footprint_rad is NaN"),
    ],
)
def test_look_up_refuses_with_one_line(
    directions: list[list[float]], footprint_rad: float, message: str
) -> None:
    texture: Texture = synthesise(SMALL, 1.0)
    with pytest.raises(InputError, match=message):
        texture.at(np.array(directions), footprint_rad)
