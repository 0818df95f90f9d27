"""A loopback server that speaks OpenAI's chat completions and Anthropic's messages, and plays models good and bad.

Real HTTP, no network: the protocol is that of the path that is asked.
"""

from __future__ import annotations

import base64
import io
import json
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any

from PIL import Image


@dataclass
class Reply:
    """What the server answers: text, or a status with headers."""

    text: str = ""
    status: int = 200
    headers: dict[str, str] = field(default_factory=dict)
    wait: float = 0.0
    drip: float = 0.0
    tool: str = ""
    untold: bool = False
    finish: str = ""
    body: bytes = b""
    tokens: tuple[int, int] = (1000, 200)


@dataclass
class Seen:
    """One request as the server saw it."""

    texts: list[str]
    images: list[Image.Image]
    labels: list[str]
    headers: dict[str, str]
    body: dict[str, Any]
    at: float = 0.0

    @property
    def system(self) -> str:
        given = self.body.get("system")
        if given is not None:
            return given if isinstance(given, str) else "\n".join(block["text"] for block in given)
        return "\n".join(m["content"] for m in self.body["messages"] if m["role"] in ("system", "developer"))

    @property
    def user(self) -> str:
        return "\n".join(self.texts)


class Loopback:
    """A server on 127.0.0.1 whose replies a test gives as a function of the request and its number."""

    def __init__(self, play: Callable[[Seen, int], Reply | str]) -> None:
        self.play, self.seen, self.most_at_once = play, list[Seen](), 0
        self._busy, self._lock, self.closing = 0, threading.Lock(), threading.Event()
        self._server = ThreadingHTTPServer(("127.0.0.1", 0), self._handler())
        self._server.daemon_threads = True
        self._server.handle_error = lambda *_: None  # a client that hangs up early is part of the play
        self.root = f"http://127.0.0.1:{self._server.server_port}"
        self.url = f"{self.root}/v1"
        self._thread = threading.Thread(target=self._server.serve_forever, args=(0.02,), daemon=True)
        self._thread.start()

    def close(self) -> None:
        self.closing.set()
        self._server.shutdown()
        self._server.server_close()
        self._thread.join(5)

    def _handler(loop) -> type[BaseHTTPRequestHandler]:
        class Handler(BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def log_message(self, *args: object) -> None:
                pass

            def do_POST(self) -> None:
                body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
                with loop._lock:
                    seen = _read(body, {name.lower(): value for name, value in self.headers.items()})
                    loop.seen.append(seen)
                    number = len(loop.seen)
                    loop._busy += 1
                    loop.most_at_once = max(loop.most_at_once, loop._busy)
                try:
                    reply = loop.play(seen, number)
                    reply = Reply(reply) if isinstance(reply, str) else reply
                    loop.closing.wait(reply.wait)
                    self._send(reply, body)
                except (BrokenPipeError, ConnectionResetError):
                    self.close_connection = True
                finally:
                    with loop._lock:
                        loop._busy -= 1

            def _send(self, reply: Reply, body: dict[str, Any]) -> None:
                said = _message if self.path.split("?")[0].endswith("/messages") else _completion
                told, form = said(reply, body), "application/json"
                data = reply.body or json.dumps(told).encode()
                if said is _message and body.get("stream") and reply.status == 200 and not reply.body:
                    data, form = _events(told), "text/event-stream"
                self.send_response(reply.status)
                for name, value in {"Content-Type": form, **reply.headers}.items():
                    self.send_header(name, value)
                self.send_header("Content-Length", str(len(data)))
                self.end_headers()
                if not reply.drip:
                    self.wfile.write(data)
                    return
                for byte in data:
                    self.wfile.write(bytes([byte]))
                    self.wfile.flush()
                    if loop.closing.wait(reply.drip):
                        return

        return Handler


def _completion(reply: Reply, body: dict[str, Any]) -> dict[str, Any]:
    if reply.status != 200:
        return {"error": {"message": reply.text, "type": "server_error", "code": reply.headers.get("X-Code")}}
    message: dict[str, Any] = {"role": "assistant", "content": reply.text}
    if reply.tool:
        call = {"id": "call_1", "type": "function", "function": {"name": reply.tool, "arguments": reply.text}}
        message = {"role": "assistant", "content": None, "tool_calls": [call]}
    return {
        "id": "chatcmpl-1",
        "object": "chat.completion",
        "created": int(time.time()),
        "model": body["model"],
        "choices": [
            {"index": 0, "message": message, "finish_reason": reply.finish or ("tool_calls" if reply.tool else "stop")}
        ],
        **({} if reply.untold else {"usage": _tokens(reply, "prompt_tokens", "completion_tokens")}),
    }


def _tokens(reply: Reply, *names: str) -> dict[str, int]:
    return dict(zip(names, reply.tokens, strict=True)) | (
        {"total_tokens": sum(reply.tokens)} if "prompt_tokens" in names else {}
    )


def _message(reply: Reply, body: dict[str, Any]) -> dict[str, Any]:
    """Return an answer as Anthropic gives it; to a question with a tool JSON is the tool's input."""
    if reply.status != 200:
        return {"type": "error", "error": {"type": "api_error", "message": reply.text}}
    block: dict[str, Any] = {"type": "text", "text": reply.text}
    if body.get("tools") and reply.text.startswith("{"):
        block = {"type": "tool_use", "id": "toolu_1", "name": body["tools"][0]["name"], "input": json.loads(reply.text)}
    ends = {"length": "max_tokens", "content_filter": "refusal", "": "end_turn"}
    return {
        "id": "msg_1",
        "type": "message",
        "role": "assistant",
        "model": body["model"],
        "content": [block],
        "stop_reason": "tool_use" if block["type"] == "tool_use" else ends[reply.finish],
        "stop_sequence": None,
        "usage": _tokens(reply, "input_tokens", "output_tokens"),
    }


def _read(body: dict[str, Any], headers: dict[str, str]) -> Seen:
    """Take a request apart; every picture is decoded, so that a broken one fails the test."""
    texts: list[str] = []
    images: list[Image.Image] = []
    labels: list[str] = []
    for message in body["messages"]:
        if message["role"] != "user":
            continue
        content = message["content"]
        for part in [{"type": "text", "text": content}] if isinstance(content, str) else content:
            if part["type"] == "text":
                texts.append(part["text"])
            elif part["type"] == "tool_result":
                texts.append(json.dumps(part["content"]))
            else:
                data = part["source"]["data"] if part["type"] == "image" else _png_of(part["image_url"]["url"])
                picture = Image.open(io.BytesIO(base64.b64decode(data, validate=True)))
                picture.load()
                images.append(picture)
                labels.append(texts[-1])
    return Seen(texts, images, labels, headers, body, time.monotonic())


def _events(message: dict[str, Any]) -> bytes:
    """Return an answer of Anthropic's as the stream in which it comes."""
    (block,), used = message["content"], message["usage"]
    delta, empty = {"type": "text_delta", "text": block.get("text", "")}, {"type": "text", "text": ""}
    if block["type"] == "tool_use":
        delta, empty = {"type": "input_json_delta", "partial_json": json.dumps(block["input"])}, block | {"input": {}}
    start = message | {"content": [], "stop_reason": None, "usage": used | {"output_tokens": 1}}
    ends = {key: message[key] for key in ("stop_reason", "stop_sequence")}
    events: list[dict[str, Any]] = [
        {"type": "message_start", "message": start},
        {"type": "content_block_start", "index": 0, "content_block": empty},
        {"type": "content_block_delta", "index": 0, "delta": delta},
        {"type": "content_block_stop", "index": 0},
        {"type": "message_delta", "delta": ends, "usage": {"output_tokens": used["output_tokens"]}},
        {"type": "message_stop"},
    ]
    return "".join(f"event: {event['type']}\ndata: {json.dumps(event)}\n\n" for event in events).encode()


def _png_of(url: str) -> str:
    head, _, data = url.partition(",")
    assert head == "data:image/png;base64", head
    return data


@contextmanager
def serving(play: Callable[[Seen, int], Reply | str]) -> Iterator[Loopback]:
    """Run a server for the time of a test."""
    server = Loopback(play)
    try:
        yield server
    finally:
        server.close()


def png(color: str, size: tuple[int, int] = (40, 30)) -> bytes:
    """Return a small picture of one colour."""
    stream = io.BytesIO()
    Image.new("RGB", size, color).save(stream, "PNG")
    return stream.getvalue()
