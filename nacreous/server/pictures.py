"""The pictures of a frozen study, by their hash, never by a name or a path that somebody gives."""

from __future__ import annotations

from starlette.responses import FileResponse

from nacreous.server.responses import PictureTold
from nacreous.study.design import Frozen

_FOR_EVER = {"Cache-Control": "private, max-age=31536000, immutable"}


class Pictures:
    """What there is, and how large; `of_label` is for the server alone."""

    def __init__(self, frozen: Frozen) -> None:
        self.of_label = {stimulus.label: stimulus.sha256 for stimulus in frozen.stimuli}
        self.sizes = {
            stimulus.sha256: PictureTold(
                width_px=stimulus.width_px,
                height_px=stimulus.height_px,
                width_mm=stimulus.width_mm,
            )
            for stimulus in frozen.stimuli
        }
        self._paths = {
            stimulus.sha256: frozen.folder / stimulus.file for stimulus in frozen.stimuli
        }

    def __contains__(self, sha256: object) -> bool:
        """Whether there is such a picture."""
        return sha256 in self._paths

    def response(self, sha256: str) -> FileResponse:
        """The picture, to be kept for ever: another one would have another hash."""
        return FileResponse(self._paths[sha256], media_type="image/png", headers=_FOR_EVER)
