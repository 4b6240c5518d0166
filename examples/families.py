"""The trade's colour families R, RG and G, by exact optics and in the Aurora viewer.

Prints the tables of docs/families.md. `python examples/families.py docs/pictures` writes the
pictures there; without a folder, here. `roughly` after the folder takes fewer columns of layers and
smaller pictures: a tenth of the time, and other numbers than the page has.
"""

import sys
from functools import cache
from pathlib import Path

import numpy as np

import nacreous as nc
from nacreous import figure

FOLDER = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
WHITE = nc.colour.white_xyz("D65")
#: Columns of layers, columns where many thicknesses are looked at, and pictures' side in pixels.
COLUMNS, FEWER, SIDE_PX = (4, 4, 64) if sys.argv[2:] == ["roughly"] else (64, 24, 160)
LAYERS, OUTER_UM, ORDERLY_NM = 120, 50.0, 12.0
ANGLES_DEG = (0, 30, 65)
STEPS = ("1.0", "0.7", "0.4", "0.0")
#: Rings of a pearl in a picture, of equal width; the second is its centre, at 4 to 7 degrees, the
#: last but one its rim, at 61 to 70.
RINGS, CENTRE, RIM = 16, 1, 14
COLOURLESS = (("body.pigment", "none"), ("body.nucleus", "#ffffff"))

#: Reported tablets in nm, ours that give the words, and the words as Munsell's letters: of the
#: centre and of the rim, 0 and 65 degrees. Red is looked for among red-purples too.
FAMILIES = {
    "r": (330, 280, "R RP", "Y GY", "red centre, olive rim"),
    "rg": (360, 340, "BG", "RP", "blue-green centre, red-purple rim"),
    "g": (440, 358, "G", "RP", "green centre, red-purple rim"),
}


def film(thickness_nm, protein="chitin"):
    """A stack as this page has it: measured aragonite on aragonite, 20 nm of protein, air."""
    return nc.LayerStack(thickness_nm, 20.0, "aragonite", protein, 1.0, "aragonite")


def noisy(mean_nm, spread_nm, columns=COLUMNS, protein="chitin"):
    """Columns of equal layers with independent Gaussian noise; the same noise for every mean."""
    noise = np.random.default_rng(1).normal(size=(columns, LAYERS))
    return [film(np.maximum(mean_nm + spread_nm * row, 50.0), protein) for row in noise]


def grown(name, outer_um=OUTER_UM):
    """The outer layers of columns that grew by a nacre preset."""
    stacks = [nc.grow(name, seed=seed) for seed in range(1, COLUMNS + 1)]
    return [film(stack.thickness_nm[: stack.outer(outer_um)[0]]) for stack in stacks]


def colours(stacks, angles_deg, step_nm=1, light="D65"):
    """XYZ [R and T, angle, 3], each colour at Y = 1: light of columns adds by energy.

    Under a light other than D65, colours are those that look alike to an eye adapted to D65.
    """
    nm = nc.colour.WAVELENGTH_NM[::step_nm]
    angle_rad = np.radians(np.asarray(angles_deg, dtype=float))
    each = [nc.optics.energies(stack, angle_rad, nm, precision="single") for stack in stacks]
    mean = np.mean([(one.R, one.T) for one in each], axis=0)
    white = nc.colour.white_xyz(light)
    weights = nc.colour.xyz_from_spectrum(np.eye(401), light)[::step_nm]
    xyz = nc.colour.adapt(mean @ (weights * (white / weights.sum(axis=0))), white, WHITE)
    return xyz / xyz[..., 1:2]


def hue_and_chroma(xyz):
    """CIE Lab hue in degrees and chroma [..., 2]; 0 chroma is the colour of the light itself."""
    lab = nc.colour.lab_from_xyz(xyz, WHITE)
    hue = np.degrees(np.arctan2(lab[..., 2], lab[..., 1])) % 360
    return np.stack([hue, np.hypot(lab[..., 1], lab[..., 2])], axis=-1)


def munsell(xyz):
    """Munsell's hue of each colour, as "5RP"."""
    hvc = nc.colour.hvc_from_rgb(nc.colour.rgb_from_xyz(0.8 * np.asarray(xyz)))
    return [note.split(" ")[0] for note in np.ravel(nc.colour.munsell_notation(hvc))]


def listed(xyz):
    """Hue and chroma of some colours, for people."""
    pairs = zip(munsell(xyz), hue_and_chroma(xyz), strict=True)
    return ", ".join(f"{name} {hue:.0f}/{chroma:.1f}" for name, (hue, chroma) in pairs)


def codes(xyz, luminance=0.62):
    """Codes of colours on a screen, all at one luminance; chroma as it is."""
    rgb = nc.colour.rgb_from_xyz(luminance * xyz)
    return nc.colour.encode(nc.colour.map_to_gamut(rgb)).clip(0, 1)


