"""The [completion] of a study: what people are told, and where they go, when they have finished."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from typing import Annotated
from urllib.parse import quote, urlsplit

from pydantic import AfterValidator, Field

from nacreous.spec.complaint import Contradiction, shown
from nacreous.spec.key import key
from nacreous.spec.section import Section

#: The field of a return address for the completion code.
CODE = "CODE"
_FIELD = re.compile("[{]([^{}]*)[}]")
_ADDRESS = "an https address, with fields such as {PROLIFIC_PID} and {CODE} behind the host"


def _https(address: str) -> str:
    """An address whose host nobody's parameter can change."""
    host = urlsplit(_FIELD.sub("", address)).netloc
    written = re.fullmatch("https://([A-Za-z0-9.-]+(:[0-9]{1,5})?)([/?#][!-~]*)?", address)
    if written is None or written[1] != host or re.search("[{}]", _FIELD.sub("", address)):
        raise ValueError("no https address")
    return address


class Completion(Section):
    """What whoever has answered everything is given.

    >>> address = "https://platform.example/done?cc={CODE}&id={PROLIFIC_PID}"
    >>> ours = Completion(code="C1X9", return_url=address)
    >>> ours.filled({"PROLIFIC_PID": "a b&c"}, "C1X9")
    'https://platform.example/done?cc=C1X9&id=a%20b%26c'
    """

    code: Annotated[str, Field(pattern="^[A-Za-z0-9_-]{1,40}$")] | None = key(
        None,
        "The completion code that everyone is told who has finished.",
        allowed="1 to 40 of A to Z, a to z, 0 to 9, - and _",
        left_out="no code, or one of each person's own",
        source="**(ours)**",
    )
    own_code: bool = key(
        False,
        "Whether everyone is told a code of their own, drawn by the server.",
        allowed="true or false",
        source="**(ours)**",
    )
    return_url: (
        Annotated[str, Field(min_length=9, max_length=2000), AfterValidator(_https)] | None
    ) = key(
        None,
        "Where people go back to who have finished.",
        allowed=_ADDRESS,
        left_out="nowhere",
        source="**(ours)**",
    )

    def contradictions(self) -> Iterator[Contradiction]:
        """Two kinds of codes."""
        if self.code is not None and self.own_code:
            verdict = f"is {shown(self.code)} while {{other}} is true; allowed: one of them"
            yield Contradiction("code", verdict, "own_code")

    def unknown(self, parameters: Collection[str]) -> Iterator[Contradiction]:
        """Fields of the return address that nothing fills; the path is that of the whole file."""
        known = [*parameters, *([CODE] if self.code is not None or self.own_code else [])]
        for name in _FIELD.findall(self.return_url or ""):
            if name not in known:
                allowed = ", ".join(known) or "none, for nothing is kept and there is no code"
                verdict = f"has the field {shown(name)}; allowed: {allowed}"
                yield Contradiction("completion.return_url", verdict)

    def filled(self, parameters: Mapping[str, str], code: str | None) -> str | None:
        """The return address of a person, every value percent-encoded, what is missing empty."""
        if self.return_url is None:
            return None
        values = {**parameters, CODE: code or ""}
        return _FIELD.sub(lambda field: quote(values.get(field[1], ""), safe=""), self.return_url)
