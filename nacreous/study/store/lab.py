"""What experimenters do with a store: accounts, logins, invitations, who may enter."""

from __future__ import annotations

from functools import partial
from typing import Any

from nacreous.number import whole_of
from nacreous.study.store import accounts, check, invitations, journal, passwords, studies, tokens
from nacreous.study.store.base import Base
from nacreous.study.store.record import Event, Invitation


class Lab(Base):
    """The experimenters' side of a store."""

    def registration(self, study: str) -> str:
        """Who may enter: anybody ("open"), or who is "invited", as at first."""
        with self.reading() as connection:
            return studies.registration(connection, study)

    def set_registration(self, study: str, value: str, who: str) -> None:
        """Say who may enter: "open" or "invited"."""
        at = self._at()
        self._do(partial(studies.set_registration, at=at, study=study, value=value, who=who))

    def invite(self, study: str, count: int, label: str, who: str) -> list[str]:
        """Make invitations, 1 to 1000, and give their tokens, told only here.

        label: whom or what they are for, as experimenters call it. Each lets one person in, whose
        own token it then is.

        >>> from tempfile import TemporaryDirectory
        >>> from nacreous.study.store import Store
        >>> with TemporaryDirectory() as folder, Store.open(folder) as store:
        ...     study = store.add_study({"design_hash": "ab" * 32})
        ...     [token] = store.invite(study, 1, "Monday, seat 3", "lab")
        ...     session, _ = store.enter(study, "en", {}, token)
        ...     [invitation] = store.invitations(study)
        ...     invitation.label, invitation.number
        ('Monday, seat 3', 0)
        """
        count = whole_of("count", count, 1, invitations.MOST)
        drawn = [tokens.draw() for _ in range(count)]
        work = partial(
            invitations.make,
            at=self._at(),
            study=study,
            label=check.text("label", label, 200),
            hashes=[tokens.hash_of(token) for token in drawn],
            who=who,
        )
        self._do(work)
        return drawn

    def invitations(self, study: str) -> list[Invitation]:
        """A study's invitations, in the order in which they were made."""
        with self.reading() as connection:
            return invitations.of_study(connection, study)

    def revoke_invitation(self, invitation: int, who: str) -> None:
        """Let nobody enter by an invitation any more; one that was used is refused (`revoke`)."""
        self._do(partial(invitations.revoke, at=self._at(), invitation=invitation, who=who))

    def set_password(self, name: str, password: str, who: str) -> None:
        """Make an account, or give it another password, which ends its logins.

        name: 1 to 40 of a to z, 0 to 9, - _ . ; password: 12 to 200 characters.
        """
        name, kept = accounts.name_of(name), passwords.hashed(password)
        at = self._at()
        self._do(partial(accounts.set_password, at=at, name=name, password=kept, who=who))

    def remove_account(self, name: str, who: str) -> None:
        """Remove an account and end its logins."""
        self._do(partial(accounts.remove, at=self._at(), name=accounts.name_of(name), who=who))

    def accounts(self) -> list[str]:
        """The names of all accounts, sorted."""
        with self.reading() as connection:
            return accounts.names(connection)

    def login(self, name: str, password: str) -> str:
        """The token of a new login, told only here; it lasts 12 h, or 2 h unused.

        Raises `UnknownToken` where either is wrong, and takes as long whether or not there is such
        an account.

        >>> from tempfile import TemporaryDirectory
        >>> from nacreous.study.store import Store
        >>> with TemporaryDirectory() as folder, Store.open(folder) as store:
        ...     store.set_password("lab", "correct horse battery", "me")
        ...     token = store.login("lab", "correct horse battery")
        ...     store.login_of(token)
        'lab'
        """
        with self.reading() as connection:
            kept = accounts.kept_password(connection, name)
        # Here and not in a transaction: it takes long on purpose, and answers must not wait for it.
        good = passwords.matches(kept, password)
        if kept is None or not good:
            raise accounts.wrong()
        token = tokens.draw()
        now = self._clock()
        self._do(partial(accounts.log_in, now=now, name=name, kept=kept, token=token))
        return token

    def login_of(self, token: str) -> str:
        """Whose login this is; raises `UnknownToken` once it is over."""
        hashed = tokens.hash_of(token)
        with self.reading() as connection:
            name, due = accounts.login(connection, self._clock(), hashed)
        if due:
            self._do(partial(accounts.touch, at=self._at(), hashed=hashed))
        return name

    def logout(self, token: str) -> None:
        """End a login; nothing happens where it is over already."""
        self._do(partial(accounts.log_out, at=self._at(), hashed=tokens.hash_of(token)))

    def audit(
        self,
        who: str,
        what: str,
        study: str | None = None,
        session: str | None = None,
        **detail: Any,
    ) -> None:
        """Add a line to the audit log."""
        at = self._at()
        self._do(
            lambda connection: journal.note(connection, at, who, what, study, session, **detail)
        )

    def events(self, study: str | None = None, last: int | None = None) -> list[Event]:
        """The audit log of a study, or all of it; only its `last` lines, if that is given."""
        with self.reading() as connection:
            return journal.events(connection, study, last)
