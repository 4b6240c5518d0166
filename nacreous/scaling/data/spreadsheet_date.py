"""Labels that a spreadsheet made dates of: `1-3` is shown as `3-Jan` there, and saved so."""

from __future__ import annotations

import re
from collections.abc import Iterable

_MONTH = (
    r"(?:jan|feb|mar|apr|may|jun|jul|aug|sep|sept|oct|nov|dec"
    r"|mrz|mär|mai|okt|dez|janv|févr|mars|avr|juin|juil|août|déc)\.?"
)
#: As spreadsheets write a date that was typed as `1-3`, `1/3` or `2-1`.
_DATE = re.compile(
    rf"[0-9]{{1,2}}[-. ]{{1,2}}{_MONTH}(?:[- ](?:[0-9]{{4}}|[0-9]{{2}}))?|{_MONTH}[- ][0-9]{{2}}"
    r"|(?:19|20)[0-9]{2}[-/.][0-9]{1,2}[-/.][0-9]{1,2}(?:[ T]00:00(?::00)?)?"
    r"|[0-9]{1,2}[/.][0-9]{1,2}[/.](?:19|20)[0-9]{2}|(?:[0-9]{4}年)?[0-9]{1,2}月[0-9]{1,2}日",
    re.IGNORECASE,
)


def made_dates(labels: Iterable[str]) -> list[str]:
    """The labels that are written as dates, where others are not; none where all are, or none.

    >>> made_dates(["1-13", "3-Jan", "2026-01-04"]), made_dates(["2026-01-03", "2026-01-04"])
    (['3-Jan', '2026-01-04'], [])
    """
    known = list(labels)
    dates = [label for label in known if _DATE.fullmatch(label)]
    return dates if len(dates) < len(known) else []
