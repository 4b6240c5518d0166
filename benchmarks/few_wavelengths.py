"""What one wavelength costs beside 32, at many angles.

    OPENBLAS_NUM_THREADS=1 RAYON_NUM_THREADS=1 python benchmarks/few_wavelengths.py

Lanes run over 32 points of a table side by side. A table of one wavelength that filled one lane of
them would cost as much as one of 32, so blocks run on into the next angles. The least of some
calls, in microseconds, for every function of a table [angle, wavelength].
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable

import numpy as np

import nacreous as nc
from nacreous import optics

#: Wavelengths of a table.
FEW, BLOCK = 1, 32
PATIENCE_S = 1.0

ANGLE_RAD = np.linspace(0, 1.5, 900)
SHORT = nc.LayerStack([400.0] * 10)
LONG = nc.grow("akoya-rg", seed=1)
SELLMEIER = nc.LayerStack([400.0] * 10, aragonite=lambda nm: 1.53 + 5000 / nm**2)
PAPER = nc.grow("paper", seed=1)
DISPERSIVE = nc.LayerStack([400.0] * 10, aragonite="aragonite", protein="chitin")
ABSORBING = nc.LayerStack([400.0] * 10, protein=1.43 + 0.01j)

Job = Callable[[np.ndarray], object]

JOBS: dict[str, Job] = {
    "energies": lambda nm: optics.energies(SHORT, ANGLE_RAD, nm),
    "energies, single": lambda nm: optics.energies(SHORT, ANGLE_RAD, nm, precision="single"),
    "energies, absorbing": lambda nm: optics.energies(ABSORBING, ANGLE_RAD, nm),
    "energies, dispersive": lambda nm: optics.energies(DISPERSIVE, ANGLE_RAD, nm),
    "energies, akoya-rg": lambda nm: optics.energies(LONG, ANGLE_RAD, nm),
    "illuminant": lambda nm: optics.illuminant(SHORT, ANGLE_RAD, nm),
    "illuminant, dispersive": lambda nm: optics.illuminant(SELLMEIER, ANGLE_RAD, nm),
    "illuminant, paper": lambda nm: optics.illuminant(PAPER, ANGLE_RAD, nm),
    "ensemble, 4 columns": lambda nm: optics.ensemble([SHORT] * 4, ANGLE_RAD, nm),
    "ensemble, 4 columns, single": lambda nm: optics.ensemble(
        [SHORT] * 4, ANGLE_RAD, nm, precision="single"
    ),
    "amplitudes": lambda nm: optics.amplitudes(SHORT, ANGLE_RAD, nm),
    "depth_profile": lambda nm: optics.depth_profile(SHORT, [100.0, 900.0], ANGLE_RAD, nm),
    "on_plate": lambda nm: optics.on_plate(SHORT, 1.0, ANGLE_RAD, nm),
    "over_aperture, 50 angles": lambda nm: optics.over_aperture(
        SHORT, np.linspace(0, 1.4, 50), 0.1, nm
    ),
    "over_hemisphere": lambda nm: optics.over_hemisphere(SHORT, nm),
    "coherence, 50 angles": lambda nm: optics.energies(
        SHORT, np.linspace(0, 1.4, 50), nm, coherence_nm=6000.0
    ),
}


def microseconds(job: Job, wavelengths: int) -> float:
    """The least of what fits into the patience, at least three calls."""
    nm = np.linspace(400, 700, wavelengths) if wavelengths > 1 else np.array([550.0])
    least, calls, end = math.inf, 0, time.perf_counter() + PATIENCE_S
    while calls < 3 or time.perf_counter() < end:
        begin = time.perf_counter()
        job(nm)
        least = min(least, time.perf_counter() - begin)
        calls += 1
    return 1e6 * least


def main() -> None:
    print(f"| function | {FEW} wavelength | {BLOCK} wavelengths | share |\n|---|---|---|---|")
    for name, job in JOBS.items():
        few, block = microseconds(job, FEW), microseconds(job, BLOCK)
        print(f"| {name} | {few:,.0f} | {block:,.0f} | {few / block:.2f} |")


if __name__ == "__main__":
    main()
