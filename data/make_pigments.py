"""Make pigments.csv: how strongly each pigment of nacre absorbs, as a sum of Gaussian bands.

Run `python data/make_pigments.py` in the repository root; the file comes out byte for byte.

The centres of the bands of gold and black-lip are published. All widths that are not, all heights,
and the other pigments are our own choice, made so that 0.5 mm of nacre over the usual nucleus,
seen through a film that returns 68 % of diffuse light inwards, has a usual colour of that pearl
(docs/body.md shows the colours).
"""

import math
import sys
from pathlib import Path

FOLDER = Path(__file__).parent
WAVELENGTH_NM = range(380, 781, 10)

#: Of each pigment: (centre nm, full width at half height nm, height per mm). The widest band of
#: each stands for the even grey of what is not pigment.
BANDS = {
    "white": [(400, 120, 0.0005), (560, 1000, 0.04)],
    "cream": [(400, 140, 0.15), (500, 90, 0.045), (560, 1000, 0.07)],
    "pink": [(400, 130, 0.11), (535, 100, 0.105), (560, 1000, 0.065)],
    "gold": [
        (357, 55, 1.4),
        (390, 140, 1.15),
        (480, 110, 0.32),
        (700, 50, 0.04),
        (560, 1000, 0.09),
    ],
    "black-lip": [(400, 70, 2.3), (500, 60, 1.25), (700, 130, 3.4), (560, 1000, 2.2)],
    "dyed-blue": [(620, 130, 1.45), (560, 1000, 0.35)],
}

ABOUT = """\
Absorption of the pigments of nacre, Kubelka and Munk's K per mm at strength 1.
Made by make_pigments.py as sums of Gaussian bands. Of gold, bands at 330 to 385 nm and at 320 to
460 nm, and the dip about 700 nm: Elen 2001 and Mamangkey 2010 on Pinctada maxima; its band at
480 nm, which makes it golden rather than pale, is ours. Of black-lip, bands at 400, 500 and 700 nm:
reports of the Pearl Science Laboratory. All heights, and all of white, cream, pink and dyed-blue,
are ours."""


def absorption_per_mm(bands: list[tuple[float, float, float]], wavelength_nm: float) -> float:
    """The sum of the bands at one wavelength."""
    return sum(
        height * math.exp(-4 * math.log(2) * ((wavelength_nm - centre) / width) ** 2)
        for centre, width, height in bands
    )


def write(path: Path) -> None:
    """Write the table: its source as comments, then the column names, then the rows."""
    lines = [f"# {line}" for line in ABOUT.splitlines()]
    lines.append(",".join(["wavelength_nm", *BANDS]))
    for nm in WAVELENGTH_NM:
        cells = (f"{absorption_per_mm(bands, nm):.5f}" for bands in BANDS.values())
        lines.append(",".join([str(nm), *cells]))
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    write(Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER / "pigments.csv")
