"""`nacreous render paper` in this process, with a stopwatch beside it; `main_job.py` starts it."""

from __future__ import annotations

import sys
import time
from typing import Any

STAGES = ("interpreter", "imports", "reading", "rendering", "writing", "rest")


class Stopwatch:
    """Wall and processor seconds by stage, of this process."""

    def __init__(self, begin_s: float) -> None:
        self.spent_s = {stage: [0.0, 0.0] for stage in STAGES}
        self.last_s = [begin_s, 0.0]

    def lap(self, stage: str) -> None:
        """Count what passed since the last lap as this stage."""
        # On the platforms of these benchmarks a clock that the parent process shares.
        now_s = [time.perf_counter(), time.process_time()]
        for kind in (0, 1):
            self.spent_s[stage][kind] += now_s[kind] - self.last_s[kind]
        self.last_s = now_s

    def watch(self, owner: Any, name: str, stage: str) -> None:
        """Count each call of `owner.name` as this stage, and what came before as the rest."""
        call = getattr(owner, name)

        def watched(*arguments: Any, **options: Any) -> Any:
            self.lap("rest")
            try:
                return call(*arguments, **options)
            finally:
                self.lap(stage)

        setattr(owner, name, watched)


def run(begin_s: float, output: str, record: str) -> None:
    """The main job in this process, whose start was at `begin_s`; the times go into `record`."""
    stopwatch = Stopwatch(begin_s)
    stopwatch.lap("interpreter")
    from nacreous import cli, image, recipe

    stopwatch.lap("imports")
    stopwatch.watch(recipe, "recipe", "reading")
    stopwatch.watch(image, "render_recipe", "rendering")
    stopwatch.watch(image.Image, "save", "writing")
    sys.argv = ["nacreous", "render", "paper", "-o", output]
    cli.prepare()
    code = cli.main()
    stopwatch.lap("rest")
    import json
    from pathlib import Path

    Path(record).write_text(json.dumps([stopwatch.spent_s, stopwatch.last_s]))
    sys.exit(code)


if __name__ == "__main__" and len(sys.argv) == 4:
    run(float(sys.argv[1]), *sys.argv[2:])
