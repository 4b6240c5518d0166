"""What light does in nacre: Fresnel's equations, exact stacks, the illuminant model of 1996.

Conventions: waves run as exp(i(kx - wt)), so n + ik with k > 0 absorbs; angles in rad from the
normal; tables are [angle, wavelength].
"""

from nacreous.optics.boundary import Fresnel, fresnel
from nacreous.optics.columns import Ensemble, ensemble
from nacreous.optics.interference import illuminant
from nacreous.optics.transfer import Energies, absorptance, energies, reflectance, transmittance

__all__ = [
    "Energies",
    "Ensemble",
    "Fresnel",
    "absorptance",
    "energies",
    "ensemble",
    "fresnel",
    "illuminant",
    "reflectance",
    "transmittance",
]
