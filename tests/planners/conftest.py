"""No test of a planner reaches a network: only 127.0.0.1 answers, and a model is asked only where a test says so."""

from __future__ import annotations

import os
import socket

import pytest


@pytest.fixture(autouse=True)
def only_loopback(monkeypatch: pytest.MonkeyPatch) -> None:
    connect, lookup = socket.socket.connect, socket.getaddrinfo

    def guarded(self: socket.socket, address: object) -> None:
        assert self.family == socket.AF_UNIX or address[0] in ("127.0.0.1", "::1"), f"a test reached out to {address}"
        connect(self, address)

    def looked_up(host: object, *args: object, **options: object) -> object:
        assert host in ("127.0.0.1", b"127.0.0.1", "localhost", None), f"a test looked up {host}"
        return lookup(host, *args, **options)

    monkeypatch.setattr(socket.socket, "connect", guarded)
    monkeypatch.setattr(socket, "getaddrinfo", looked_up)
    for name in list(os.environ):
        if name.endswith(("_API_KEY", "_BASE_URL")) or name.lower() in ("http_proxy", "https_proxy", "all_proxy"):
            monkeypatch.delenv(name)


@pytest.fixture(autouse=True)
def no_model_by_itself() -> object:
    models = pytest.importorskip("pydantic_ai.models")
    before, models.ALLOW_MODEL_REQUESTS = models.ALLOW_MODEL_REQUESTS, False
    yield
    models.ALLOW_MODEL_REQUESTS = before


@pytest.fixture
def ask_loopback() -> object:
    """Allow requests, which the guard above keeps on this machine."""
    from pydantic_ai import models

    with models.override_allow_model_requests(True):
        yield
