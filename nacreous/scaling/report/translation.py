"""The report's texts in one language, and the way values are put into them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from functools import cache
from html import escape
from pathlib import Path
from unicodedata import bidirectional

from nacreous import toml_text
from nacreous.printable import printable_lines
from nacreous.problem import InputError

__all__ = ["LANGUAGES", "Html", "Words"]

LANGUAGES = ("en", "ja")


class Html(str):
    """Text that is HTML already; every other text is escaped before it enters a page."""

    __slots__ = ()


def markup(value: object) -> Html:
    """The value as HTML, without control characters.

    >>> markup("<b>"), markup(Html("<b>"))
    ('&lt;b&gt;', '<b>')
    """
    return value if isinstance(value, Html) else Html(escape(printable_lines(str(value))))


def language_of(label: object, japanese: bool = False) -> str:
    """The attribute that gives a label the glyphs of its language, "" for other scripts.

    A browser picks glyphs by language where languages share characters: without one, Japanese
    labels on an English page may get Chinese glyphs. Kana and characters that only Japan writes are
    Japanese, those that only China or Taiwan writes Chinese, Hangul Korean. Labels of characters
    that both write, such as 真珠, have none: a wrong one would force the other's glyphs on them,
    and without one they have those of the page's language, or on an English page the reader's own.
    japanese: what stands around the label is Japanese, and so are such labels.

    >>> language_of("光沢 1"), language_of("骨头"), language_of("진주"), language_of("真珠")
    (' lang="ja"', ' lang="zh-Hans"', ' lang="ko"', '')
    >>> language_of("真珠", japanese=True)
    ' lang="ja"'
    """
    text = str(label)
    if re.search("[\uac00-\ud7af\u1100-\u11ff]", text):
        return ' lang="ko"'
    if re.search("[\u3005-\u3007\u3040-\u30ff\uff66-\uff9f]", text):
        return ' lang="ja"'
    han = re.findall("[\u3400-\u4dbf\u4e00-\u9fff\uf900-\ufaff]", text)
    where = [tuple(_is_in(each, codec) for codec in _REPERTOIRES) for each in han]
    if (True, False, False) in where:
        return ' lang="ja"'
    if any(china and not japan for japan, china, _ in where):
        return ' lang="zh-Hans"'
    if (False, False, True) in where:
        return ' lang="zh-Hant"'
    return ' lang="ja"' if han and japanese else ""


def is_japanese(texts: Iterable[str]) -> bool:
    """Whether some of the texts are Japanese for sure, and none is Chinese.

    >>> is_japanese(["どちらが？", "真珠"]), is_japanese(["真珠"])
    (True, False)
    >>> is_japanese(["どちらが？", "骨头"])
    False
    """
    found = {language_of(text) for text in texts}
    return ' lang="ja"' in found and not any("zh" in each for each in found)


#: What Japan, China and Taiwan write day by day: JIS X 0208, GB 2312, Big5.
_REPERTOIRES = ("shift_jis", "gb2312", "big5")


def _is_in(letter: str, codec: str) -> bool:
    return letter.encode(codec, "ignore") != b""


def direction_of(label: object) -> str:
    """The attribute that sets a label apart that is read from right to left, "" for others.

    Without it the order of labels in a row, and of signs between them, would turn.

    >>> direction_of("שלום"), direction_of("pearl 1")
    (' dir="auto"', '')
    """
    return ' dir="auto"' if _turns(str(label)) else ""


def apart(value: object) -> Html:
    """The value as HTML without marks, set apart where it is read from right to left.

    For text that can hold no element: titles, attributes, and what is not known to be a label.

    >>> apart("a < b"), len(apart("שלום"))
    ('a &lt; b', 6)
    """
    text = markup(value)
    if isinstance(value, Html) or not _turns(text):
        return text
    return Html(f"\N{FIRST STRONG ISOLATE}{text}\N{POP DIRECTIONAL ISOLATE}")


def _turns(text: str) -> bool:
    return any(bidirectional(letter) in ("R", "AL") for letter in text)


class Words:
    """All texts of one language, by their keys in en.toml or ja.toml.

    >>> Words("ja")("scale.title")
    '尺度'
    """

    def __init__(self, language: str, japanese: bool = False) -> None:
        """japanese: the labels come with Japanese, so that those of kanji alone are Japanese."""
        if language not in LANGUAGES:
            raise InputError(f"language is {language!r}; allowed: {', '.join(LANGUAGES)}")
        self.language, self.japanese = language, japanese
        self._texts = texts(language)

    def __call__(self, key: str, **values: object) -> Html:
        """The text of a key as HTML, with the values in their places."""
        safe = {name: apart(value) for name, value in values.items()}
        return Html(escape(self._texts[key], quote=False).format(**safe))

    def plain(self, key: str) -> str:
        """The text of a key that has no places, for a drawing."""
        return self._texts[key]

    def question(self, asked: str | None, example: bool) -> str | None:
        """The question as it was put; the paper's own where the data are its."""
        return self._texts["paper.question"] if asked is None and example else asked

    def quoted(self, text: str) -> Html:
        """A question as it was put, in the glyphs and the direction of its language."""
        look = language_of(text, self.japanese) + direction_of(text)
        return Html(f"<span{look}>{markup(text)}</span>") if look else markup(text)

    def count(self, noun: str, number: float) -> Html:
        """A number with its noun: "1 person", "2 people".

        >>> Words("en").count("person", 1)
        '1 person'
        """
        form = "one" if number == 1 else "many"
        return self(f"count.{noun}.{form}", n=thousands(number))

    def name(self, label: object) -> Html:
        """A stimulus, a person or a group, set so that it stands out of the sentence."""
        look = language_of(label, self.japanese) + direction_of(label)
        return Html(f'<b class="name"{look}>{markup(str(label))}</b>')

    def listed(self, items: Sequence[object], most: int = 30) -> Html:
        """Items in a row: "a, b and c"; beyond `most` the rest is only counted."""
        shown = [markup(item) for item in items[:most]]
        if len(items) > most:
            shown.append(self("list.more", n=len(items) - most))
        if len(shown) < 2:
            return Html("".join(shown))
        comma, last = self("list.comma"), self("list.last")
        return Html(comma.join(shown[:-1]) + last + shown[-1])

    def row(self, labels: Sequence[object]) -> Html:
        """Stimuli in their order, without an "and"; only the ends of a long row."""
        named = [self.name(label) for label in labels]
        if len(named) > 30:
            named = [*named[:12], Html("…"), *named[-12:]]
        return Html(self("list.comma").join(named))

    def both(self, first: object, second: object) -> Html:
        """Two stimuli as a pair."""
        return self("list.both", first=self.name(first), second=self.name(second))

    def sentences(self, *said: Html) -> Html:
        """Sentences one after another."""
        return Html(self("list.space").join(said))

    def span(self, low: float | None, high: float | None) -> Html:
        """An interval; None for an end that it has not."""
        if low is None and high is None:
            return self("list.span_open")
        if low is None or high is None:
            key = "span_down" if low is None else "span_up"
            return self(f"list.{key}", end=number(low if high is None else high))  # type: ignore[arg-type]
        return self("list.span", low=number(low), high=number(high))

    def chain(self, labels: Sequence[object]) -> Html:
        """Stimuli that follow each other down the scale."""
        return Html(self("list.chain").join(self.name(label) for label in labels))

    def equals(self, p: str) -> Html:
        """A p value after the letter p: "= 0.03" or "< 0.001"."""
        return markup(p if p.startswith("<") else f"= {p}")

    def risk(self, level: float) -> str:
        """Of 100 studies, in how many a verdict at this level may be false."""
        return f"{100 * (1 - level):.3g}"

    def unit(self, unit: str) -> str:
        """What stands under an axis."""
        return self._texts[f"scale.unit.{unit.rstrip(chr(39))}"]

    def alt(self, key: str, **values: object) -> Html:
        """What a drawing shows, for an attribute."""
        safe = {name: apart(value) for name, value in values.items()}
        return Html(escape(self._texts[key]).format(**safe))

    def paragraph(self, key: str, **values: object) -> Html:
        """A text as a paragraph."""
        return Html(f"<p>{self(key, **values)}</p>\n")

    def names(self, labels: Sequence[object], most: int = 30) -> Html:
        """Stimuli in a row."""
        return self.listed([self.name(label) for label in labels], most)


