"""The paper again: criteria that hold on our pictures, and the page that says so."""

from __future__ import annotations

import dataclasses
import json
import shlex
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nacreous import cli
from nacreous.paper import (
    cutting,
    figure_8,
    figure_9,
    make,
    pictures,
)
from nacreous.paper.measurement import Measurement
from nacreous.paper.pictures import Pictures
from tests.paper.tampering import SIZE_PX, failing


def test_a_criterion_is_judged_by_the_number_and_not_by_hope() -> None:
    assert Measurement("a", 1.0, least=1.0, most=1.0).holds is True
    assert Measurement("a", 1.0 + 1e-9, most=1.0).holds is False
    assert Measurement("a", 0.9, least=1.0).holds is False
    assert Measurement("a", float("nan"), least=0.0).holds is False
    assert Measurement("a", float("nan"), most=0.0).holds is False
    assert Measurement("a", 7.0).holds is None


def test_what_is_no_number_is_null_for_machines() -> None:
    record = Measurement("a", float("nan"), least=0.0).record()
    assert json.loads(json.dumps(record, allow_nan=False))["value"] is None


def test_every_criterion_holds_for_the_preset(out: Path) -> None:
    record = json.loads((out / "measurements.json").read_text(encoding="utf-8"))
    missed = [
        f"figure {shown['figure']}: {measured['quantity']} is {measured['value']}"
        for shown in record["figures"]
        for measured in shown["measurements"]
        if measured["holds"] is False
    ]
    assert missed == []
    assert (
        sum(measured["holds"] is True for s in record["figures"] for measured in s["measurements"])
        > 40
    )


def test_a_run_makes_these_files_and_no_others(out: Path) -> None:
    assert sorted(path.name for path in out.iterdir()) == sorted(make.FILES)
    numbers = ["8", "9", "10", "11", "12", "13", "14 (a)", "14 (b)", "14 (c)", "14 (d)", "2"]
    record = json.loads((out / "measurements.json").read_text(encoding="utf-8"))
    assert [shown["figure"] for shown in record["figures"]] == numbers
    named = {name for shown in record["figures"] for name in shown["files"]}
    assert named | {"index.html", "measurements.json"} == set(make.FILES)


class Page(HTMLParser):
    """What a page is made of."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.words = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        self.words += data

    def all(self, name: str) -> list[dict[str, str | None]]:
        return [attributes for tag, attributes in self.tags if tag == name]


def test_the_page_asks_for_nothing_but_itself(out: Path) -> None:
    text = (out / "index.html").read_text(encoding="utf-8")
    page = Page(text)
    for _, attributes in page.tags:
        for name in ("src", "href", "srcset", "action", "data"):
            link = attributes.get(name)
            assert link is None or link.startswith(("data:image/png;base64,", "#")), link
    assert page.all("script") == page.all("link") == page.all("iframe") == []
    style = text[text.index("<style>") : text.index("</style>")]
    assert "url(" not in style
    assert "@import" not in style


def test_the_page_holds_every_picture_with_its_words(out: Path) -> None:
    page = Page((out / "index.html").read_text(encoding="utf-8"))
    pictures_made = [name for name in make.FILES if name.endswith(".png")]
    shown = page.all("img")
    assert len(shown) == len(pictures_made)
    assert all((picture["alt"] or "").strip() for picture in shown)
    assert len({picture["src"] for picture in shown}) == len(pictures_made)
    anchors = {attributes["id"] for attributes in page.all("section")}
    assert {link["href"] for link in page.all("a")} <= {f"#{anchor}" for anchor in anchors}


def test_the_page_quotes_the_paper_in_both_languages(out: Path) -> None:
    page = Page((out / "index.html").read_text(encoding="utf-8"))
    assert page.all("html") == [{"lang": "en"}]
    assert page.all("meta")[0] == {"charset": "utf-8"}
    for words in (
        "The pearl of 1996",
        "干渉色は、視線方向にのみ依存し、光源方向には依存しない",
        "わずかな色変化であるが",
        "深み感",
        "Texture(V).",
        "procedural",
        "holds",
    ):
        assert words in page.words
    japanese = [attributes for tag, attributes in page.tags if attributes.get("lang") == "ja"]
    assert len(japanese) > 2 * 11
    versions = [f"numpy {np.__version__}", "nacreous 0."]
    assert all(version in page.words for version in versions)


def test_the_page_says_what_does_not_hold(out: Path, taken: Pictures, tmp_path: Path) -> None:
    flat = dataclasses.replace(taken, grained=taken.smooth)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(pictures, "take", lambda *_: flat)
        paper = make.make(tmp_path / "flat", SIZE_PX)
    page = Page((tmp_path / "flat" / "index.html").read_text(encoding="utf-8"))
    assert "does not hold" in page.words
    assert "All" not in page.words[page.words.index("criteria hold") - 12 :][:12]
    wrong = {shown.number for shown in paper.exhibits if failing(shown.measurements)}
    assert wrong == {"13", "14 (d)"}


def test_the_command_of_figure_14_makes_the_same_bytes(
    out: Path, tmp_path: Path, monkeypatch: Any, capsys: Any
) -> None:
    monkeypatch.chdir(tmp_path)
    record = json.loads((out / "measurements.json").read_text(encoding="utf-8"))
    for shown in record["figures"]:
        if shown["figure"] in ("14 (b)", "14 (d)"):
            assert cli.main(shlex.split(shown["command"])[1:]) == 0
            name = shown["files"][0]
            assert (tmp_path / name).read_bytes() == (out / name).read_bytes()
    capsys.readouterr()


def test_diagrams_are_the_same_bytes_each_time(out: Path, tmp_path: Path, taken: Pictures) -> None:
    figure_8.exhibit(tmp_path)
    figure_9.exhibit(tmp_path, taken)
    for name in (*figure_8.FILES, *figure_9.FILES):
        assert (tmp_path / name).read_bytes() == (out / name).read_bytes()


def test_crops_of_the_finished_picture_are_those_of_figure_2(out: Path, tmp_path: Path) -> None:
    cuts = cutting.cut_file(out / "figure-14d.png", tmp_path / "crops")
    assert cuts.found == "from the recipe in the file"
    for cut in cuts.crops:
        ours = (out / f"figure-2-crop-{cut.number}.png").read_bytes()
        assert (tmp_path / "crops" / f"crop-{cut.number}.png").read_bytes() == ours
