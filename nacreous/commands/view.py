"""`nacreous view`: the page on which a pearl is turned, in the browser."""

from __future__ import annotations

import argparse
import os
import threading
import webbrowser
from typing import TYPE_CHECKING

from nacreous.commands.terminal import say
from nacreous.problem import InputError

if TYPE_CHECKING:
    from nacreous.spec import Pearl, Scene

_EXAMPLES = """\
examples:
  nacreous view                                    an Akoya on black cloth, in your browser
  nacreous view tahitian --scene booth             another pearl, in another scene
  nacreous view my.toml --set depth=0.8            your pearl, with one knob turned
  nacreous view --port 8080 --no-browser           always at the same address

All stays on this computer, and what you do on the page is in its address. Ctrl-C ends it.
"""

#: What the page itself begins with.
_PEARL, _SCENE = "akoya-rg", "north-window-black"


def add_parser(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Describe the command."""
    parser = subparsers.add_parser(
        "view",
        help="turn a pearl and its knobs in your browser",
        description="Serve the viewer from this computer and open it in the browser: turn the "
        "pearl, move the lamp, change every key, and see the picture that render makes.",
        epilog=_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "pearl",
        nargs="?",
        default=_PEARL,
        help=f"a pearl file, a preset's name, or - for standard input ({_PEARL})",
    )
    parser.add_argument(
        "--scene", default=_SCENE, help=f"a scene file, or a preset's name ({_SCENE})"
    )
    parser.add_argument(
        "--set", action="append", default=[], metavar="KEY=VALUE", help="change one key of a file"
    )
    parser.add_argument(
        "--port", type=int, default=0, help="where to listen on 127.0.0.1 (any that is free)"
    )
    parser.add_argument("--no-browser", action="store_true", help="say the address alone")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Serve until Ctrl-C."""
    from nacreous.server import listening
    from nacreous.viewer import Page, fragment

    specs = _specs(args)
    server = listening.server_of(Page())
    with listening.listen("127.0.0.1", args.port) as listener, listening.until_stopped():
        address = f"{listening.address_of(listener)}/#{fragment(*specs)}"
        say(f"viewer: {address}   (Ctrl-C ends it)")
        if not args.no_browser:
            # The system's own browsers start others and come back; a person's own may not.
            threading.Thread(target=_open, args=(address,), daemon=True).start()
        with listening.ended_by_signals(server):
            server.run(sockets=[listener])
    return 0


def _specs(args: argparse.Namespace) -> tuple[Pearl, Scene]:
    """Pearl and scene, which the page can show."""
    from nacreous.rows import fill
    from nacreous.spec import Pearl, Scene
    from nacreous.spec.load import shared_out
    from nacreous.spec.override import once

    of_pearl, of_scene = shared_out(once(args.set))
    pearl = Pearl.load(args.pearl, of_pearl)
    scene = Scene.load(args.scene, of_scene)
    _refuse_files(pearl, args.pearl)
    _refuse_files(scene, args.scene)
    fill([pearl], scene)
    return pearl, scene


def _refuse_files(spec: Pearl | Scene, where: str) -> None:
    """A page reads no files of the computer that it is on; one is dropped onto it by hand."""
    from nacreous.spec.specfile import move_paths

    named: list[str] = []

    def note(path: str) -> str:
        named.append(path)
        return path

    move_paths(type(spec), spec.model_dump(mode="json"), note)
    if named:
        raise InputError(
            f"{where}: names the file {named[0]}, which a page cannot read; allowed: a file that "
            "names none, and the others dropped onto the page"
        )


def _open(address: str) -> None:
    """Open the browser, unless it is one of the terminal's, which would take that over."""
    try:
        browser = webbrowser.get()
    except webbrowser.Error:
        return
    if type(browser) is not webbrowser.GenericBrowser or "BROWSER" in os.environ:
        browser.open(address)
