"""Scales: seconds from raw answers to a fitted scale, and for bootstraps by people.

    python benchmarks/scaling.py            # ours
    python benchmarks/scaling.py --peers    # and other packages, and docs/benchmarks.md

The jobs: a Python list of (winner, loser), 1 000 000 simulated answers about 500 and 5000 stimuli
of spread 1 logit, to Bradley and Terry's scale; and 1000 bootstraps of 100 simulated people who
each answered every pair once. `--peers` installs other packages into a throw-away environment and
gives each the same list, in turn with ours, for at most 200 s. Nothing here is a test: machines
differ.
"""

from __future__ import annotations

import json
import platform
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from optics import processor

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

ROOT = Path(__file__).parent.parent
PEERS = ("choix", "evalica")
SIZES = (500, 5000)
ANSWERS = 1_000_000
#: Seconds a peer may take.
PATIENCE_S = 200
RUNS = 5


def answers(stimuli: int) -> list[tuple[int, int]]:
    """Simulated (winner, loser), the same in every process."""
    import numpy as np

    random = np.random.default_rng(stimuli)
    value = random.standard_normal(stimuli)
    first = random.integers(stimuli, size=ANSWERS)
    second = (first + random.integers(1, stimuli, size=ANSWERS)) % stimuli
    won = random.random(ANSWERS) < 1 / (1 + np.exp(value[second] - value[first]))
    winner, loser = np.where(won, first, second), np.where(won, second, first)
    return list(zip(winner.tolist(), loser.tolist(), strict=True))


def least_s(work: Callable[[], object], runs: int) -> float:
    """Wall seconds of the best of some runs."""
    times = []
    for _ in range(runs):
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)
    return min(times)


# --- ours


def ours(stimuli: int) -> dict[str, Any]:
    """Seconds to the scale, by model, and the scale itself in logit."""
    import nacreous as nc

    data = answers(stimuli)
    found: dict[str, Any] = {
        "s": least_s(lambda: nc.scaling.bradley_terry(data), RUNS),
        "probit_s": least_s(lambda: nc.scaling.thurstone(data), RUNS),
    }
    fit = nc.scaling.bradley_terry(data)
    place = dict(zip(fit.stimuli, fit.scale.tolist(), strict=True))
    found["scale"] = [place[str(index)] for index in range(stimuli)]
    return found


def ours_bootstrap(stimuli: int) -> dict[str, float]:
    """Seconds for 1000 bootstraps by 100 people, by model."""
    import numpy as np

    import nacreous as nc

    random = np.random.default_rng(1)
    people = 100
    i, j = np.triu_indices(stimuli, 1)
    left, right, person = np.tile(i, people), np.tile(j, people), np.repeat(range(people), len(i))
    own = np.linspace(0.8, -0.8, stimuli) + 0.4 * random.standard_normal((people, stimuli))
    lead = own[person, left] - own[person, right] + random.standard_normal(len(left))
    data = nc.scaling.Answers.of_table(
        {
            "person": person,
            "left": left,
            "right": right,
            "chosen": np.where(lead > 0, left, right),
        }
    )
    found = {}
    for name in ("thurstone", "bradley_terry"):
        fit = getattr(nc.scaling, name)(data)
        fit.bootstrap(samples=10)  # SciPy is imported once
        found[name] = least_s(fit.bootstrap, RUNS)
    return found


# --- peers: each gives the scale in logit, in the order of the stimuli


def peer_choix(data: list[tuple[int, int]], stimuli: int) -> NDArray[np.float64]:
    import choix

    return choix.ilsr_pairwise(stimuli, data)


def peer_evalica(data: list[tuple[int, int]], stimuli: int) -> NDArray[np.float64]:
    import evalica
    import numpy as np

    winners, losers = zip(*data, strict=True)
    result = evalica.bradley_terry(
        winners, losers, [evalica.Winner.X] * len(data), tolerance=1e-6, limit=100_000
    )
    return np.log(result.scores.sort_index().to_numpy())


def peer(name: str, stimuli: int) -> dict[str, Any]:
    """Seconds and the scale; in the peer's environment."""
    data = answers(stimuli)
    work = globals()[f"peer_{name}"]
    work([(0, 1), (1, 0)], 2)  # imports are not counted
    begin = time.perf_counter()
    scale = work(data, stimuli)
    return {"s": time.perf_counter() - begin, "scale": (scale - scale.mean()).tolist()}


