"""`nacreous strand`: lots of pearls, sorted into strands that match, and pictures of these."""

from __future__ import annotations

import argparse
import time
from collections.abc import Sequence
from typing import TYPE_CHECKING

from nacreous.commands.terminal import counted, say

if TYPE_CHECKING:
    from nacreous.strand import Lot, Sorting, Strand

_EXAMPLES = """\
examples:
  nacreous strand draw --count 2000 -o lot.csv           a lot of Akoya, by chance
  nacreous strand draw --mean size_mm=12 --spread size_mm=0.8 -o large.csv
  nacreous strand sort lot.csv -o sorted.csv             strands of 56 pearls that match
  nacreous strand sort lot.csv --graduated 1 -o sorted.csv   1 mm larger at the centre
  nacreous strand show sorted.csv                        how well each matches
  nacreous strand show sorted.csv --strand 1 -o strand.png   a picture of the best one
"""

Actions = argparse._SubParsersAction


def add_parser(subparsers: Actions[argparse.ArgumentParser]) -> None:
    """Describe the command and what it can do."""
    parser = subparsers.add_parser(
        "strand",
        help="draw lots of pearls, sort them into strands, and show these",
        description="Draw a lot of pearls from a population, sort a lot into strands whose pearls "
        "match in colour, size and luster, score strands, and make pictures of them.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    actions = parser.add_subparsers(title="actions", metavar="ACTION", dest="action", required=True)
    _add_draw(actions)
    _add_sort(actions)
    _add_show(actions)


def _add(
    actions: Actions[argparse.ArgumentParser], name: str, what: str
) -> argparse.ArgumentParser:
    return actions.add_parser(
        name,
        help=what,
        description=f"{what[0].upper()}{what[1:]}.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )


def _add_draw(actions: Actions[argparse.ArgumentParser]) -> None:
    parser = _add(actions, "draw", "draw a lot of pearls from a population")
    parser.add_argument("--count", type=int, default=560, help="how many pearls (560)")
    parser.add_argument("--seed", type=int, default=1, help="another lot of the same kind (1)")
    for name, dest, what in (
        ("mean", "mean", "mean"),
        ("spread", "deviation", "standard deviation"),
    ):
        parser.add_argument(
            f"--{name}",
            dest=dest,
            action="append",
            default=[],
            metavar="KEY=VALUE",
            help=f"change a {what}, of size_mm, L, a, b or facet_spread_rad (an Akoya lot's)",
        )
    _add_output(parser, "lot.csv")
    parser.set_defaults(run=draw)


def _add_sort(actions: Actions[argparse.ArgumentParser]) -> None:
    parser = _add(actions, "sort", "sort a lot into strands whose pearls match")
    parser.add_argument("lot", help="a table of pearls: size_mm, L, a, b, facet_spread_rad; or -")
    parser.add_argument("--length", type=int, default=56, help="pearls in a strand (56)")
    parser.add_argument(
        "--graduated",
        type=float,
        default=0.0,
        metavar="MM",
        help="how much larger the centre is than the ends (0, even strands)",
    )
    parser.add_argument("--strands", type=int, help="how many (as many as the lot has pearls for)")
    parser.add_argument("--json", action="store_true", help="the scores as JSON")
    _add_output(parser, "sorted.csv")
    parser.set_defaults(run=sort)


def _add_show(actions: Actions[argparse.ArgumentParser]) -> None:
    parser = _add(actions, "show", "show how well strands match, or make a picture of one")
    parser.add_argument("sorted", help="what `nacreous strand sort` wrote, or a lot; or -")
    parser.add_argument("--strand", type=int, help="only this one; 1 matches best")
    parser.add_argument("--json", action="store_true", help="the scores as JSON")
    parser.add_argument("-o", "--output", help="a picture of the strand, .png or .exr")
    parser.add_argument("--pearl", default="akoya-rg", help="what its pearls share (akoya-rg)")
    parser.add_argument("--scene", default="north-window-black", help="(north-window-black)")
    parser.add_argument(
        "--laid",
        choices=["folds", "neck"],
        default="folds",
        help="on the cloth in folds, or around a neck (folds)",
    )
    parser.add_argument("--size", type=int, default=768, help="pixels a side (768)")
    parser.add_argument("--samples", type=int, default=16, help="a pixel at most (16)")
    parser.add_argument("--seed", type=int, default=1, help="of the first pearl's growth (1)")
    parser.set_defaults(run=show)


def _add_output(parser: argparse.ArgumentParser, default: str) -> None:
    parser.add_argument(
        "-o", "--output", default=default, help=f".csv, or - for standard output ({default})"
    )


def draw(args: argparse.Namespace) -> int:
    """Draw a lot and write it."""
    from nacreous import file
    from nacreous.commands import standard
    from nacreous.number import whole_of
    from nacreous.strand import AKOYA, write_lot
    from nacreous.strand.lot import MOST_PEARLS

    standard.check_output(args.output, (".csv",))
    whole_of("--count", args.count, 1, MOST_PEARLS)
    changes = (_numbers("mean", args.mean), _numbers("spread", args.deviation))
    lot = AKOYA.replace(*changes).draw(args.count, args.seed)
    with standard.writing(args.output, ".csv") as output, file.atomic(output) as temporary:
        write_lot(temporary, lot)
    sizes = f"{lot.size_mm.min():.2f} to {lot.size_mm.max():.2f} mm"
    say(f"{args.output}: {counted(len(lot), 'pearl')}, {sizes}, seed {args.seed}", [args.output])
    return 0


def sort(args: argparse.Namespace) -> int:
    """Sort a lot, write it, and say what sorting and cutting alone would have given."""
    from nacreous import file
    from nacreous.commands import standard
    from nacreous.commands.progress import bar
    from nacreous.number import whole_of, within
    from nacreous.strand import Form, cut_lot, read_lot, sort_lot, write_sorted
    from nacreous.strand.form import LONGEST, MOST_GRADUATED_MM
    from nacreous.strand.sorting import require_sizes

    standard.check_output(args.output, (".csv",))
    standard.require_apart([args.output], [args.lot])
    length = whole_of("--length", args.length, 2, LONGEST)
    form = Form(length, within("--graduated", args.graduated, 0, MOST_GRADUATED_MM))
    with standard.reading(args.lot, ".csv") as given:
        lot = read_lot(given)
    require_sizes(lot, form.graduation_mm, "--graduated")
    begin = time.monotonic()
    with bar("sorting") as progress:
        sorting = sort_lot(lot, form, args.strands, progress)
    seconds = time.monotonic() - begin
    with standard.writing(args.output, ".csv") as output, file.atomic(output) as temporary:
        write_sorted(temporary, lot, sorting)
    if args.json:
        say(_json(lot, sorting), [args.output])
        return 0
    cut = cut_lot(lot, form, args.strands).score
    say(
        f"{args.output}: {counted(len(sorting.strands), 'strand')} of {form.length} pearls, "
        f"{len(sorting.spare)} left over, {seconds:.1f} s; mean score {sorting.score:.2f} "
        f"(0 is all alike), sorted and cut {cut:.2f}",
        [args.output],
    )
    return 0


def show(args: argparse.Namespace) -> int:
    """Print the scores, and make a picture where one is wanted."""
    from nacreous.commands import standard
    from nacreous.problem import InputError
    from nacreous.strand import Sorting, read_sorted

    if args.output is not None:
        from nacreous import image

        standard.check_output(args.output, image.SUFFIXES)
        standard.require_apart([args.output], [args.sorted, args.pearl, args.scene])
    with standard.reading(args.sorted, ".csv") as given:
        lot, sorting = read_sorted(given)
    number = 1 if args.strand is None and args.output is not None else args.strand
    if number is not None:
        if not 1 <= number <= len(sorting.strands):
            raise InputError(f"--strand {number}; allowed: 1 to {len(sorting.strands)}")
        sorting = Sorting(sorting.strands[number - 1 : number], sorting.spare[:0])
    first = number or 1
    shown = _json(lot, sorting, first) if args.json else _lines(lot, sorting.strands, first)
    if args.output is not None:
        _picture(args, shown, lot.take(sorting.strands[0].pearls))
    else:
        say(shown, [])
    return 0


_LAID = {"folds": "in folds", "neck": "around a neck"}


def _picture(args: argparse.Namespace, shown: str, strand: Lot) -> None:
    """Say what is `shown` and render the strand's pearls in rows, once all of it can be."""
    import sys

    from nacreous import image
    from nacreous.commands.progress import bar
    from nacreous.recipe import recipe
    from nacreous.spec import Pearl, Scene, Shape
    from nacreous.strand.picture import hung, laid_out
    from nacreous.stream import STREAM

    found = hung(strand, Pearl.load(args.pearl), args.seed)
    is_ball = found.pearls[0].shape == Shape()
    widest_mm = float(strand.size_mm.max()) if is_ball else None
    scene = laid_out(len(strand), Scene.load(args.scene), args.laid, widest_mm)
    made = recipe(found.pearls, scene, args.size, args.samples)
    say(shown, [args.output])
    begin = time.monotonic()
    with bar("rendering") as progress:
        picture = image.render_recipe(made, progress)
    picture.save(sys.stdout.buffer if args.output == STREAM else args.output)
    say(
        f"{args.output}: {counted(len(strand), 'pearl')} {_LAID[args.laid]} in scene "
        f"{scene.name}, {args.size} x {args.size}, {time.monotonic() - begin:.1f} s; "
        f"body colours by the nearest pigment, {found.colour_off:.1f} CIEDE2000 off in mean",
        [args.output],
    )


def _numbers(option: str, settings: Sequence[str]) -> dict[str, float]:
    """KEY=VALUE of --mean or --spread."""
    from nacreous.problem import InputError
    from nacreous.spec.complaint import shown

    found: dict[str, float] = {}
    for setting in settings:
        key, _, value = (part.strip() for part in setting.partition("="))
        if key in found:
            raise InputError(f"--{option} {shown(setting)}: {key} is given twice; allowed: once")
        try:
            found[key] = float(value)
        except ValueError:
            raise InputError(
                f"--{option} {shown(setting)}: wanted: key=number, such as size_mm=7.25"
            ) from None
    return found


def _lines(lot: Lot, strands: Sequence[Strand], first: int) -> str:
    """A line for each strand."""
    lines = ["strand  pearls  smallest  largest mm  neighbours  overall  score  matching"]
    for number, strand in enumerate(strands, first):
        sizes, found = lot.size_mm[strand.pearls], strand.matching
        lines.append(
            f"{number:6}  {len(sizes):6}  {sizes.min():8.2f}  {sizes.max():10.2f}  "
            f"{found.neighbours:10.2f}  {found.overall:7.2f}  {found.score:5.2f}  {found.word}"
        )
    return "\n".join(lines)


def _json(lot: Lot, sorting: Sorting, first: int = 1) -> str:
    """The strands with their scores, and the names of all pearls in order."""
    import json

    strands = [
        {
            "strand": number,
            "neighbours": strand.matching.neighbours,
            "overall": strand.matching.overall,
            "score": strand.matching.score,
            "matching": strand.matching.word,
            "pearls": list(lot.take(strand.pearls).names),
        }
        for number, strand in enumerate(sorting.strands, first)
    ]
    spare = [lot.names[at] for at in sorting.spare.tolist()]
    record = {"score": sorting.score, "strands": strands, "spare": spare}
    return json.dumps(record, ensure_ascii=False, indent=2)
