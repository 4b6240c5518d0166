"""A web host that knows nothing of the viewer's page."""

import functools
import http.server
import threading
from collections.abc import Iterator
from contextlib import contextmanager

from nacreous.viewer import FOLDER


class _Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *args: object) -> None:
        pass


@contextmanager
def hosted() -> Iterator[str]:
    """Serve the page that is built; gives its address."""
    handler = functools.partial(_Quiet, directory=str(FOLDER))
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}"
        server.shutdown()
