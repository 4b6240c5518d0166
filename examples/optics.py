"""How thick the layers are decides the colour: the middle of five even pearls, by Munsell."""

import numpy as np

import nacreous as nc

wavelength_nm = nc.colour.WAVELENGTH_NM
for thickness_nm in (330, 360, 400, 440, 480):
    stack = nc.LayerStack(np.full(300, float(thickness_nm)))
    spectra = nc.optics.illuminant(stack, [0.0, 0.9], wavelength_nm, diffuse_loss=0.03)
    xyz = nc.colour.xyz_from_spectrum(spectra, illuminant="D65")
    # The model is relative: bring the brighter of the two to a lightness that shows its hue.
    rgb = nc.colour.rgb_from_xyz(xyz * 0.3 / xyz[:, 1].max())
    middle, towards_rim = nc.colour.munsell_notation(nc.colour.hvc_from_rgb(rgb))
    print(f"layers of {thickness_nm} nm: middle {middle}, towards the rim {towards_rim}")
