"""README and docs hold; and a document that shows something wrong is found out."""

import os
from pathlib import Path

import pytest

from tests.support import documentation
from tests.support.documentation import DocumentationError, run_document

ROOT = Path(__file__).parent.parent.parent
DOCUMENTS = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")])


def name(path: Path) -> str:
    return str(path.relative_to(ROOT))


@pytest.mark.parametrize("document", DOCUMENTS, ids=name)
def test_documents_show_what_happens(document, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run_document(document, tmp_path)


@pytest.mark.parametrize("document", DOCUMENTS, ids=name)
def test_no_python_on_a_page_goes_by_a_name_that_is_not_run(document):
    languages = {block.language for block in documentation.blocks(document)}
    assert not languages & {"pycon", "py", "python3", "doctest"}


@pytest.fixture
def page(tmp_path, monkeypatch):
    """Writes a page whose first shown line is line 4, with an `echo` in place of nacreous."""
    echo = tmp_path / "nacreous"
    echo.write_text('#!/bin/sh\necho "$@"\nexit "${CODE:-0}"\n')
    echo.chmod(0o755)
    monkeypatch.setattr(documentation, "COMMAND", echo)

    def write(language: str, *lines: str) -> Path:
        document = tmp_path / "page.md"
        document.write_text("\n".join(["# Page", "", f"```{language}", *lines, "```", ""]))
        return document

    return write


def test_true_pages_pass(page, tmp_path):
    run_document(page("python", ">>> half = 1 / 2", ">>> half", "0.5"), tmp_path)
    run_document(page("python", "half = 1 / 2", "assert half == 0.5"), tmp_path)
    run_document(
        page("console", "$ git clone ...", "$ nacreous a \\", "    b", "a b", "", "$ "), tmp_path
    )
    run_document(page("console", "$ nacreous 12 layers", "... layers"), tmp_path)


def test_a_wrong_value_is_found_with_file_and_line(page, tmp_path):
    with pytest.raises(
        DocumentationError, match=r'(?s)page.md", line 5,.*Expected:\s+0.6\s+Got:\s+0.5'
    ):
        run_document(page("python", ">>> half = 1 / 2", ">>> half", "0.6"), tmp_path)


def test_a_failing_script_is_found_with_its_line(page, tmp_path):
    with pytest.raises(AssertionError) as failure:
        run_document(page("python", "half = 1 / 2", "assert half == 0.6"), tmp_path)
    assert failure.traceback[-1].lineno + 1 == 5


def test_a_wrong_output_is_found_with_file_and_line(page, tmp_path):
    with pytest.raises(
        DocumentationError,
        match=r"(?s)page.md:5: \$ nacreous 13 layers.*Expected:\s+12 layers\s+Got:\s+13 layers",
    ):
        run_document(page("console", "$ nacreous 1", "$ nacreous 13 layers", "12 layers"), tmp_path)


def test_a_failing_command_is_found_with_its_code(page, tmp_path, monkeypatch):
    monkeypatch.setitem(os.environ, "CODE", "2")
    with pytest.raises(
        DocumentationError, match=r"page.md:4: \$ nacreous grow\nended with code 2:\ngrow"
    ):
        run_document(page("console", "$ nacreous grow"), tmp_path)
