"""`nacreous study demo | rehearse`: a study tried out, with simulated observers."""

from __future__ import annotations

import argparse
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from nacreous.commands.study_store import Actions
from nacreous.commands.terminal import say

if TYPE_CHECKING:
    import socket
    from pathlib import Path

    from nacreous.study.design import Frozen
    from nacreous.study.running import Running

_EXAMPLES = """\
examples:
  nacreous study demo                                      a whole study on this computer
  nacreous study demo --folder demo-study                  kept, to go on with later
  nacreous study rehearse http://127.0.0.1:8000 my-study --scale guess.csv
  nacreous study rehearse http://127.0.0.1:8000 paper-study --observers 104 --scale paper
"""

_PRESET = "demo"
_ACCOUNT = "lab"
#: Made up, as everything that the simulated observers of the demonstration answer.
_SCALE = {"RG": 1.0, "R": 0.45, "G": 0.25, "dull": -0.5, "thin": -1.2}
_OBSERVERS = 20


def add_demo(actions: Actions[argparse.ArgumentParser]) -> None:
    """Describe the demonstration."""
    parser = _add(
        actions,
        "demo",
        "see a whole study on this computer, with simulated observers",
        "Make a small study, let simulated observers take part, and serve it to be looked at until "
        "Ctrl-C comes. It lies in a temporary folder, which is removed at the end.",
    )
    parser.add_argument("--folder", help="keep it in a folder, empty or not there yet")
    parser.add_argument("--port", type=int, default=0, help="where to listen (any that is free)")
    parser.add_argument("--no-browser", action="store_true", help="open no browser")
    parser.set_defaults(run=demo)


def add_rehearse(actions: Actions[argparse.ArgumentParser]) -> None:
    """Describe the rehearsal."""
    parser = _add(
        actions,
        "rehearse",
        "let simulated observers take part in a study that is served",
        "Let simulated observers take part by HTTP, as browsers do. They choose from a scale by "
        "Thurstone's case V; every answer is marked as simulated, and never counts as a person's.",
    )
    parser.add_argument("url", help="where the study is served")
    parser.add_argument("study", help="its folder, which says what is on the pictures")
    parser.add_argument("--observers", type=int, default=20, metavar="N", help="how many (20)")
    parser.add_argument(
        "--scale",
        required=True,
        help="paper (table 1 of 1996), or CSV with the columns stimulus and scale, as nacreous "
        "scale -o scale.csv writes it",
    )
    parser.add_argument("--seed", type=int, default=1, help="same seed, same choices (1)")
    parser.add_argument(
        "--sigma", type=float, default=1.0, help="noise of a comparison, in units of the scale (1)"
    )
    parser.add_argument("--links", help="a file of invitation links, one a line")
    parser.set_defaults(run=rehearse)


def rehearse(args: argparse.Namespace) -> int:
    """Take part, and say how it went."""
    from nacreous.commands.progress import bar
    from nacreous.server import rehearsal
    from nacreous.study.design import open_frozen

    frozen, scale = open_frozen(args.study), rehearsal.scale_of(args.scale)
    links = _lines(args.links) if args.links else []
    with bar("rehearsing") as show:
        done = rehearsal.rehearse(
            args.url,
            frozen,
            scale,
            args.observers,
            seed=args.seed,
            sigma=args.sigma,
            links=links,
            progress=show,
        )
    say(
        f"{args.url}: {done.observers} simulated observers gave {done.answers} answers, "
        f"{done.seconds:.1f} s; each is marked as simulated"
    )
    return 0


def demo(args: argparse.Namespace) -> int:
    """Make, rehearse, serve until Ctrl-C."""
    from nacreous.commands.progress import bar
    from nacreous.server.listening import listen
    from nacreous.study.design import freeze

    with listen("127.0.0.1", args.port) as listening, _folder(args.folder) as folder:
        with bar("making pictures") as show:
            frozen = freeze(_PRESET, folder, show)
        _serve(frozen, listening, not args.no_browser)
        kept = args.folder is not None
    say(
        f"{args.folder}: kept; go on with   nacreous study serve {args.folder}"
        if kept
        else "demo: ended; its temporary folder is removed"
    )
    return 0


@contextmanager
def _folder(given: str | None) -> Iterator[Path]:
    """The folder that was asked for, or one that is gone afterwards."""
    from pathlib import Path
    from tempfile import TemporaryDirectory

    if given is not None:
        yield Path(given)
        return
    with TemporaryDirectory(prefix="nacreous-demo-", ignore_cleanup_errors=True) as temporary:
        yield Path(temporary, "study")


def _serve(frozen: Frozen, listening: socket.socket, browser: bool) -> None:
    """Serve; meanwhile, beside it, let simulated observers take part and tell what to open."""
    import secrets

    from nacreous.server.app import create_app
    from nacreous.server.listening import address_of, serve, until_stopped
    from nacreous.study.running import Running
    from nacreous.study.store import Store

    with Store.open(frozen.folder) as store:
        running = Running(store, frozen)
        store.set_registration(running.study, "open", "demo")
        password = secrets.token_urlsafe(9)
        store.set_password(_ACCOUNT, password, "demo")
        stopping = threading.Event()
        beside = threading.Thread(
            target=_rehearsed,
            args=(running, address_of(listening), password, browser, stopping),
            name="demo",
        )
        app = create_app(running)
        beside.start()
        try:
            with until_stopped():
                serve(app, listening)
        finally:
            stopping.set()
            beside.join()


class _StoppedError(Exception):
    """Ctrl-C came during the rehearsal."""


def _rehearsed(
    running: Running, address: str, password: str, browser: bool, stopping: threading.Event
) -> None:
    """Rehearse and tell what to open."""
    from nacreous.commands.progress import bar
    from nacreous.problem import InputError
    from nacreous.server.rehearsal import rehearse

    try:
        with bar("simulating observers") as show:

            def watch(share: float) -> None:
                if stopping.is_set():
                    raise _StoppedError
                if show is not None:
                    show(share)

            rehearse(address, running.frozen, _SCALE, _OBSERVERS, progress=watch)
    except (InputError, _StoppedError):
        if stopping.is_set():
            return
        raise
    say(_told(address, password))
    if browser:
        import webbrowser

        webbrowser.open(f"{address}/lab")


def _told(address: str, password: str) -> str:
    return f"""\
A study of five pearls runs on this computer; {_OBSERVERS} simulated observers have taken part.

    Take part yourself    {address}/
    Steer it, see results {address}/lab     name: {_ACCOUNT}   password: {password}

demo: serving at {address}/
Ctrl-C ends it."""


def _lines(path: str) -> list[str]:
    """The lines of a file that hold something."""
    from pathlib import Path

    from nacreous.missing import missing
    from nacreous.problem import InputError

    try:
        text = Path(path).read_text(encoding="utf-8")
    except FileNotFoundError:
        raise missing(path) from None
    except OSError as problem:
        raise InputError(f"{path}: cannot be read ({problem.strerror})") from None
    except UnicodeDecodeError:
        raise InputError(f"{path}: is no text in UTF-8; wanted: one link a line") from None
    return [line.strip() for line in text.splitlines() if line.strip()]


def _add(
    actions: Actions[argparse.ArgumentParser], name: str, does: str, description: str
) -> argparse.ArgumentParser:
    return actions.add_parser(
        name,
        help=does,
        description=description,
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