@cache
def texts(language: str) -> dict[str, str]:
    """The texts of a language by dotted key."""
    content = Path(__file__).with_name(f"{language}.toml").read_text(encoding="utf-8")
    # Where a text goes on in a new line, English has a space and Japanese nothing.
    joint = "" if language == "ja" else " "
    return {
        key: joint.join(text.split("\n")) for key, text in toml_text.flat(toml_text.loads(content))
    }


def number(value: float, digits: int = 2, sign: bool = False) -> str:
    """A number with so many decimals and a true minus sign; never minus nothing.

    >>> number(-0.001), number(-1.5), number(0.25, sign=True)
    ('0.00', '−1.50', '+0.25')
    """
    text = f"{abs(value):.{digits}f}"
    if float(text) == 0:
        return text
    return ("\N{MINUS SIGN}" if value < 0 else "+" if sign else "") + text


def thousands(value: float) -> str:
    """A count; fractions, which reconstructed counts have, with two decimals.

    >>> thousands(2184.0), thousands(24.96)
    ('2184', '24.96')
    """
    whole = round(value)
    if abs(value - whole) > 1e-6:
        return f"{value:.2f}".rstrip("0")
    return str(whole) if whole < 10_000 else f"{whole:,}".replace(",", "\N{NARROW NO-BREAK SPACE}")


def chance(p_value: float) -> str:
    """A p value, with two digits that mean something.

    >>> chance(0.0312), chance(1e-9)
    ('0.031', '< 0.001')
    """
    if p_value < 0.001:
        return "< 0.001"
    return f"{p_value:.3f}" if p_value < 0.1 else f"{p_value:.2f}"


def percent(share: float) -> str:
    """A share out of 100 people, never 0 or 100 unless it is.

    >>> percent(0.874), percent(0.9996), percent(1.0)
    ('87', '> 99', '100')
    """
    rounded = round(100 * share)
    if rounded == 100 and share < 1:
        return "> 99"
    if rounded == 0 and share > 0:
        return "< 1"
    return str(rounded)
