"""Depth across, shininess down: nine pearls on one sheet, `knobs.png`."""

import numpy as np

import nacreous as nc

SIZE = 128
STEPS = (0.1, 0.5, 0.9)

scene = nc.Scene.load("paper")
rows = []
for shininess in STEPS:
    pearls = [
        nc.Pearl.load("paper", [("depth", str(d)), ("shininess", str(shininess))]) for d in STEPS
    ]
    rows.append(np.hstack([nc.render(pearl, scene, SIZE).linear for pearl in pearls]))

sheet = nc.Image(np.vstack(rows), layers={})
outside = sheet.save("knobs.png")
print(f"knobs.png: depth {STEPS} across, shininess {STEPS} down")
