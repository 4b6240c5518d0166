"""How often people are flagged: honest ones, and ones who do not look. All simulated.

    python benchmarks/flags.py

The paper's experiment (7 crops, 21 pairs, 4 repeats), 40 studies of 104 observers for each line;
one in twenty is planted. Honest people stray from table 1 by a normal spread on every crop.
"""

from __future__ import annotations

import sys
from collections import Counter
from pathlib import Path

import numpy as np

from nacreous.server.rehearsal import scale_of
from nacreous.study.design import Design
from nacreous.study.plan import trials
from nacreous.study.task.pair.pair import PAIR

sys.path.insert(0, str(Path(__file__).parent.parent))
from tests.support.gathering import table_of

STUDIES, PEOPLE = 40, 104
KINDS = ("repeats", "side", "circles")


def chosen(how: str, lead: float, random: np.random.Generator) -> str:
    """What somebody chooses whose left one leads by so much."""
    if how == "always left":
        return "left"
    noise = random.standard_normal()
    return "left" if (noise if how == "a coin" else lead + noise) > 0 else "right"


def rates(planted: str, spread: float) -> dict[str, Counter[str]]:
    """Shares of people with each flag, of honest and of planted ones."""
    design, truth = Design.load("paper"), scale_of("paper")
    plans = [trials(design, number) for number in range(PEOPLE)]
    flagged: dict[str, Counter[str]] = {"honest": Counter(), planted: Counter()}
    total: Counter[str] = Counter()
    for study in range(STUDIES):
        random = np.random.default_rng([study, round(100 * spread)])
        rows, hows = [], {}
        for number, plan in enumerate(plans):
            how = hows[number] = planted if number % 20 == 0 else "honest"
            total[how] += 1
            own = {label: at + spread * random.standard_normal() for label, at in truth.items()}
            rows += [
                {
                    "number": number,
                    "trial": trial.number,
                    "question": trial.question,
                    "left": trial.stimuli[0],
                    "right": trial.stimuli[1],
                    "kind": trial.kind,
                    "chosen": chosen(how, own[trial.stimuli[0]] - own[trial.stimuli[1]], random),
                    "response_ms": None,
                    "simulated": True,
                    "excluded": None,
                }
                for trial in plan
                if trial.kind in ("pair", "repeat")
            ]
        for number, flags in PAIR.flags(design.asked, table_of(rows)).items():
            kinds = {"side" if flag.kind in ("left", "right") else flag.kind for flag in flags}
            flagged[hows[number]].update(kinds | ({"any"} if kinds else set()))
    return {
        how: Counter({kind: count / total[how] for kind, count in found.items()})
        for how, found in flagged.items()
    }


def main() -> None:
    """Print a line for each."""
    print(f"{'':12} {'spread':>6}  " + "  ".join(f"{kind:>8}" for kind in (*KINDS, "any")))
    for spread in (0.0, 0.3, 0.6):
        for planted in ("a coin", "always left"):
            for how, found in rates(planted, spread).items():
                if how == "honest" and planted == "always left":
                    continue
                cells = "  ".join(f"{100 * found[kind]:6.1f} %" for kind in (*KINDS, "any"))
                print(f"{how:12} {spread:6.1f}  {cells}")


if __name__ == "__main__":
    main()
