"""`nacreous grow`: nacre from seeding to harvest, in numbers and as a drawing."""

from __future__ import annotations

import argparse
import datetime as dt
from typing import TYPE_CHECKING

from nacreous.commands.terminal import say
from nacreous.stream import STREAM

if TYPE_CHECKING:
    from pathlib import Path

    from nacreous.nacre import Diary, LayerStack
    from nacreous.spec import Growth, Pearl

_EXAMPLES = """\
examples:
  nacreous grow paper                        the statistics, and growth.png
  nacreous grow akoya-rg --set seed=9        another pearl of the same family
  nacreous grow paper --set harvest=08-15    harvested in summer
  nacreous grow paper -o growth.csv          every layer with its day, as a table
"""

_SUFFIXES = (".png", ".svg", ".pdf", ".csv")


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "grow",
        help="grow nacre and look at its layers",
        description="Grow nacre day by day from seeding to harvest; print its statistics and draw "
        "the thickness of its layers against depth and date.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("nacre", help="a nacre preset's name, or a pearl file")
    parser.add_argument(
        "-o",
        "--output",
        default="growth.png",
        help=".png, .svg, .pdf, .csv, or - for CSV (growth.png)",
    )
    parser.add_argument(
        "--set", action="append", default=[], metavar="KEY=VALUE", help="change one key of [nacre]"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Grow, print, draw."""
    from nacreous import file
    from nacreous.commands import standard
    from nacreous.nacre import diary, stack_of
    from nacreous.problem import InputError
    from nacreous.spec import Growth

    standard.check_output(args.output, _SUFFIXES)
    standard.require_apart([args.output], [args.nacre])
    pearl = _pearl(args.nacre, args.set)
    growth = pearl.nacre
    if not isinstance(growth, Growth):
        raise InputError(
            f"{args.nacre}: lists its layers in nacre.thickness_nm; wanted: growth keys"
        )
    grown, stack = diary(growth), stack_of(pearl)
    say(_statistics(args.nacre, growth, stack), [args.output])
    with standard.writing(args.output, ".csv") as output, file.atomic(output) as temporary:
        if output.suffix.lower() == ".csv":
            _write_table(temporary, growth, grown)
        else:
            _draw(temporary, growth, grown)
    say(f"{args.output}: thickness against depth and date", [args.output])
    return 0


def _pearl(name: str, settings: list[str]) -> Pearl:
    """The pearl file, or a pearl of which only the nacre is given, by a preset."""
    from pathlib import Path

    from nacreous.spec import Pearl, override, preset
    from nacreous.spec.specfile import find

    parsed = [override.parse(setting) for setting in settings]
    full = [(f"nacre.{key.removeprefix('nacre.')}", value) for key, value in parsed]
    once = override.once(f"{key}={value}" for key, value in full)
    overrides = [override.parse(setting) for setting in once]
    path = Path(name)
    is_name = path.suffix.lower() != ".toml" and len(path.parts) == 1 and name != STREAM
    if is_name and not path.is_file():
        if name in preset.names("nacre"):
            return Pearl.check({"nacre": {"preset": name}}, f"preset {name}", Path(), overrides)
        if not path.exists() and name not in preset.names("pearl"):
            find(name, ("nacre", "pearl"))  # says which one was probably meant
    return Pearl.load(name, overrides)


def _statistics(name: str, growth: Growth, stack: LayerStack) -> str:
    lines = [
        f"nacre        {name}, seed {growth.seed}",
        f"grown        {growth.days} days, {growth.seeding} to {growth.harvest}",
        f"layers       {len(stack)}",
        f"thickness    {stack.total_um:.1f} um in all",
    ]
    for depth_um in (10, 50):
        layers, mean_nm, spread_nm = stack.outer(depth_um)
        counted = f"{layers} layers, mean {mean_nm:.1f} nm, spread {spread_nm:.1f} nm"
        lines.append(f"outer {depth_um} um  {counted}")
    return "\n".join(lines)


def _depth_um(growth: Growth, grown: Diary) -> list[float]:
    """Depth of each layer's top below the surface, in the order of growth."""
    step_nm = grown.thickness_nm + growth.protein_nm
    above_nm = step_nm[::-1].cumsum()[::-1] - step_nm
    return [float(depth) for depth in above_nm / 1000]


def _write_table(path: Path, growth: Growth, grown: Diary) -> None:
    form = "%m-%d" if _every_year(growth) else "%Y-%m-%d"
    rows = zip(grown.date, _depth_um(growth, grown), grown.thickness_nm, strict=True)
    lines = [f"{date:{form}},{depth:.4f},{float(nm)!r}" for date, depth, nm in rows]
    path.write_text("date,depth_um,thickness_nm\n" + "\n".join(lines) + "\n", encoding="utf-8")


def _draw(path: Path, growth: Growth, grown: Diary) -> None:
    from nacreous.figure import figure

    with figure(path, panels=2, width_in=9, height_in=3.6) as (deep, dated):
        deep.plot(_depth_um(growth, grown), grown.thickness_nm, ".", markersize=2.5)
        deep.set_xlabel("depth below the surface, um")
        deep.set_ylabel("thickness of the layer, nm")
        dated.plot(grown.date, grown.thickness_nm, ".", markersize=2.5)
        dated.set_xlabel("day on which it grew")
        dated.tick_params(axis="x", rotation=30)
        if _every_year(growth):
            dated.set_xticks(*_months(growth))


def _months(growth: Growth) -> tuple[list[dt.date], list[str]]:
    """Where months begin, and their names; a season within one month shows its ends."""
    days = [growth.seeding_date + dt.timedelta(days=day) for day in range(growth.days)]
    begins = [day for day in days if day.day == 1]
    if len(begins) < 2:
        begins = [days[0], days[-1]]
        return begins, [f"{day:%b %d}" for day in begins]
    return begins, [f"{day:%b}" for day in begins]


def _every_year(growth: Growth) -> bool:
    """Whether days are given as MM-DD; the year that dates then have is a placeholder."""
    return len(growth.seeding) == len("MM-DD")
