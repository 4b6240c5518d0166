"""The model of 1996 beside exact optics, on the same nacre: the pictures of docs/coherence.md.

`python examples/coherence.py docs/pictures` writes them there; without a folder, here.
"""

import sys
from pathlib import Path

import numpy as np

import nacreous as nc
from nacreous import figure, iridescence

FOLDER = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
NM = nc.colour.WAVELENGTH_NM
WHITE = nc.colour.white_xyz("D65")
COLUMNS, LAYERS, COHERENCE_NM, LOSS = 16, 60, 5000.0, 0.03
PAPER, UNIAXIAL = 1.53, (1.683, 1.530)


def columns(aragonite):
    """Columns of nacre of one season, side by side: their outer layers, on more aragonite."""
    grown = [nc.grow("akoya-rg", seed=seed).thickness_nm[:LAYERS] for seed in range(COLUMNS)]
    substrate = aragonite if isinstance(aragonite, float) else aragonite[0]
    return [nc.LayerStack(nm, 20.0, aragonite, 1.43, 1.0, substrate) for nm in grown]


def mean(spectrum, stacks):
    """The mean spectrum of all columns: their light is added by energy."""
    return np.mean([spectrum(stack) for stack in stacks], axis=0)


def interference(stack):
    """The model of 1996 at the normal."""
    return nc.optics.illuminant(stack, 0.0, NM, COHERENCE_NM, diffuse_loss=LOSS)[0]


def reflected(stack, coherence_nm=None):
    """Exact R at the normal."""
    return nc.optics.reflectance(stack, 0.0, NM, coherence_nm=coherence_nm)[0]


def peak_nm(spectrum):
    """The peak of second order, which lies in this range for all that is shown here."""
    second = np.where((NM > 480) & (NM < 740), spectrum, 0)
    return float(NM[second.argmax()])


def hue_deg(spectrum):
    """Hue angle in CIE Lab under D65."""
    _, a, b = nc.colour.lab_from_xyz(nc.colour.xyz_from_spectrum(spectrum, "D65"), WHITE)
    return float(np.degrees(np.arctan2(b, a))) % 360


def compare(panel, light, partial, stacks):
    """The model's spectrum beside R, as it is and with the protein's share of the path."""
    layer_nm = float(np.mean([stack.thickness_nm for stack in stacks]))
    stretch = 1 + 1.43 * 20 / (PAPER * layer_nm)
    stretched = np.interp(NM / stretch, NM, light)
    panel.plot(
        NM, light * partial.max() / light.max(), "k--", lw=1.2, label="model of 1996, scaled"
    )
    for name, spectrum in (("as it is", light), (f"wavelengths x {stretch:.3f}", stretched)):
        alike = np.corrcoef(spectrum[NM > 420], partial[NM > 420])[0, 1]
        print(f"  model of 1996, {name}: peak at {peak_nm(spectrum):.0f} nm", end="; ")
        print(f"correlation with R {alike:+.2f}, with T {-alike:+.2f}")


def draw_spectra():
    """Three spectra of one nacre at the normal, with the paper's index and with aragonite's own."""
    with figure.figure(FOLDER / "coherence-spectra.png", 2, 6.8, 2.7) as axes:
        for panel, (index, name) in zip(
            axes, ((PAPER, "n = 1.53"), (UNIAXIAL, "n = 1.683 across, 1.530 along")), strict=True
        ):
            stacks = columns(index)
            one, many = reflected(stacks[0]), mean(reflected, stacks)  # fully coherent
            partial = mean(lambda stack: reflected(stack, COHERENCE_NM), stacks)
            panel.plot(NM, many, color="0.6", lw=0.8, label=f"R, mean of {COLUMNS} columns")
            panel.plot(NM, partial, lw=2, label="the same, partly coherent (5 µm)")
            print(f"{name}: R peaks at {peak_nm(partial):.0f} nm; mean R {many.mean():.3f}")
            print(f"  one column from the mean {np.std(one - many):.3f} rms")
            print(f"  fringes that partial coherence removes {np.std(many - partial):.3f} rms")
            print(f"  hue of R {hue_deg(partial):.0f}, of T {hue_deg(1 - partial):.0f} degrees")
            if index == PAPER:
                compare(panel, mean(interference, stacks), partial, stacks)
            panel.set_title(name)
            panel.set_xlabel("wavelength, nm")
        axes[0].set_ylim(top=0.42)
        axes[0].legend(fontsize=6)


