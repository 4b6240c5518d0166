"""Other packages that compute stacks of layers, asked the same question.

Each takes (indices, thicknesses in nm) from the ambient to the substrate, angles in rad and
wavelengths in nm, makes its arrays, and gives back the work to be timed, which says the mean
reflectance of natural light. Imports are inside: each package has an environment of its own.
"""

from __future__ import annotations

import math
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

Stack = tuple[list[float], list[float]]
Work = Callable[[], float]


def cuda_thinfilm(stack: Stack, angle_rad: list[float], wavelength_nm: list[float]) -> Work:
    import numpy as np
    from cuda_thinfilm import ThinFilmStack

    n, d = stack

    def one(angle: float) -> float:
        film = ThinFilmStack(
            wavelengths=np.array(wavelength_nm),
            incident_medium=n[0],
            substrate=n[-1],
            angle_deg=math.degrees(angle),
            polarization="unpolarized",
            backend="cpu",
        )
        for index, nm in zip(n[1:-1], d[1:-1], strict=True):
            film.add_layer(index, thickness_nm=nm)
        return float(film.calculate()[0].mean()) / 100

    return lambda: sum(map(one, angle_rad)) / len(angle_rad)


def tmm_faster(stack: Stack, angle_rad: list[float], wavelength_nm: list[float]) -> Work:
    import numpy as np
    import tmm_faster as package

    table = np.tile(np.array(stack[0], complex), (len(wavelength_nm), 1))
    d, degrees, nm = np.array(stack[1]), np.degrees(angle_rad), np.array(wavelength_nm)
    return lambda: float(package.calc_coherent(table, d, degrees, nm)["R_avg"].mean())


def tmm_fast(stack: Stack, angle_rad: list[float], wavelength_nm: list[float]) -> Work:
    import numpy as np
    import tmm_fast as package

    table = np.tile(np.array(stack[0], complex)[None, :, None], (1, 1, len(wavelength_nm)))
    d, angle, nm = np.array([stack[1]]), np.array(angle_rad), np.array(wavelength_nm)

    def both() -> float:
        R = [package.coh_tmm(plane, table, d, angle, nm)["R"] for plane in "sp"]
        return float(np.mean([np.asarray(part).mean() for part in R]))

    return both


def pymoosh(stack: Stack, angle_rad: list[float], wavelength_nm: list[float]) -> Work:
    import numpy as np
    from PyMoosh.classes import Structure
    from PyMoosh.vectorized import spectrum_A

    n, d = stack
    indices = sorted(set(n))
    types = [indices.index(each) for each in n]
    structure = Structure([each**2 for each in indices], types, [0, *d[1:-1], 0], verbose=False)
    nm = wavelength_nm

    def all_angles() -> float:
        R = [
            np.mean(spectrum_A(structure, angle, plane, nm[0], nm[-1], len(nm))[3])
            for angle in angle_rad
            for plane in (0, 1)
        ]
        return float(np.mean(R))

    return all_angles


def tmm(stack: Stack, angle_rad: list[float], wavelength_nm: list[float]) -> Work:
    import tmm as package

    n, d = stack

    def all_points() -> float:
        R = [
            package.coh_tmm(plane, n, d, angle, nm)["R"]
            for angle in angle_rad
            for nm in wavelength_nm
            for plane in "sp"
        ]
        return float(sum(R) / len(R))

    return all_points


#: By their names in the package index.
PEERS: dict[str, Callable[[Stack, list[float], list[float]], Work]] = {
    "cuda-thinfilm": cuda_thinfilm,
    "tmm_faster": tmm_faster,
    "tmm_fast": tmm_fast,
    "PyMoosh": pymoosh,
    "tmm": tmm,
}


def install(name: str, folder: str) -> Path | None:
    """The Python of an environment in `folder` that has the package, or nothing."""
    python = Path(folder, "bin", "python")
    if not python.exists():
        subprocess.run([sys.executable, "-m", "venv", folder], check=True)
    command = [python, "-m", "pip", "install", "--quiet", name, "numpy", "scipy"]
    done = subprocess.run(command, stdout=subprocess.DEVNULL)
    return python if done.returncode == 0 else None