def in_another_process(python: str | Path, *arguments: object) -> dict[str, Any]:
    """What this file prints there; empty if it failed, or took too long."""
    command = [str(python), __file__, *map(str, arguments)]
    limit_s = PATIENCE_S + 30  # making the list is not counted
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, timeout=limit_s)
    except subprocess.TimeoutExpired:
        return {"late": True}
    if done.returncode:
        return {}
    found: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return found


def row(name: str, stimuli: int, found: dict[str, Any], own: dict[str, Any]) -> str:
    if found.get("late") or found.get("s", 0) > PATIENCE_S:
        least = PATIENCE_S / own["s"]
        return f"| {name} | {stimuli} | not done after {PATIENCE_S} | more than {least:,.0f} | |"
    if not found:
        return f"| {name} | {stimuli} | did not run here | | |"
    apart = max(abs(a - b) for a, b in zip(found["scale"], own["scale"], strict=True))
    ratio = found["s"] / own["s"]
    return f"| {name} | {stimuli} | {found['s']:.2f} | {ratio:,.1f} | {apart:.1e} |"


def compare(fits: dict[int, dict[str, Any]]) -> list[str]:
    """A line of the table for each peer that installs, timed in turn with ours."""
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, "-m", "venv", folder], check=True)
        python = Path(folder, "bin", "python")
        for name in PEERS:
            install = [python, "-m", "pip", "install", "--quiet", name, "numpy", "scipy"]
            installed = subprocess.run(install, stdout=subprocess.DEVNULL).returncode == 0
            for stimuli in SIZES:
                found = in_another_process(python, "--peer", name, stimuli) if installed else {}
                again = in_another_process(sys.executable, "--ours", stimuli)
                fits[stimuli]["s"] = min(fits[stimuli]["s"], again["s"])
                rows.append(row(name, stimuli, found, fits[stimuli]))
                print(rows[-1], flush=True)
    return rows


def page(
    fits: dict[int, dict[str, Any]], bootstraps: dict[int, dict[str, float]], peers: list[str]
) -> str:
    """The section of docs/benchmarks.md."""
    return "\n".join(
        [
            "## Scales",
            "",
            f"Wall seconds from a Python list of {ANSWERS:,} (winner, loser) to a fitted scale, "
            f"best of {RUNS}",
            "(`python benchmarks/scaling.py --peers`; simulated answers;",
            f"{processor()}, Python {platform.python_version()}):",
            "",
            "| stimuli | Bradley-Terry | Thurstone, case V |",
            "|---|---|---|",
            *(f"| {n} | {fit['s']:.2f} | {fit['probit_s']:.2f} |" for n, fit in fits.items()),
            "",
            "Wall seconds of 1000 bootstraps of 100 simulated people who answered every pair once, "
            "standard errors in",
            "each sample included:",
            "",
            "| stimuli | Bradley-Terry | Thurstone, case V |",
            "|---|---|---|",
            *(
                f"| {n} | {found['bradley_terry']:.3f} | {found['thurstone']:.3f} |"
                for n, found in bootstraps.items()
            ),
            "",
            *(
                [
                    "Others on the same lists, to Bradley and Terry's scale, one run each, in turn "
                    'with ours; "apart" is the',
                    "largest difference from our scale, in logit:",
                    "",
                    "| package | stimuli | seconds | times ours | apart |",
                    "|---|---|---|---|---|",
                    *peers,
                    "",
                ]
                if peers
                else []
            ),
        ]
    )


def written(text: str, section: str) -> str:
    """The page with this section in place of the one before, else in front of exact optics."""
    before, heading, rest = text.partition("## Scales")
    if heading:
        after = rest.partition("\n## ")
        rest = "## " + after[2] if after[1] else ""
    else:
        before, heading, rest = text.partition("## Exact optics")
        rest = heading + rest
    return before.rstrip() + "\n\n" + section + ("\n" + rest if rest else "")


def main() -> None:
    fits = {n: in_another_process(sys.executable, "--ours", n) for n in SIZES}
    bootstraps = {n: in_another_process(sys.executable, "--bootstrap", n) for n in (7, 50)}
    peers = compare(fits) if "--peers" in sys.argv else []
    section = page(fits, bootstraps, peers)
    print(section)
    if peers:
        document = ROOT / "docs" / "benchmarks.md"
        document.write_text(written(document.read_text(encoding="utf-8"), section))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--ours"]:
        print(json.dumps(ours(int(sys.argv[2]))))
    elif sys.argv[1:2] == ["--bootstrap"]:
        print(json.dumps(ours_bootstrap(int(sys.argv[2]))))
    elif sys.argv[1:2] == ["--peer"]:
        print(json.dumps(peer(sys.argv[2], int(sys.argv[3]))))
    else:
        main()
