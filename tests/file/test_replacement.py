"""Files that are the old one or the whole new one, whatever happens."""

import os
import signal
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from nacreous.file import atomic, check_output
from nacreous.problem import InputError


def names(folder: Path) -> list[str]:
    return sorted(entry.name for entry in folder.iterdir())


def test_the_new_file_replaces_the_old_and_nothing_else_stays(tmp_path: Path) -> None:
    target = tmp_path / "pearl.png"
    target.write_text("old")
    target.chmod(0o640)
    with atomic(target) as temporary:
        assert temporary.parent == tmp_path
        assert temporary.suffix == ".png"
        temporary.write_text("new")
        assert target.read_text() == "old"
    assert target.read_text() == "new"
    assert stat.S_IMODE(target.stat().st_mode) == 0o640
    assert names(tmp_path) == ["pearl.png"]


def test_a_new_file_has_the_permissions_of_the_umask(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        with atomic(tmp_path / "a.txt") as temporary:
            temporary.write_text("new")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "a.txt").stat().st_mode) == 0o640


@pytest.mark.parametrize("kind", [RuntimeError, KeyboardInterrupt, SystemExit])
def test_an_exception_leaves_the_old_file(tmp_path: Path, kind: type[BaseException]) -> None:
    target = tmp_path / "pearl.png"
    target.write_text("old")
    with pytest.raises(kind), atomic(target) as temporary:  # noqa: PT012
        temporary.write_text("half")
        raise kind
    assert target.read_text() == "old"
    assert names(tmp_path) == ["pearl.png"]


def test_a_signal_at_the_moment_a_file_is_created_leaves_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    close = os.close

    def interrupted(number: int) -> None:
        close(number)
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "close", interrupted)
    with pytest.raises(KeyboardInterrupt), atomic(tmp_path / "pearl.png"):
        pass
    with pytest.raises(KeyboardInterrupt):
        check_output(tmp_path / "pearl.png", [".png"])
    assert names(tmp_path) == []


def test_kill_9_leaves_the_old_file(tmp_path: Path) -> None:
    target = tmp_path / "pearl.png"
    target.write_text("old")
    program = (
        "import sys, time; from nacreous.file import atomic\n"
        "with atomic(sys.argv[1]) as temporary:\n"
        "    temporary.write_text('half'); print('written', flush=True); time.sleep(60)"
    )
    command = [sys.executable, "-c", program, str(target)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "written\n"
        process.send_signal(signal.SIGKILL)
    assert target.read_text() == "old"


def test_a_full_disk_is_one_message_and_leaves_the_old_file(tmp_path: Path) -> None:
    target = tmp_path / "pearl.exr"
    target.write_text("old")
    program = (
        "import resource, sys, numpy as np; from nacreous import _core\n"
        "from nacreous.file import atomic; from nacreous.problem import InputError\n"
        "plane = np.random.default_rng(1).random((64, 64, 3)).astype(np.float32)\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))\n"
        "try:\n"
        "    with atomic(sys.argv[1]) as temporary: _core.write_exr(temporary, [('', plane)], [])\n"
        "except InputError as problem: print(problem)"
    )
    command = [sys.executable, "-c", program, str(target)]
    told = subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()
    assert told == f"{target}: cannot be written (File too large)"
    assert target.read_text() == "old"
    assert names(tmp_path) == ["pearl.exr"]


def test_an_error_about_another_file_stays_what_it_is(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError), atomic(tmp_path / "a.txt"):
        (tmp_path / "missing").read_text()
    assert names(tmp_path) == []


def test_a_link_keeps_pointing_and_its_file_is_replaced(tmp_path: Path) -> None:
    (tmp_path / "real.txt").write_text("old")
    (tmp_path / "link.txt").symlink_to("real.txt")
    with atomic(tmp_path / "link.txt") as temporary:
        temporary.write_text("new")
    assert (tmp_path / "link.txt").is_symlink()
    assert (tmp_path / "real.txt").read_text() == "new"


def test_outputs_that_cannot_be_are_refused_before_and_during(tmp_path: Path) -> None:
    (tmp_path / "folder.png").mkdir()
    (tmp_path / "note").touch()
    for path, message in [
        (tmp_path / "folder.png", r"folder.png: is a folder; allowed: a file in it, by its name$"),
        (tmp_path / "missing" / "a.png", r"a.png: the folder .*missing does not exist$"),
        (tmp_path / "note" / "a.png", r"a.png: the folder .*note does not exist$"),
        (Path("/proc/a.png"), r"^/proc/a.png: cannot be written \(.+\)$"),
        (tmp_path / ("n" * 300 + ".png"), r"cannot be written \(File name too long\)$"),
    ]:
        with pytest.raises(InputError, match=message):
            check_output(path, [".png"])
        with pytest.raises(InputError, match=message), atomic(path):
            pytest.fail("the body must not run")
    with (
        pytest.raises(InputError, match=r"^/dev/null: is not an ordinary file"),
        atomic("/dev/null"),
    ):
        pytest.fail("the body must not run")


def test_an_unknown_ending_is_refused_with_the_allowed_ones(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"a.tiff: the ending is .tiff; allowed: .png, .exr$"):
        check_output(tmp_path / "a.tiff", [".png", ".exr"])
    with pytest.raises(InputError, match=r"/a: the ending is missing; allowed: .png$"):
        check_output(tmp_path / "a", [".png"])
    assert check_output(tmp_path / "A.PNG", [".png"]) == tmp_path / "A.PNG"
    assert names(tmp_path) == []
