"""What a server answers is bounded and read like any other file: a sentence for whatever is no chat completion."""

from __future__ import annotations

import httpx2
import pytest

from robolayout._errors import ModelError
from robolayout.planners.model import provider
from robolayout.planners.model.exchange import Question
from robolayout.planners.model.options import ModelOptions

pytestmark = pytest.mark.usefixtures("ask_loopback")


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (b"[" * 200_000, "nested too deeply"),
        (b'{"choices": [' + b"9" * 5000 + b"]}", "has a number of 5000 characters"),
        (b'{"choices": [{"message": {"role": "assistant", "content": "\\ud800"}}]}', "a lone surrogate"),
        (b'{"choices": [NaN]}', "has nan where only finite numbers are allowed"),
        (b'{"choices": ["x"]}', "an answer of another form than asked for"),
        (b'{"choices": true}', "an answer of another form than asked for"),
    ],
)
def test_an_answer_that_is_no_completion_is_one_sentence(
    body: bytes, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def answered(request: httpx2.Request) -> httpx2.Response:
        return httpx2.Response(200, content=body, headers={"Content-Type": "application/json"}, request=request)

    monkeypatch.setenv("OPENAI_API_KEY", "none")
    transport = httpx2.MockTransport(answered)
    monkeypatch.setattr(provider, "create_async_httpx2_client", lambda **_: httpx2.AsyncClient(transport=transport))
    question = Question("plan", "all", 1, 1, "say", ("what",), "key")
    client = ModelOptions(base_url="http://127.0.0.1:9/v1").open("openai:m")
    with pytest.raises(ModelError) as caught:
        client.ask(question, str)
    assert said in str(caught.value) and "\n" not in str(caught.value)