def draw_colours():
    """What a ball shows from its middle to its rim: R, T, and light from within."""
    angle = np.radians(np.linspace(0, 89, 240))
    pairs = [iridescence.exact(stack) for stack in columns(UNIAXIAL)[:8]]
    exact = [np.mean([pair[i].at(angle) for pair in pairs], axis=0) for i in (0, 1)]
    within = np.mean(
        [iridescence.illuminant_model(s, diffuse_loss=LOSS).at(angle) for s in columns(PAPER)[:8]],
        axis=0,
    )
    names = ("exact R (brighter)", "exact T", "model of 1996")
    with figure.figure(FOLDER / "coherence-colours.png", 3, 9, 1.5) as axes:
        for panel, name, xyz in zip(axes, names, (*exact, within), strict=True):
            scale = 0.8 / np.median(xyz[:, 1])
            codes = nc.colour.encode(nc.colour.map_to_gamut(nc.colour.rgb_from_xyz(xyz * scale)))
            panel.imshow(codes[None].clip(0, 1), aspect="auto", extent=(0, 89, 0, 1))
            panel.set(title=name, xlabel="angle, degrees", yticks=[])
            panel.grid(visible=False)


def colour(stack, angle_rad, step_nm):
    """Lab of R and T [2, angle, 3] from spectra in steps of that size."""
    nm = 380 + step_nm * np.arange(round(400 / step_nm) + 1)
    light = nc.optics.energies(stack, angle_rad, nm, precision="single")
    each = nc.colour.xyz_from_spectrum(np.eye(401), "D65")
    weights = np.stack([np.interp(nm, NM, column) for column in each.T], axis=1)
    weights *= WHITE / weights.sum(axis=0)
    return nc.colour.lab_from_xyz(np.stack([light.R, light.T]) @ weights, WHITE)


def draw_steps():
    """How wrong a colour is when the spectrum is sampled too coarsely."""
    steps_nm = (10.0, 5.0, 2.0, 1.0, 0.5, 0.25, 0.125)
    angle = np.radians(np.linspace(0, 75, 31))
    with figure.figure(FOLDER / "coherence-step.png", 1, 5.5, 3.4) as panel:
        for layers in (20, 100, 400):
            thickness_nm = np.random.default_rng(1).normal(380, 15, layers)
            stack = nc.LayerStack(thickness_nm, 20.0, UNIAXIAL, 1.43, 1.0, 1.683)
            best = colour(stack, angle, 1 / 32)
            errors = [nc.colour.delta_e_2000(colour(stack, angle, s), best) for s in steps_nm]
            against_1 = [
                nc.colour.delta_e_2000(colour(stack, angle, s), colour(stack, angle, 1.0)).max()
                for s in (10.0, 5.0)
            ]
            worst = [float(error.max()) for error in errors]
            panel.loglog(steps_nm, worst, "o-", label=f"{layers} layers")
            listed = ", ".join(f"{s:g}: {e:.2f}" for s, e in zip(steps_nm, worst, strict=True))
            print(f"{layers} layers, CIEDE2000 by step in nm: {listed}")
            print(f"  against 1 nm: 10 nm {against_1[0]:.1f}, 5 nm {against_1[1]:.1f}")
        panel.axhline(0.2, color="k", lw=0.8)
        panel.set(xlabel="wavelength step, nm", ylabel="largest CIEDE2000 of R and T")
        panel.legend()


draw_spectra()
draw_colours()
draw_steps()
