"""`nacreous study open | pause | close | invite | invitations | revoke`: who may enter."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from nacreous.commands.study_serve import add_action, opened
from nacreous.commands.study_store import Actions, person_of, who
from nacreous.commands.terminal import say
from nacreous.printable import printable
from nacreous.problem import InputError

if TYPE_CHECKING:
    from nacreous.study.store import Store

_EXAMPLES = """\
examples:
  nacreous study open my-study --everyone       anybody with the address may enter
  nacreous study open my-study --invited        invited people alone, as at first
  nacreous study pause my-study                 nobody enters for now; who is in goes on
  nacreous study close my-study                 nobody enters any more
  nacreous study invite my-study 20 --label "Monday" --url https://pearls.example
  nacreous study invitations my-study           all of them, with their numbers
  nacreous study revoke my-study --invitation 3 nobody enters by it any more
  nacreous study revoke my-study --person 17    that person's own link is worthless for good

A server that runs heeds each at once.
"""


def add_actions(actions: Actions[argparse.ArgumentParser]) -> None:
    """Describe what an experimenter can do on the page, from the command line."""
    parser = add_action(actions, "open", "let people enter, anybody or who is invited", _EXAMPLES)
    whom = parser.add_mutually_exclusive_group()
    for mode, value, says in (
        ("everyone", "open", "anybody with the address may enter from now on"),
        ("invited", "invited", "invited people alone may enter from now on"),
    ):
        whom.add_argument(
            f"--{mode}", dest="registration", action="store_const", const=value, help=says
        )
    parser.set_defaults(run=open_study)
    does = "let nobody enter for now; who has entered goes on"
    add_action(actions, "pause", does, _EXAMPLES).set_defaults(run=pause)
    does = "let nobody enter any more; who has entered may end"
    add_action(actions, "close", does, _EXAMPLES).set_defaults(run=close)
    parser = add_action(actions, "invite", "make links, each for one person", _EXAMPLES)
    parser.add_argument("count", type=int, help="how many, 1 to 1000")
    parser.add_argument("--label", required=True, help="whom or what they are for")
    parser.add_argument(
        "--url",
        default="http://127.0.0.1:8000",
        help="where people reach the server (http://127.0.0.1:8000)",
    )
    parser.set_defaults(run=invite)
    does = "list the invitations, without their links, which were told once"
    add_action(actions, "invitations", does, _EXAMPLES).set_defaults(run=invitations)
    parser = add_action(actions, "revoke", "make an invitation or a link worthless", _EXAMPLES)
    which = parser.add_mutually_exclusive_group(required=True)
    which.add_argument("--invitation", type=int, metavar="NUMBER", help="one that nobody has used")
    which.add_argument("--person", type=int, metavar="NUMBER", help="whose own link, from 0")
    parser.set_defaults(run=revoke)


def open_study(args: argparse.Namespace) -> int:
    """Let people enter, and say whom."""
    with _study(args) as (store, study):
        before = store.registration(study)
        if args.registration is not None:
            store.set_registration(study, args.registration, who())
        opened_now = store.reopen(study, who())
        say(_told(args, store, study, opened_now or store.registration(study) != before))
    return 0


def pause(args: argparse.Namespace) -> int:
    """Let nobody enter for now."""
    with _study(args) as (store, study):
        say(_told(args, store, study, store.pause(study, who())))
    return 0


def close(args: argparse.Namespace) -> int:
    """Let nobody enter any more."""
    with _study(args) as (store, study):
        say(_told(args, store, study, store.close_study(study, who())))
    return 0


def invite(args: argparse.Namespace) -> int:
    """Make invitations and print their links, which are told only here."""
    from nacreous.server.listening import check_url

    home = check_url(args.url)
    with _study(args) as (store, study):
        for token in store.invite(study, args.count, args.label, who()):
            say(f"{home}/#{token}")
    return 0


def invitations(args: argparse.Namespace) -> int:
    """Say of each invitation its number, whom it is for, and what became of it."""
    with _study(args) as (store, study):
        found = store.invitations(study)
    for one in found:
        state = "not used" if one.number is None else f"used by person {one.number}"
        say(f"{one.id}  {printable(one.label)}: {state if one.revoked_at is None else 'revoked'}")
    if not found:
        say(f"{args.study}: no invitations")
    return 0


def revoke(args: argparse.Namespace) -> int:
    """Let nobody in by an invitation, or by a person's own link, any more."""
    with _study(args) as (store, study):
        if args.person is not None:
            person = person_of(store, study, args.person)
            told = "revoked" if store.revoke(person.id, who()) else "has no link any more"
            say(f"person {args.person}: {told}; the link is worthless, the answers stay")
            return 0
        known = [one.id for one in store.invitations(study)]
        if args.invitation not in known:
            raise InputError(
                f"invitation is {args.invitation}; allowed: those that "
                f"`nacreous study invitations {args.study}` lists"
            )
        store.revoke_invitation(args.invitation, who())
        say(f"invitation {args.invitation}: revoked; nobody enters by it any more")
    return 0


@contextmanager
def _study(args: argparse.Namespace) -> Iterator[tuple[Store, str]]:
    """The store with the study in it, which need not have been served yet."""
    frozen, store = opened(args)
    with store:
        yield store, store.add_study(frozen.manifest())


def _told(args: argparse.Namespace, store: Store, study: str, changed: bool) -> str:
    """Who may enter now, and whether that was so already."""
    state = store.studies()[study]
    now = state if changed else f"{state} already"
    if state != "open":
        return f"{args.study}: {now}; nobody enters, and who has entered goes on"
    everyone = store.registration(study) == "open"
    whom = "anybody with the address" if everyone else "invited people alone"
    return f"{args.study}: {now}; {whom} may enter"
