"""Words for true and false as programs and spreadsheets of many languages write them."""

from __future__ import annotations

import re
from unicodedata import normalize

#: A tie besides, in words that nobody means otherwise; first those that `chosen` knows too.
TIED = frozenset({"tie", "ties", "tied", "draw", "drawn", "引き分け"})
_EQUAL = frozenset(
    {
        *("equal", "unentschieden", "gleich", "égalité", "égal", "nul", "empate", "igual"),
        *("pareggio", "uguale", "gelijk", "gelijkspel", "同じ", "平局", "무승부", "ничья"),
    }
)
#: What TRUE and "yes" are in spreadsheets and on questionnaires, and marks of a box: English,
#: German, French, Spanish, Italian, Portuguese, Dutch, the Nordic languages, Polish, Czech,
#: Hungarian, Romanian, Turkish, Russian, Japanese, Chinese, Korean.
_TRUE = frozenset(
    {
        *("1", "true", "t", "yes", "y", "on", "x", "✓", "✔", "☑"),
        *("wahr", "ja", "j", "vrai", "oui", "verdadero", "sí", "si", "s", "vero", "sì"),
        *("verdadeiro", "sim", "waar", "sand", "sandt", "sant", "sann", "tosi", "kyllä"),
        *("prawda", "tak", "pravda", "ano", "igaz", "igen", "adevărat", "da", "doğru", "evet"),
        *("истина", "да", "真", "はい", "是", "对", "對", "참", "예", "네"),
    }
)
_FALSE = frozenset(
    {
        *("0", "false", "f", "no", "n", "off"),
        *("falsch", "nein", "faux", "non", "falso", "não", "nao", "onwaar", "nee"),
        *("falsk", "nej", "usann", "nei", "epätosi", "ei", "fałsz", "nie", "nepravda", "ne"),
        *("hamis", "nem", "fals", "nu", "yanlış", "yanliş", "hayır", "hayir", "ложь", "нет"),
        *("偽", "いいえ", "假", "否", "不", "거짓", "아니요", "아니오"),
    }
)
#: No tie, in words that say nothing of anything else.
_DECIDED = frozenset({"win", "won"})


def plain_word(cell: str) -> str:
    """A word in small letters of one width, `1.0` as `1`: as words are compared.

    >>> plain_word("ＷＡＨＲ "), plain_word("1.00")
    ('wahr', '1')
    """
    word = normalize("NFC", normalize("NFKC", cell).strip().casefold())
    return re.sub(r"^([01])\.0*$", r"\1", word)


def says_true(cell: str) -> bool | None:
    """What a cell of a flag says; None where it says neither.

    >>> [says_true(cell) for cell in ("WAHR", "faux", "1.0", "いいえ", "tie")]
    [True, False, True, False, None]
    """
    word = plain_word(cell)
    return True if word in _TRUE else False if word in _FALSE else None


def says_tie(cell: str) -> bool | None:
    """Whether a cell of a column about ties says that there is one; None where it says neither.

    >>> [says_tie(cell) for cell in ("WAHR", "faux", "いいえ", "Draw", "2")]
    [True, False, False, True, None]
    """
    word = plain_word(cell)
    if word in TIED | _EQUAL:
        return True
    return False if word in _DECIDED else says_true(cell)


def names_tie(cell: str) -> bool:
    """Whether a word says that neither was chosen, wherever it stands.

    >>> names_tie("Unentschieden"), names_tie("yes")
    (True, False)
    """
    return plain_word(cell) in TIED | _EQUAL
