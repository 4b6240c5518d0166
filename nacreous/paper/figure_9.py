"""Figure 9: spectra of the interference light at two points."""

from __future__ import annotations

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
    track_nm = follow_peak(light)
    first, last = track_nm[0], track_nm[-1]
    cosine = [np.sqrt(1 - (np.sin(np.radians(angle)) / index) ** 2) for angle in VIEW_DEG]
    steps = np.diff(track_nm)
    unlike = float(np.sqrt(np.mean((far / far.mean() - near / near.mean()) ** 2)))
    return [
        Measurement(
            "contrast (max − min) / (max + min) at (a); flat light has 0", _contrast(near), "", 0.2
        ),
        Measurement("contrast at (b)", _contrast(far), "", 0.2),
        Measurement("difference of (a) and (b), rms over mean", unlike, "", 0.1),
        Measurement(f"strongest peak at (a), {VIEW_DEG[0]}°", float(first), "nm"),
        Measurement(
            f"the same peak followed to (b), {VIEW_DEG[1]}°", float(last), "nm", None, first - 10
        ),
        Measurement(
            "its largest step to longer wavelengths on the way",
            float(max(steps.max(), 0.0)),
            "nm",
            None,
            0.0,
        ),
        Measurement(
            "its shift over that of cos θ1 in equation (3)",
            float(last / first / (cosine[1] / cosine[0])),
            "",
            0.95,
            1.05,
        ),
        Measurement(
            f"values that change in the interference picture under {len(LAMPS_DEG) + 1} lamp directions",
            float(changed),
            "",
            None,
            0.0,
        ),
    ]


def follow_peak(light: Array) -> Array:
    """Wavelength in nm of the strongest peak at (a), followed by degrees to (b)."""
    first, last = VIEW_DEG
    peaks = _peaks(light[first])
    if not peaks.size:
        return np.full(last - first + 1, np.nan)
    track = [peaks[light[first, peaks].argmax()]]
    for angle in range(first + 1, last + 1):
        peaks = _peaks(light[angle])
        if not peaks.size:
            return np.full(last - first + 1, np.nan)
        track.append(peaks[np.abs(peaks - track[-1]).argmin()])
    return np.asarray(colour.WAVELENGTH_NM[track])


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


def _peaks(spectrum: Array) -> NDArray[np.intp]:
    """Where a spectrum has its local maxima."""
    middle = spectrum[1:-1]
    return np.flatnonzero((middle > spectrum[:-2]) & (middle >= spectrum[2:])) + 1
