"""Figure 9: spectra of the interference light at two points."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous import _core, colour, optics
from nacreous.figure import figure
from nacreous.nacre import stack_of
from nacreous.paper.exhibit import Exhibit, Plate, Quotation
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import LAMPS_DEG, Pictures
from nacreous.spec import Pearl

__all__ = ["exhibit", "measure", "spectra"]

Array = NDArray[np.float64]

FILES = ("figure-9.png",)
#: View angles of the lines of sight (a) and (b) of figure 5 **(ours)**: near the middle, near the rim.
VIEW_DEG = (10, 60)
#: Samples of the logarithmic scale of wavelength, and the largest shift looked for.
_LOG_STEPS = 2048
_MOST_SHIFT = 0.06


def spectra(pearl: Pearl) -> Array:
    """Interference light of a pearl, [view angle, wavelength]: 0 to 80 by 1 degree, 380 to 780 nm.

    White light of the same strength at all wavelengths has gone in.
    """
    loss = pearl.interference.diffuse_loss
    if loss is None:
        loss = _core.parameters(pearl.depth, pearl.shininess, pearl.grain)["diffuse_loss"]
    view_rad = np.radians(np.arange(81.0))
    how = pearl.interference
    return optics.illuminant(
        stack_of(pearl), view_rad, colour.WAVELENGTH_NM, how.coherence_nm, how.threshold, loss
    )


def measure(light: Array, index: float, changed: int) -> list[Measurement]:
    """What the paper's sentences ask of spectra by degree, and of layers under other lamps.

    index: of aragonite. changed: how many values differ between interference layers whose lamps stand
    in different places.
    """
    near, far = (light[angle] for angle in VIEW_DEG)
    shifts = fringe_shifts(light)
    cosine = [math.sqrt(1 - (math.sin(math.radians(angle)) / index) ** 2) for angle in VIEW_DEG]
    law = math.log(cosine[1] / cosine[0])
    unlike = float(np.sqrt(np.mean((far / far.mean() - near / near.mean()) ** 2)))
    away, lamps = f"from (a) to (b), {VIEW_DEG[0]}° to {VIEW_DEG[1]}°", len(LAMPS_DEG) + 1
    return [
        Measurement("contrast (max − min) / (max + min) at (a); flat light has 0", _contrast(near), least=0.2),
        Measurement("contrast at (b)", _contrast(far), least=0.2),
        Measurement("difference of (a) and (b), rms over mean", unlike, least=0.1),
        Measurement(f"change of the fringes' wavelengths {away}", 100 * math.expm1(shifts.sum()), "%", most=-5.0),
        Measurement("its largest step on the way: never to longer wavelengths", 100 * float(shifts.max()), "%", most=0.0),
        Measurement("the whole change over that of cos θ1 in equation (3)", float(shifts.sum() / law), least=0.9, most=1.1),
        Measurement(f"values that change in the interference component, {lamps} lamp directions", changed, most=0.0),
    ]


def fringe_shifts(light: Array) -> Array:
    """By how much the fringes move from (a) to (b) at each step of two degrees: d ln(wavelength).

    The phase of equation (3) holds cos(theta_1) / wavelength alone, so a change of angle moves all
    fringes by one factor: on a logarithmic scale they shift as a whole. Measured is the shift at which two
    spectra, their mean taken away, agree best (cross-correlation).
    """
    even = np.linspace(math.log(380.0), math.log(780.0), _LOG_STEPS)
    rows = light[VIEW_DEG[0] : VIEW_DEG[1] + 1 : 2]
    waves = np.stack([np.interp(even, np.log(colour.WAVELENGTH_NM), row / row.mean() - 1) for row in rows])
    spectra = np.fft.rfft(waves * np.hanning(_LOG_STEPS), 4 * _LOG_STEPS)
    agreement = np.fft.irfft(spectra[1:] * np.conj(spectra[:-1]))
    step = float(even[1] - even[0])
    lags = np.arange(-round(_MOST_SHIFT / step), round(_MOST_SHIFT / step) + 1)
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
    pearl = pictures.pearl
    light = spectra(pearl)
    path = folder / FILES[0]
    changed = changed_values([picture.layers["interference"] for picture in pictures.lamps])
    _draw(path, light)
    index = pearl.nacre.aragonite_index.real
    return Exhibit(
        "9",
        "干渉光のスペクトル強度例",
        "Spectral power distribution of an interference light.",
        [
            Quotation(
                "自然光（白色）のフラットなスペクトル分布が、干渉により変化している様子を示している。また、これらは"
                "図5における(a) (b)の視線方向に対応しており、視角によって異なるスペクトル分布が得られることがわかる。",
                "The flat spectrum of natural (white) light is seen to change by interference. The two "
                "curves belong to the lines of sight (a) and (b) of figure 5: different view angles "
                "give different spectra.",
                "3.2.4",
            ),
            Quotation(
                "すなわち干渉色は、視線方向にのみ依存し、光源方向には依存しない。",
                "Thus the interference colour depends on the direction of view alone, and not on that "
                "of the light source.",
                "3.1",
            ),
        ],
        [
            Plate(
                path,
                "Two spectra with fringes from 380 to 780 nm; the one at 60 degrees has its peaks "
                "at shorter wavelengths than the one at 10 degrees.",
            )
        ],
        measure(light, index, changed),
        "nacreous.optics.illuminant(stack, view_rad, wavelength_nm, coherence_nm=5000, threshold=0.05, diffuse_loss=D)",
        [
            f"View angles {VIEW_DEG[0]}° and {VIEW_DEG[1]}° stand for (a) and (b) (ours): figure 5 is "
            "not at hand.",
            "The model states no absolute scale; each curve is shown relative to its mean.",
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