@cache
def chroma(spread_nm, mean_nm, protein, step_nm):
    """Chroma of T along the normal for one spread of the layers."""
    stacks = noisy(mean_nm, spread_nm, COLUMNS if spread_nm else 2, protein)
    return float(hue_and_chroma(colours(stacks, [0], step_nm))[1, 0, 1])


def chroma_by_spread(spreads_nm, mean_nm=340, protein="chitin", step_nm=1):
    """Chroma of T along the normal against the spread of the layers."""
    return [chroma(float(spread), mean_nm, protein, step_nm) for spread in spreads_nm]


def draw_disorder():
    """Chroma against spread: beside an earlier calculation, by protein, and by family."""
    spreads, table = np.arange(0, 61, 2.5), (0, 5, 10, 20, 30, 45)
    earlier = (9, 9.5, 12, 12, 7.7, 2.6)
    print("disorder, chroma of T along the normal; an earlier calculation:", *earlier)
    with figure.figure(FOLDER / "disorder.png", 2, 7.2, 2.8) as (left, right):
        for protein, style in (("chitin", "C0"), ("silk-fibroin", "C1"), (1.43, "C2")):
            for step_nm, line in ((1, "-"), (5, ":")):
                row = chroma_by_spread(table, protein=protein, step_nm=step_nm)
                print(f"  {protein}, {step_nm} nm:", *(f"{one:.1f}" for one in row))
                if step_nm == 1 or protein == "chitin":
                    row = chroma_by_spread(spreads, protein=protein, step_nm=step_nm)
                    left.plot(spreads, row, line, color=style, label=f"{protein}, {step_nm} nm")
        left.plot(table, earlier, "ko", label="earlier calculation")
        for name, (_, ours, *_) in FAMILIES.items():
            label = f"{name.upper()}, {ours} nm"
            right.plot(spreads, chroma_by_spread(spreads, ours), label=label)
        for panel, title in ((left, "340 nm, by protein and step"), (right, "families, chitin")):
            panel.set(xlabel="spread of thickness, nm", ylabel="chroma of T", title=title)
            panel.legend(fontsize=7)


def scan():
    """For each family, the thicknesses whose T has its words, every 1 nm from 260 to 480."""
    means = np.arange(260, 481)
    found = [munsell(colours(noisy(m, ORDERLY_NM, FEWER), [0, 65])[1]) for m in means]
    for name, (_, _, centre, rim, words) in FAMILIES.items():
        fits = [
            int(mean)
            for mean, (middle, edge) in zip(means, found, strict=True)
            if middle.lstrip("0123456789.") in centre.split()
            and edge.lstrip("0123456789.") in rim.split()
        ]
        print(f"{name.upper()}, {words}: {runs(fits)} nm")


def runs(numbers):
    """Neighbours joined: 1, 2, 3, 7 becomes "1 to 3, 7 to 7"."""
    parts = np.split(numbers, np.flatnonzero(np.diff(numbers) > 1) + 1)
    return ", ".join(f"{part[0]} to {part[-1]}" for part in parts if len(part)) or "none"


def tabulate_families():
    """R and T of each family at three angles: reported, with its protein, and ours."""
    for name, (reported, ours, *_) in FAMILIES.items():
        for mean_nm in (reported, reported - 20, ours):
            reflected, transmitted = colours(noisy(mean_nm, ORDERLY_NM), ANGLES_DEG)
            print(f"{name.upper()} {mean_nm} nm  T {listed(transmitted)}; R {listed(reflected)}")


def draw_families():
    """What T and R look like by angle and thickness, with the families' thicknesses."""
    means, angles = np.arange(260, 481, 4), np.linspace(0, 80, 33)
    both = np.stack([colours(noisy(mean, ORDERLY_NM, FEWER), angles) for mean in means], axis=1)
    with figure.figure(FOLDER / "families.png", 2, 7.2, 4.2) as panels:
        titles = ("T, transmitted", "R, reflected")
        for panel, xyz, title in zip(panels, both[::-1], titles, strict=True):
            extent = (0, 80, means[0] - 2, means[-1] + 2)
            panel.imshow(codes(xyz), aspect="auto", origin="lower", extent=extent)
            for name, (reported, ours, *_) in FAMILIES.items():
                for mean_nm, style in ((ours, "k-"), (reported, "k:")):
                    panel.plot((0, 80), (mean_nm, mean_nm), style, lw=1)
                panel.text(79, ours + 1, name.upper(), ha="right", fontsize=8)
                panel.text(1, reported + 1, f"{name.upper()} reported", fontsize=7)
            panel.set(title=title, xlabel="angle, degrees", ylabel="mean thickness, nm")
            panel.grid(visible=False)


