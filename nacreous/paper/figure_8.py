"""Figure 8: angle of incidence and reflectance by view angle."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous import optics
from nacreous.figure import figure
from nacreous.paper.exhibit import Exhibit, Plate
from nacreous.paper.measurement import Measurement

__all__ = ["FILES", "exhibit", "measure", "table"]

Array = NDArray[np.float64]

FILES = ("figure-8.png",)
#: Indices of aragonite and air in the paper (3.2.3).
_ARAGONITE, _AIR = 1.53, 1.0


def table() -> tuple[Array, Array, Array]:
    """View angle theta_0 in degrees, theta_1 in degrees by Snell's law, R1 of equation (1)."""
    view_deg = np.linspace(0.0, 90.0, 181)
    # At 90 degrees rounding may carry the sine over the edge of total reflection.
    sine = np.minimum(np.sin(np.radians(view_deg)), 1.0) * _AIR / _ARAGONITE
    incidence_rad = np.arcsin(sine)
    return view_deg, np.degrees(incidence_rad), optics.fresnel(_ARAGONITE, _AIR, incidence_rad).R


def measure(view_deg: Array, incidence_deg: Array, reflectance: Array) -> list[Measurement]:
    """What the paper's sentence asks of the table."""
    rise = float(min(np.diff(incidence_deg).min(), np.diff(reflectance).min()))
    at_60 = float(np.interp(60.0, view_deg, reflectance))
    return [
        Measurement("R1 at view angle 0°", float(reflectance[0]), least=0.04385, most=0.04395),
        Measurement("θ1 at view angle 90°", float(incidence_deg[-1]), "°", least=40.75, most=40.85),
        Measurement("R1 at view angle 90°", float(reflectance[-1]), least=0.999999, most=1.000001),
        Measurement("least rise of θ1 and of R1 over half a degree", rise, least=0.0),
        Measurement("R1 at view angle 60°", at_60),
    ]


def exhibit(folder: Path) -> Exhibit:
    """Draw the figure into `folder` and measure its table."""
    columns = table()
    path = folder / FILES[0]
    _draw(path, *columns)
    return Exhibit(
        "8",
        [Plate(path)],
        measure(*columns),
        "nacreous.optics.fresnel(1.53, 1.0, theta_1).R",
        ["Aragonite 1.53 (its c-axis value), air 1.0, both as in the paper; sin θ0 = 1.53 sin θ1."],
    )


def _draw(path: Path, view_deg: Array, incidence_deg: Array, reflectance: Array) -> None:
    with figure(path, width_in=6.0, height_in=3.8) as axes:
        axes.plot(view_deg, incidence_deg, color="#335c81")
        axes.set(xlim=(0, 90), ylim=(0, 50), xticks=range(0, 91, 15))
        axes.set_xlabel("view angle θ0, degrees")
        axes.set_ylabel("angle of incidence θ1, degrees", color="#335c81")
        right = axes.twinx()
        right.plot(view_deg, reflectance, color="#a4493d")
        right.set(ylim=(0, 1.0))
        right.set_ylabel("reflectance R1", color="#a4493d")
        right.grid(visible=False)
        right.spines["right"].set_visible(True)
