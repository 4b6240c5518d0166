"""Nine pearls of unlike shapes and colours on black cloth.

`python examples/shapes.py out.png [SIZE]`, SIZE being pixels a side.
"""

import sys

import nacreous as nc
from nacreous.spec import Row

KINDS = ["akoya-rg", "tahitian", "akoya-cream"]
WORDS = ["drop", "baroque", "circled", "button", "oval", "round", "semi-baroque", "circled", "drop"]


def main(path: str, size: int = 768) -> None:
    """Three rows of three; each pearl grows by a seed of its own and is turned a little."""
    pearls = []
    for at, word in enumerate(WORDS):
        words = nc.trade.with_words([f"shape={word}"], [])
        pearl = nc.Pearl.load(KINDS[(at + at // 3) % 3], words)
        pearls.append(
            pearl.replace(
                nacre=pearl.nacre.replace(seed=at + 1),
                coat=pearl.coat.replace(thickness_spread=0.02, liveliness=0.5),
                shape=pearl.shape.replace(seed=at + 11),
                pose=pearl.pose.replace(turn_deg=25.0 * at),
            )
        )
    rows = [Row(pearls=("*", "*", "*"))] * 3
    scene = nc.Scene.load("north-window-black").replace(rows=rows)
    camera = scene.camera.replace(elevation_deg=42.0, field_mm=62.0)
    nc.render(pearls, scene.replace(camera=camera), size=size).save(path)


if __name__ == "__main__":
    main(sys.argv[1], *(int(argument) for argument in sys.argv[2:]))
