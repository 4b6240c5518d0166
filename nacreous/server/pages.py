"""The built pages: read once, and nothing else can be asked for."""

from __future__ import annotations

import mimetypes
from pathlib import Path

from fastapi import APIRouter
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response

from nacreous.problem import InputError
from nacreous.server.built import cure

#: Where the pages are built.
FOLDER = Path(__file__).parent / "pages"

#: The pages themselves, by what people ask for.
_PAGES = {"/": "index.html", "/lab": "lab.html", "/lab/": "lab.html"}
_READING = ["GET", "HEAD"]
_FOR_EVER = "public, max-age=31536000, immutable"

router = APIRouter(include_in_schema=False)


class Pages:
    """Every file of the built pages, in memory, by its path."""

    def __init__(self, folder: Path) -> None:
        self._files = {
            path.relative_to(folder).as_posix(): path.read_bytes()
            for path in folder.rglob("*")
            if path.is_file()
        }
        missing = [name for name in _PAGES.values() if name not in self._files]
        if missing:
            raise InputError(
                f"the study's pages are missing ({folder / missing[0]} does not exist): "
                f"{cure('pages')}"
            )

    def page(self, path: str) -> Response:
        """A page, asked for anew each time, for its assets' names may have changed."""
        return self._response(_PAGES[path], "no-cache")

    def asset(self, name: str) -> Response:
        """A file whose name has its hash in it."""
        if f"assets/{name}" not in self._files:
            raise HTTPException(404)
        return self._response(f"assets/{name}", _FOR_EVER)

    def _response(self, name: str, kept: str) -> Response:
        kind = mimetypes.guess_type(name)[0] or "application/octet-stream"
        return Response(self._files[name], media_type=kind, headers={"Cache-Control": kept})


@router.api_route("/", methods=_READING)
@router.api_route("/lab", methods=_READING)
@router.api_route("/lab/", methods=_READING)
async def page(request: Request) -> Response:
    """The page of participants, or of experimenters."""
    pages: Pages = request.app.state.pages
    return pages.page(request.url.path)


@router.api_route("/assets/{name:path}", methods=_READING)
async def asset(request: Request, name: str) -> Response:
    """What a page needs."""
    pages: Pages = request.app.state.pages
    return pages.asset(name)
