"""Figure 8: angle of incidence and reflectance by view angle."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nacreous import optics
from nacreous.figure import figure
from nacreous.paper.exhibit import Exhibit, Plate, Quotation
from nacreous.paper.measurement import Measurement

__all__ = ["exhibit", "measure", "table"]

Array = NDArray[np.float64]

FILES = ("figure-8.png",)
#: Indices of aragonite and air in the paper (3.2.3).
_ARAGONITE, _AIR = 1.53, 1.0


def table() -> tuple[Array, Array, Array]:
    """View angle theta_0 in degrees, theta_1 in degrees by Snell's law, and R1 of equation (1)."""
    view_deg = np.linspace(0.0, 90.0, 181)
    # At 90 degrees rounding may leave the sine a hair above that of total reflection; R1 is 1 there.
    sine = np.minimum(np.sin(np.radians(view_deg)) * _AIR / _ARAGONITE, _AIR / _ARAGONITE)
    incidence_rad = np.arcsin(sine)
    reflectance = optics.fresnel(_ARAGONITE, _AIR, incidence_rad).R
    return view_deg, np.degrees(incidence_rad), reflectance


def measure(view_deg: Array, incidence_deg: Array, reflectance: Array) -> list[Measurement]:
    """What the paper's sentence asks of the table."""
    rising = float(min(np.diff(incidence_deg).min(), np.diff(reflectance).min()))
    return [
        Measurement("R1 at view angle 0", float(reflectance[0]), "", 0.04385, 0.04395),
        Measurement("θ1 at view angle 90°", float(incidence_deg[-1]), "deg", 40.75, 40.85),
        Measurement("R1 at view angle 90°", float(reflectance[-1]), "", 1 - 1e-6, 1 + 1e-6),
        Measurement("least rise of θ1 and R1 over half a degree", rising, "", 0.0),
        Measurement("R1 at view angle 60°", float(np.interp(60, view_deg, reflectance))),
    ]


def exhibit(folder: Path) -> Exhibit:
    """Draw the figure into `folder` and measure its table."""
    view_deg, incidence_deg, reflectance = table()
    path = folder / FILES[0]
    with figure(path, width_in=6.0, height_in=3.8) as axes:
        axes.plot(view_deg, incidence_deg, color="#335c81")
        axes.set(xlim=(0, 90), ylim=(0, 45), xticks=range(0, 91, 15))
        axes.set_xlabel("view angle θ0, degrees")
        axes.set_ylabel("angle of incidence θ1, degrees", color="#335c81")
        right = axes.twinx()
        right.plot(view_deg, reflectance, color="#a4493d")
        right.set(ylim=(0, 1.0))
        right.set_ylabel("reflectance R1", color="#a4493d")
        right.grid(visible=False)
    return Exhibit(
        "8",
        "視角に対する入射角と反射率の関係",
        "Angle of incidence and reflectance by view angle.",
        [
            Quotation(
                "視角とともに反射率も大きくなっており、真珠の周辺部へいくほど干渉色の透過率すなわち強度が"
                "小さくなる様子を表している。",
                "Reflectance grows with the view angle: towards the rim of the pearl the interference "
                "colours are transmitted less, that is, they become weaker.",
                "3.2.3",
            )
        ],
        [
            Plate(
                path,
                "Two curves that rise from 0 to 90 degrees: the angle of incidence, flattening "
                "near 40.8 degrees, and the reflectance, low until 60 degrees and then steep up to 1.",
            )
        ],
        measure(view_deg, incidence_deg, reflectance),
        "nacreous.optics.fresnel(1.53, 1.0, theta_1).R, with sin(theta_1) = sin(theta_0) / 1.53",
        ["Aragonite 1.53 (its c-axis value), air 1.0, both as in the paper."],
    )
