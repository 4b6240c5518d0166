"""The report: one page that needs nothing else, the same in two languages and for the same seed."""

from __future__ import annotations

import re
from html import unescape
from html.parser import HTMLParser
from pathlib import Path
from string import Formatter

import pytest

import nacreous as nc
from nacreous.scaling import report
from nacreous.scaling.report.translation import (
    LANGUAGES,
    Html,
    Words,
    number,
    percent,
    texts,
)
from tests.scaling.report_answers import SPITEFUL


class Page(HTMLParser):
    """Elements, attributes and words of a page; fails where an element is closed wrongly."""

    EMPTY = frozenset({"meta", "br", "hr", "img"})

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open, self.tags, self.links, self.ids, self.words = [], [], [], [], []
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        if tag not in self.EMPTY:
            self.open.append(tag)
        self._note(attributes)

    def handle_startendtag(self, tag, attributes):
        self.tags.append(tag)
        self._note(attributes)

    def _note(self, attributes):
        for name, value in attributes:
            assert not name.startswith("on")
            if name in ("src", "href", "xlink:href", "action", "data", "poster", "srcset"):
                self.links.append(value)
            if name == "id":
                self.ids.append(value)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if "style" not in self.open[-1:]:
            self.words.append(data)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("which", ["paper", "answered"])
def test_the_page_needs_nothing_else(request, which, language):
    page = Page(request.getfixturevalue(which).text("a.html", language))
    for link in page.links:
        assert link.startswith(("#", "data:"))
    assert not {"script", "link", "iframe", "object", "embed", "form", "base"} & set(page.tags)
    style = request.getfixturevalue(which).text("a.html", language).split("</style>")[0]
    assert "@import" not in style
    assert "url(" not in style


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_mark_is_unique_and_every_link_inside_leads_somewhere(answered, language):
    text = answered.text("a.html", language)
    page = Page(text)
    assert len(page.ids) == len(set(page.ids))
    targets = {link[1:] for link in page.links if link.startswith("#")}
    targets |= set(re.findall(r"url\(#([^)]+)\)", text))
    assert targets <= set(page.ids)


@pytest.mark.parametrize("language", LANGUAGES)
def test_labels_are_escaped_wherever_they_stand(answered, language):
    text = answered.text("a.html", language)
    for spite in ("<script", "<b>&", "真珠 <b>", "<south>", "<i>"):
        assert spite not in text
    words = "".join(Page(text).words)
    for label in SPITEFUL:
        assert label in words


def test_both_languages_have_the_same_texts_with_the_same_places():
    english, japanese = (texts(language) for language in LANGUAGES)
    assert english.keys() == japanese.keys()
    for key, text in english.items():
        places = [
            sorted(name for _, name, _, _ in Formatter().parse(each) if name)
            for each in (text, japanese[key])
        ]
        # A language may leave a place out, as Japanese does with a space, but not make one up.
        assert set(places[1]) <= set(places[0]), key


def test_every_text_is_used():
    code = "".join(path.read_text() for path in Path(report.__file__).parent.rglob("*.py"))
    # Texts of which the code makes the last words of the key from what it found.
    made = re.compile(
        r"(count|list|short|fit|neighbours)\.|method\.(probit|logit|data)|groups\.(method|few|unplaced)"
        r"|consistency\.side|people\.not_compared|screen\.|scale\.(unit|doubt|average|unplaced)|.*\.title$"
    )
    unused = [key for key in texts("en") if not made.match(key) and key not in code]
    assert unused == []


def numbers(text: str) -> list[str]:
    """All numbers that a reader sees, without the drawings and the data."""
    text = re.sub(
        r"<style.*?</style>|<svg.*?</svg>|<code>.*?</code>|<ol.*?</ol>", "", text, flags=re.S
    )
    text = re.sub(r"<[^>]+>", " ", text)
    return re.findall(r"[−+]?\d+\.\d+", unescape(text))


@pytest.mark.parametrize("which", ["paper", "answered"])
def test_both_languages_say_the_same_numbers(request, which):
    study = request.getfixturevalue(which)
    english, japanese = (numbers(study.text("a.html", language)) for language in LANGUAGES)
    assert sorted(english) == sorted(japanese)
    assert len(english) > 30


def test_the_same_seed_gives_the_same_bytes_and_another_seed_others(paper):
    again = nc.scaling.analyse(nc.scaling.paper(), example=True, bootstrap=200)
    other = nc.scaling.analyse(nc.scaling.paper(), example=True, bootstrap=200, seed=2)
    for ending in ("a.html", "a.csv", "a.json"):
        assert paper.text(ending) == again.text(ending)
        assert paper.text(ending) != other.text(ending)


def test_numbers_are_set_with_a_true_minus_and_never_minus_nothing():
    assert number(-0.004) == "0.00"
    assert number(-1.234) == "−1.23"
    assert percent(0.0001) == "< 1"
    assert percent(0.0) == "0"


def test_values_are_escaped_and_html_is_not():
    words = Words("en")
    assert "&lt;b&gt;" in words("page.asked", question="<b>")
    assert "<b>" in words("page.asked", question=Html("<b>"))


@pytest.mark.parametrize(
    ("asked", "message"),
    [
        ({"level": 95}, "level is 95; allowed: 0.5 to 0.9999"),
        ({"bootstrap": 5}, "bootstrap is 5; allowed: 0, or 100 to 100000"),
        ({"seed": -1}, "seed is -1; allowed: a whole number, 0 to"),
        ({"model": "cauchy"}, "model is 'cauchy'; allowed: probit, logit"),
        (
            {"method": "guess"},
            "method is 'guess'; allowed: maximum-likelihood, bias-reduced, least-squares",
        ),
        ({"method": "least-squares", "model": "logit"}, "method is 'least-squares'; allowed: with"),
        ({"unit": "inch"}, "unit is 'inch'; allowed: z"),
        ({"group": "room"}, "group is 'room'; allowed: none, for the data are counts"),
        ({"colour": 1}, "colour is no setting; allowed: bootstrap"),
    ],
    ids=str,
)
def test_bad_settings_are_refused(asked, message):
    with pytest.raises(nc.InputError, match=re.escape(message)):
        nc.scaling.analyse(nc.scaling.paper(), **asked)


def test_what_cannot_be_written_is_refused_and_leaves_no_file(tmp_path, paper):
    with pytest.raises(nc.InputError, match=r"the ending is \.pdf; allowed: \.html, \.csv, \.json"):
        paper.save(tmp_path / "a.pdf")
    with pytest.raises(nc.InputError, match="language is 'de'; allowed: en, ja"):
        paper.save(tmp_path / "a.html", language="de")
    assert not list(tmp_path.iterdir())