def draw_steps():
    """The twelve masters by their transmitted colour alone, as discs; their table."""
    side = np.linspace(-1.02, 1.02, 201)
    radius = np.hypot(*np.meshgrid(side, side))
    angles = np.linspace(0, 80, 33)
    with figure.figure(FOLDER / "families-steps.png", 4, 6.4, 5.0) as columns:
        for panel, step in zip(columns, STEPS, strict=True):
            discs = []
            for name in FAMILIES:
                stacks = grown(f"akoya-{name}-{step}")
                spread_nm = np.mean([np.std(stack.thickness_nm) for stack in stacks])
                transmitted = colours(stacks, angles)[1]
                shown = [transmitted[np.abs(angles - deg).argmin()] for deg in ANGLES_DEG]
                print(f"akoya-{name}-{step}: spread {spread_nm:.0f} nm; T {listed(shown)}")
                at = np.degrees(np.arcsin(radius.clip(0, 1))).clip(0, 80)
                row = np.stack([np.interp(at, angles, c) for c in codes(transmitted).T], axis=-1)
                row[radius > 1] = 0.05
                discs.append(row)
            panel.imshow(np.concatenate(discs))
            panel.set(title=step, xticks=[], yticks=[100, 301, 502] if step == "1.0" else [])
            panel.set_yticklabels(["R", "RG", "G"] if step == "1.0" else [])
            panel.grid(visible=False)


def tabulate_limits():
    """What else moves the colours of T: the protein, how deep light sees, and the lamp."""
    for name, (_, ours, *_) in FAMILIES.items():
        master = f"akoya-{name}-1.0"
        kinds = {
            "chitin": colours(noisy(ours, ORDERLY_NM), ANGLES_DEG),
            "silk fibroin": colours(noisy(ours, ORDERLY_NM, protein="silk-fibroin"), ANGLES_DEG),
            "1.43": colours(noisy(ours, ORDERLY_NM, protein=1.43), ANGLES_DEG),
            **{f"{um} um": colours(grown(master, um), ANGLES_DEG) for um in (30, 50, 70)},
            **{lamp: colours(grown(master), ANGLES_DEG, light=lamp) for lamp in ("D50", "A")},
        }
        for words, xyz in kinds.items():
            print(f"{name.upper()}, {words}: T {listed(xyz[1])}")


@cache
def aurora(name, *body):
    """XYZ of a pearl in the Aurora viewer [upper and lower half, centre and rim, 3], each at Y = 1.

    As seen, and as it would be if the film had no colour: light of the body's own.
    """
    pearl = nc.Pearl.load(name, [("grain", 0.0), ("film.columns", COLUMNS), *body])
    image = nc.render(pearl, "aurora", size=SIDE_PX)
    coverage = image.layers["coverage"][..., 0]
    row, column = np.indices(coverage.shape)
    down = row - np.average(row, weights=coverage)
    right = column - np.average(column, weights=coverage)
    ring = (np.hypot(down, right) / np.sqrt(coverage.sum() / np.pi) * RINGS).astype(int)
    # Up to 30 degrees from the waist, where halves pass into one another, pixels are left out.
    steep = (np.abs(down) > np.abs(right) * np.tan(np.radians(30))) & (coverage > 0.999)
    places = [steep & half & (ring == at) for half in (down < 0, down > 0) for at in (CENTRE, RIM)]
    found = []
    for part in (image.linear, image.layers["diffuse"]):
        xyz = nc.colour.xyz_from_rgb([part[place].mean(axis=0) for place in places])
        found.append((xyz / xyz[:, 1:2]).reshape(2, 2, 3))
    return found


def tabulate_aurora():
    """Hues of the families in the Aurora viewer, for the words; and the chroma of their steps."""
    for name in FAMILIES:
        for pearl in (f"akoya-{name}-1.0", f"akoya-{name}-published"):
            for words, body in (("", ()), (" with a colourless body", COLOURLESS)):
                upper, lower = aurora(pearl, *body)[0]
                print(f"Aurora, {pearl}{words}: upper {listed(upper)}; lower {listed(lower)}")
    print("Aurora, chroma of the upper half's centre, and of that of step 1.0:")
    for name in FAMILIES:
        pearls = [f"akoya-{name}-{step}" for step in STEPS]
        seen, own = np.transpose([aurora(pearl) for pearl in pearls], (1, 0, 2, 3, 4))[..., 0, 0, :]
        colourless = [aurora(pearl, *COLOURLESS)[0][0, 0] for pearl in pearls]
        kinds = {
            "as seen": seen,
            "with the body's own light as white": seen * WHITE / own,
            "of a colourless body": colourless,
        }
        for words, xyz in kinds.items():
            chroma = hue_and_chroma(xyz)[:, 1]
            steps = (f"{c:.1f} ({c / chroma[0]:.2f})" for c in chroma)
            print(f"  {name.upper()}, {words}:", *steps)


draw_disorder()
scan()
tabulate_families()
draw_families()
draw_steps()
tabulate_limits()
tabulate_aurora()
