"""The paper's judgements as a scale, with its doubt and its misfit, and two simulated groups.

python examples/scaling.py FOLDER
"""

import sys
from pathlib import Path

import nacreous as nc

FOLDER = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
FOLDER.mkdir(parents=True, exist_ok=True)

# The answers of 1996, reconstructed from the published table.
fit = nc.scaling.thurstone(nc.scaling.paper())
good = nc.scaling.goodness(fit)
order = [fit.stimuli.index(label) for label in fit.ranking]
print(fit)
print(good.verdict)

nc.scaling.scale_plot(fit, FOLDER / "scaling-scale.png", unit="likeness to a pearl, z")
nc.scaling.interval_plot(
    fit,
    FOLDER / "scaling-doubt.png",
    intervals=fit.bootstrap(samples=2000, seed=1).intervals(),
    unit="likeness to a pearl, z",
)
nc.scaling.matrix_plot(
    good.residuals,
    fit.stimuli,
    FOLDER / "scaling-misfit.png",
    kind="residuals",
    order=order,
    width_pt=280,
)

# Simulated observers, no people: one group judges by the same scale, drawn out by half.
shown = {label: 1.5 * value for label, value in zip(fit.stimuli, fit.scale, strict=True)}
not_shown = dict(zip(fit.stimuli, fit.scale, strict=True))
groups = {
    "simulated, not shown": nc.scaling.simulate(not_shown, people=50, person_spread=0.3, seed=1),
    "simulated, shown": nc.scaling.simulate(shown, people=50, person_spread=0.3, seed=2),
}
found = nc.scaling.compare_groups(groups, same_people=False)
print(f"one scale for both groups: p = {found.p_value:.4f}")
nc.scaling.scale_plot(found.fits, FOLDER / "scaling-groups.png", unit="likeness to a pearl, z")
