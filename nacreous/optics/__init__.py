"""What light does in nacre: Fresnel's equations, exact stacks, the illuminant model of 1996.

Conventions: waves run as exp(i(kx - wt)), so n + ik with k > 0 absorbs; angles in rad from the
normal; tables are [angle, wavelength].
"""

from nacreous.optics.amplitudes import Amplitudes, amplitudes
from nacreous.optics.averages import over_aperture, over_hemisphere
from nacreous.optics.boundary import Fresnel, fresnel
from nacreous.optics.columns import Ensemble, ensemble
from nacreous.optics.depth import DepthProfile, depth_profile
from nacreous.optics.interference import illuminant
from nacreous.optics.plate import on_plate
from nacreous.optics.transfer import Energies, absorptance, energies, reflectance, transmittance

__all__ = [
    "Amplitudes",
    "DepthProfile",
    "Energies",
    "Ensemble",
    "Fresnel",
    "absorptance",
    "amplitudes",
    "depth_profile",
    "energies",
    "ensemble",
    "fresnel",
    "illuminant",
    "on_plate",
    "over_aperture",
    "over_hemisphere",
    "reflectance",
    "transmittance",
]


def __dir__() -> list[str]:
    """The public names, for completion."""
    return __all__
