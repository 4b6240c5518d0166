"""PostgreSQL from Debian's package, started for the tests alone."""

import os
import pwd
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import psycopg
import pytest


@dataclass
class Server:
    """A running server; `folder` holds its data and its socket."""

    folder: Path
    binaries: Path
    user: str | None

    def url(self, name: str) -> str:
        return f"postgresql://nacreous@/{name}?host={self.folder}"

    def create(self, name: str) -> str:
        """The URL of a new, empty database."""
        with psycopg.connect(self.url("postgres"), autocommit=True) as connection:
            connection.execute(f"CREATE DATABASE {name}")
        return self.url(name)

    def emptied(self, name: str) -> str:
        """The URL of a database that holds nothing, whatever it held: a new one has 300 files."""
        with psycopg.connect(self.url("postgres"), autocommit=True) as connection:
            named = connection.execute("SELECT 1 FROM pg_database WHERE datname = %s", (name,))
            if named.fetchone() is None:
                return self.create(name)
            connection.execute(
                "SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE datname = %s", (name,)
            )
        with psycopg.connect(self.url(name), autocommit=True) as connection:
            connection.execute("DROP SCHEMA public CASCADE; CREATE SCHEMA public")
        return self.url(name)

    def run(self, *command: str) -> None:
        done = subprocess.run(command, user=self.user, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr

    def start(self, fsync: str = "off") -> None:
        # Processes are killed here and no power is cut: what was written the system still has.
        options = (
            f"-c fsync={fsync} -c listen_addresses='' -c unix_socket_directories='{self.folder}'"
        )
        self.run(
            str(self.binaries / "pg_ctl"),
            *("-D", str(self.folder / "data"), "-l", str(self.folder / "log"), "-w"),
            *("-o", f"{options} -c max_connections=200", "start"),
        )

    def stop(self, mode: str = "fast") -> None:
        """`immediate` is a crash: no shutdown, recovery at the next start."""
        data = str(self.folder / "data")
        self.run(str(self.binaries / "pg_ctl"), "-D", data, "-m", mode, "-w", "stop")


def binaries() -> Path | None:
    """Where the newest initdb is, if anywhere."""

    def version(path: Path) -> float:
        return float(path.parts[-3])

    found = sorted(Path("/usr/lib/postgresql").glob("*/bin/initdb"), key=version)
    if found:
        return found[-1].parent
    elsewhere = shutil.which("initdb")
    return Path(elsewhere).resolve().parent if elsewhere else None


@contextmanager
def start() -> Iterator[Server]:
    """A new server; skips the test that asks for one where none is installed."""
    where = binaries()
    if where is None:
        pytest.skip("no PostgreSQL here:   sudo apt install postgresql")
    # The server refuses to run as root, and its user must reach the folder.
    user = "nobody" if os.getuid() == 0 else None
    folder = Path(tempfile.mkdtemp(prefix="nacreous-"))
    if user is not None:
        os.chown(folder, pwd.getpwnam(user).pw_uid, -1)
    server = Server(folder, where, user)
    try:
        initdb = str(where / "initdb")
        data = str(folder / "data")
        server.run(initdb, "-D", data, "-U", "nacreous", "-A", "trust", "-E", "UTF8", "--no-sync")
        server.start()
        try:
            yield server
        finally:
            server.stop("immediate")
    finally:
        _remove(folder)


def _remove(folder: Path) -> None:
    for _ in range(20):
        shutil.rmtree(folder, ignore_errors=True)
        if not folder.exists():
            return
        time.sleep(0.1)
