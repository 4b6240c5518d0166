"""The blemished area read of pearls without blemishes: every second preset in five scenes."""

from itertools import product

import nacreous as nc
from nacreous.complete import presets
from nacreous.measure import measure

SCENES = ("paper", "north-window-black", "north-window-white", "booth", "aurora")
SIZE = 288


def main() -> None:
    found: dict[str, float] = {}
    refused = 0
    for pearl, scene in product(list(presets(["pearl"])["pearl"])[::2], SCENES):
        try:
            blemishes = measure(nc.render(pearl, scene, size=SIZE, samples=4).linear).blemishes
        except nc.InputError:
            blemishes = None
        if blemishes is None:
            refused += 1
        else:
            found[f"{pearl} on {scene}"] = blemishes.area.value
    above = {name: round(area, 2) for name, area in found.items() if area > 0.1}
    print(f"{len(found)} pictures, {refused} refused; above 0.1 %: {above or 'none'}")


if __name__ == "__main__":
    main()
