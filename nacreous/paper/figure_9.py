"""Figure 9: spectra of the interference light at two points."""

from __future__ import annotations

import math
from pathlib import Path
from typing import cast

import numpy as np
from numpy.typing import NDArray

from nacreous import _core, colour, optics
from nacreous.figure import figure
from nacreous.nacre import stack_of
from nacreous.paper.exhibit import Exhibit, Plate
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import LAMPS_DEG, Pictures
from nacreous.spec import Pearl

__all__ = ["FILES", "VIEW_DEG", "changed_values", "exhibit", "fringe_shifts", "measure", "spectra"]

Array = NDArray[np.float64]

FILES = ("figure-9.png",)
#: View angles of the lines of sight (a) and (b) of figure 5 **(ours)**: middle and towards the rim.
VIEW_DEG = (10, 60)
#: Samples of the logarithmic scale of wavelength, and the largest shift looked for on it.
_LOG_STEPS = 2048
_MOST_SHIFT = 0.06


def spectra(pearl: Pearl) -> Array:
    """Interference light of a pearl, [view angle, wavelength]: 0 to 80 by 1 degree, 380 to 780 nm.

    White light of the same strength at all wavelengths has gone in.
    """
    how = pearl.interference
    loss = _core.resolved_keys(pearl.model_dump_json())["interference.diffuse_loss"]
    view_rad, wavelength_nm = np.radians(np.arange(81.0)), colour.WAVELENGTH_NM
    return optics.illuminant(
        stack_of(pearl), view_rad, wavelength_nm, how.coherence_nm, how.threshold, loss
    )


def measure(light: Array, index: float, changed: int) -> list[Measurement]:
    """What the paper's sentences ask of spectra by degree, and of layers under other lamps.

    index: of aragonite. changed: how many values differ between interference layers whose lamps
    stand in different places.
    """
    near, far = (light[angle] for angle in VIEW_DEG)
    unlike = float(np.sqrt(np.mean((far / far.mean() - near / near.mean()) ** 2)))
    shifts = fringe_shifts(light)
    whole, furthest = 100 * math.expm1(shifts.sum()), 100 * float(shifts.max())
    cosine = [math.sqrt(1 - (math.sin(math.radians(angle)) / index) ** 2) for angle in VIEW_DEG]
    over_law = float(shifts.sum() / math.log(cosine[1] / cosine[0]))
    fringes = "(max − min) / (max + min)"
    lamps = len(LAMPS_DEG) + 1
    return [
        Measurement(f"contrast {fringes} at (a); flat light has 0", _contrast(near), least=0.2),
        Measurement("contrast at (b)", _contrast(far), least=0.2),
        Measurement("difference of (a) and (b), rms over mean", unlike, least=0.1),
        Measurement("change of the fringes' wavelengths from (a) to (b)", whole, "%", most=-5.0),
        Measurement("the same at any step of 2° on the way, the most", furthest, "%", most=0.0),
        Measurement("the change over that of cos θ1, equation (3)", over_law, least=0.9, most=1.1),
        Measurement(
            f"values that differ between {lamps} lamp directions", changed, least=0, most=0
        ),
    ]


def fringe_shifts(light: Array) -> Array:
    """By how much the fringes move from (a) to (b), d ln(wavelength) for each step of 2 degrees.

    The phase of equation (3) holds cos(theta_1) / wavelength, so a change of angle moves all
    fringes by one factor: on a logarithmic scale they shift as a whole. Measured is the shift at
    which two spectra, their means taken away, agree best (cross-correlation).
    """
    even = np.linspace(math.log(380.0), math.log(780.0), _LOG_STEPS)
    rows = light[VIEW_DEG[0] : VIEW_DEG[1] + 1 : 2]
    log_nm = np.log(colour.WAVELENGTH_NM)
    fringes = np.stack([np.interp(even, log_nm, row / row.mean() - 1) for row in rows])
    waves = np.fft.rfft(fringes * np.hanning(_LOG_STEPS), 4 * _LOG_STEPS)
    agreement = np.fft.irfft(waves[1:] * np.conj(waves[:-1]))
    step = float(even[1] - even[0])
    most = round(_MOST_SHIFT / step)
    lags = np.arange(-most, most + 1)
    return np.array([step * _top(lags, row[lags]) for row in agreement])


def _top(lags: NDArray[np.intp], agreement: Array) -> float:
    """The lag of best agreement, between the steps by a parabola through the best three."""
    best = int(np.clip(agreement.argmax(), 1, len(lags) - 2))
    left, middle, right = agreement[best - 1 : best + 2]
    bend = left - 2 * middle + right
    return float(lags[best] + (0.5 * (left - right) / bend if bend < 0 else 0.0))


def changed_values(layers: list[NDArray[np.float32]]) -> int:
    """How many values of any layer differ, in a single bit, from the first."""
    first = layers[0].tobytes()
    if all(layer.tobytes() == first for layer in layers):
        return 0
    bits = [layer.view(np.uint32) for layer in layers]
    return int(sum(np.count_nonzero(other != bits[0]) for other in bits[1:]))


def exhibit(folder: Path, pictures: Pictures) -> Exhibit:
    """Draw the figure into `folder` and measure its spectra."""
    pearl, path = pictures.pearl, folder / FILES[0]
    light = spectra(pearl)
    _draw(path, light)
    changed = changed_values([picture.layers["interference"] for picture in pictures.lamps])
    return Exhibit(
        "9",
        [Plate(path)],
        measure(light, cast("complex", pearl.nacre.aragonite_medium).real, changed),
        "nacreous.optics.illuminant(stack, view_rad, wavelength_nm, 5000, 0.05, D)",
        [
            f"View angles {VIEW_DEG[0]}° and {VIEW_DEG[1]}° stand for (a) and (b) (ours): figure 5 "
            "is not at hand. The model states no absolute scale: each curve is shown over its "
            "mean.",
            "Lamp directions are compared bit by bit in the interference component of rendered "
            "pictures.",
        ],
    )


def _draw(path: Path, light: Array) -> None:
    with figure(path, width_in=6.0, height_in=3.6) as axes:
        axes.axhline(1.0, color="#999999", linewidth=1, linestyle="--", label="flat light")
        for name, angle, tint in zip("ab", VIEW_DEG, ("#335c81", "#a4493d"), strict=True):
            row = light[angle]
            label = f"({name}) view angle {angle}°"
            axes.plot(colour.WAVELENGTH_NM, row / row.mean(), color=tint, label=label)
        axes.set(xlim=(380, 780), ylim=(0, None))
        axes.set_xlabel("wavelength, nm")
        axes.set_ylabel("spectral intensity over its mean")
        axes.legend(loc="upper right")


def _contrast(spectrum: Array) -> float:
    return float((spectrum.max() - spectrum.min()) / (spectrum.max() + spectrum.min()))
