"""Atomic writing: the whole new content, or what was there before."""

from __future__ import annotations

import errno
import os
import resource
import stat
from pathlib import Path

import pytest

from robolayout._errors import OutputError
from robolayout._files import write_atomic


def test_it_writes_bytes_and_text_and_makes_folders(tmp_path: Path) -> None:
    assert write_atomic(tmp_path / "a" / "b" / "x.bin", b"\x00\r\n").read_bytes() == b"\x00\r\n"
    assert write_atomic(tmp_path / "x.txt", "Möbel\r\n").read_bytes() == b"M\xc3\xb6bel\r\n"


def test_it_replaces_a_file_and_leaves_nothing_else(tmp_path: Path) -> None:
    path = tmp_path / "x"
    for content in ("old", "new"):
        write_atomic(path, content)
    assert path.read_text() == "new"
    assert [file.name for file in tmp_path.iterdir()] == ["x"]


def test_the_mode_follows_the_umask(tmp_path: Path) -> None:
    before = os.umask(0o027)
    try:
        path = write_atomic(tmp_path / "x", b"")
    finally:
        os.umask(before)
    assert stat.S_IMODE(path.stat().st_mode) == 0o640


def test_running_out_of_space_in_mid_file_keeps_the_old_one(tmp_path: Path) -> None:
    path = write_atomic(tmp_path / "x", b"old")
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, before[1]))
    try:
        with pytest.raises(OutputError, match=r"cannot write .*x \(300000 bytes\): File too large"):
            write_atomic(path, b"y" * 300_000)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert path.read_bytes() == b"old"
    assert [file.name for file in tmp_path.iterdir()] == ["x"]


@pytest.mark.parametrize("code", [errno.EROFS, errno.EACCES, errno.ENOSPC, errno.EDQUOT])
def test_each_failure_is_one_sentence_with_the_reason(
    code: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> None:
        raise OSError(code, os.strerror(code))

    monkeypatch.setattr(os, "open", fail)
    with pytest.raises(OutputError, match=rf"{os.strerror(code)}\. Nothing was left half-written; free some space or"):
        write_atomic(tmp_path / "x", b"y")
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_a_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "x").write_text("a file")
    with pytest.raises(OutputError, match="cannot write"):
        write_atomic(tmp_path / "x" / "y", b"")


def test_a_path_that_is_a_folder_is_refused(tmp_path: Path) -> None:
    (tmp_path / "x").mkdir()
    with pytest.raises(OutputError, match="Is a directory"):
        write_atomic(tmp_path / "x", b"")
    assert [file.name for file in tmp_path.iterdir()] == ["x"]


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_read_only_folder_is_refused(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    with pytest.raises(OutputError, match="Permission denied"):
        write_atomic(tmp_path / "x", b"")
