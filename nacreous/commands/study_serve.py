"""`nacreous study serve | account`: the study's pages for participants and experimenters."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from nacreous.commands.study_store import Actions, who
from nacreous.commands.terminal import say

if TYPE_CHECKING:
    from nacreous.study.design import Frozen
    from nacreous.study.store import Store

_EXAMPLES = """\
examples:
  nacreous study account my-study mikimoto        a name and a password for an experimenter
  nacreous study serve my-study                   on this computer, http://127.0.0.1:8000
  nacreous study serve my-study --host 0.0.0.0    for the other computers of a laboratory
  nacreous study serve my-study --store postgresql://lab@localhost/pearls \\
      --url https://pearls.example                behind a proxy that speaks HTTPS
"""


def add_actions(actions: Actions[argparse.ArgumentParser]) -> None:
    """Describe both."""
    parser = add_action(actions, "serve", "serve a frozen study's pages to participants", _EXAMPLES)
    parser.add_argument("--host", default="127.0.0.1", help="where to listen (127.0.0.1)")
    parser.add_argument("--port", type=int, default=8000, help="0 for any that is free (8000)")
    parser.add_argument("--url", help="where people reach the server, if that is elsewhere")
    parser.add_argument(
        "--allow-host",
        action="append",
        default=[],
        metavar="HOST",
        help="another name by which browsers may call the server, such as lab-pc.local; may be "
        "given again",
    )
    parser.set_defaults(run=serve)
    parser = add_action(
        actions, "account", "make an experimenter's account, or change its password", _EXAMPLES
    )
    parser.add_argument("name", help="1 to 40 of a to z, 0 to 9, - _ .")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--generate", action="store_true", help="draw a password and print it")
    what.add_argument("--remove", action="store_true", help="remove the account")
    parser.set_defaults(run=account)


def serve(args: argparse.Namespace) -> int:
    """Serve until Ctrl-C."""
    from nacreous.server import listening
    from nacreous.server.app import create_app
    from nacreous.server.worker import Worker
    from nacreous.study.running import Running

    url = None if args.url is None else listening.check_url(args.url)
    frozen, store = opened(args)
    with store, Worker(frozen.folder, _place(args)) as worker:
        hosts = [*args.allow_host, *listening.named(args.host)]
        app = create_app(Running(store, frozen), url=url, worker=worker, hosts=hosts)
        with listening.listen(args.host, args.port) as listener, listening.until_stopped():
            address = listening.address_of(listener)
            for line in _told(args.study, frozen, store, address, url):
                say(f"{args.study}: {line}")
            listening.serve(app, listener)
    return 0


def account(args: argparse.Namespace) -> int:
    """Make, change or remove an account."""
    _, store = opened(args)
    with store:
        if args.remove:
            store.remove_account(args.name, who())
            say(f"{args.name}: removed; logins under this name are over")
            return 0
        password = _password(args)
        store.set_password(args.name, password, who())
    drawn = f"; password: {password}" if args.generate else ""
    say(f"{args.name}: may log in{drawn}")
    return 0


def add_action(
    actions: Actions[argparse.ArgumentParser], name: str, does: str, examples: str
) -> argparse.ArgumentParser:
    """An action on a frozen study and the store of its answers."""
    parser = actions.add_parser(
        name,
        help=does,
        description=f"{does[0].upper()}{does[1:]}.",
        epilog=examples,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("study", help="the folder of a frozen study")
    parser.add_argument(
        "--store",
        help="where its answers are: a file, or postgresql://... (what NACREOUS_STORE says; else "
        "answers.sqlite in the folder)",
    )
    return parser


def opened(args: argparse.Namespace) -> tuple[Frozen, Store]:
    """The study and its store, both to be used now; a new store elsewhere is told."""
    from nacreous.study.design import open_frozen
    from nacreous.study.store import Store

    frozen, place = open_frozen(args.study), _place(args)
    is_new = "://" not in place and place != args.study and not Path(place).exists()
    store = Store.open(place)
    if is_new:  # the name may be mistyped; beside the links that a program may read
        say(f"{store.place}: a new store, with no answers yet", outputs=["-"])
    return frozen, store


def _place(args: argparse.Namespace) -> str:
    """Where the answers are."""
    from nacreous.study.store.engine import VARIABLE

    return args.store or os.environ.get(VARIABLE) or args.study


def _told(study: str, frozen: Frozen, store: Store, address: str, url: str | None) -> list[str]:
    """What whoever starts a server wants to know."""
    lines = [
        f"study {frozen.design.name}, hash {frozen.study_hash[:12]}; answers in {store.place}",
        f"serving at {address}/",
        f"experimenters: {address}/lab",
    ]
    if url is not None:
        lines.append(f"people reach it at {url}/")
    if not store.accounts():
        lines.append(
            f"there is no account yet, so nobody can log in:   nacreous study account {study} NAME"
        )
    if store.registration(frozen.study_hash) == "invited":
        lines.append("only invited people may enter; experimenters invite them, or let anybody in")
    return lines


def _password(args: argparse.Namespace) -> str:
    """Drawn, asked for twice, or one line of what is piped in."""
    import secrets
    from getpass import getpass

    from nacreous.problem import InputError

    if args.generate:
        return secrets.token_urlsafe(15)
    if sys.stdin is None or not sys.stdin.isatty():
        return sys.stdin.readline().rstrip("\r\n") if sys.stdin is not None else ""
    password = getpass(f"new password for {args.name}: ")
    if getpass("the same again: ") != password:
        raise InputError("the two passwords differ; nothing was changed")
    return password
