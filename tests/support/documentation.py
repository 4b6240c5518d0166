"""Runs what the documentation shows: Python blocks as doctests, console blocks as commands."""

import doctest
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

COMMAND = Path(sys.executable).with_name("nacreous")


class Block(NamedTuple):
    """One fenced block: its language, its text and the number of the text's first line."""

    language: str
    text: str
    line: int


class Call(NamedTuple):
    """One command of a console block, the output shown under it, and its line number."""

    words: list[str]
    shown: str
    line: int


class DocumentationError(AssertionError):
    """The documentation shows something that does not happen."""


def blocks(document: Path) -> Iterator[Block]:
    """The fenced blocks of a Markdown document, in reading order."""
    fenced = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
    text = document.read_text(encoding="utf-8")
    for match in fenced.finditer(text):
        yield Block(match[1], match[2], text.count("\n", 0, match.start(2)) + 1)


def calls(block: Block) -> Iterator[Call]:
    """The calls of `nacreous` in a console block; other commands are the reader's business."""
    shown_calls = re.compile(r"^\$ ((?:.*\\\n)*.*\n)((?:(?!\$ ).*\n)*)", re.MULTILINE)
    for match in shown_calls.finditer(block.text):
        words = shlex.split(match[1].replace("\\\n", " "))
        if words[:1] == ["nacreous"]:
            line = block.line + block.text.count("\n", 0, match.start())
            yield Call(words, match[2].rstrip("\n"), line)


def run_document(document: Path, folder: Path) -> None:
    """Run all blocks of a document in one folder and one Python namespace, as a reader would."""
    namespace: dict[str, object] = {"__name__": "__main__"}
    for block in blocks(document):
        if block.language == "python":
            run_python(block, document, namespace)
        elif block.language == "console":
            for call in calls(block):
                run_call(call, document, folder)


def run_python(block: Block, document: Path, namespace: dict[str, object]) -> None:
    """Run a block with prompts as a doctest, one without as a script."""
    if ">>> " not in block.text:
        exec(compile("\n" * (block.line - 1) + block.text, document, "exec"), namespace)
        return
    shown = doctest.DocTestParser().get_doctest(
        block.text, namespace, document.name, str(document), block.line - 1
    )
    report: list[str] = []
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    runner.run(shown, out=report.append, clear_globs=False)
    namespace.update(shown.globs)
    if report:
        raise DocumentationError("".join(report))


def run_call(call: Call, document: Path, folder: Path) -> None:
    """Run one command; it must end well, and say what is shown if anything is shown."""
    done = subprocess.run(
        [COMMAND, *call.words[1:]],
        cwd=folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
    place = f"{document}:{call.line}: $ {shlex.join(call.words)}"
    if done.returncode != 0:
        raise DocumentationError(f"{place}\nended with code {done.returncode}:\n{done.stdout}")
    if not call.shown:
        return
    shown = doctest.Example("", call.shown)
    checker = doctest.OutputChecker()
    if not checker.check_output(shown.want, done.stdout, doctest.ELLIPSIS):
        difference = checker.output_difference(shown, done.stdout, doctest.ELLIPSIS)
        raise DocumentationError(f"{place}\n{difference}")
