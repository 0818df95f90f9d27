"""The model planner against a real HTTP server on this machine that plays models good and bad."""

from __future__ import annotations

import asyncio
import json
import socket
import threading
from decimal import Decimal
from pathlib import Path

import pytest
from vlm_rooms import BED, GROUPING, PICTURE, small_room
from vlm_server import Reply, Seen, png, serving

from robolayout._errors import BudgetError, InputError, MissingExtraError, ModelError, ProgramError, UnknownNameError
from robolayout.planners import Group, ModelPlanner, OfflinePlanner, PlanRequest
from robolayout.planners.model.grouping import LEFT_OVER
from robolayout.program import ProgramLimits, read_program
from robolayout.scene import Layout, Pose

pytestmark = pytest.mark.usefixtures("ask_loopback")

SCENE = small_room()
SLEEPING = Group("sleeping", "The bed rules the room.", ("bed-0", "night_stand-0", "lamp-0"))
IMAGES = {"bed-0": png("blue"), "side": png("green"), "top": png("red", (64, 48))}
REQUEST = PlanRequest(SCENE, SLEEPING, images=IMAGES)

PATIENCE = 120.0
"""Seconds to wait for what must come: a busy machine may be slow."""


def good(seen: Seen, number: int) -> str:
    if "sort the furniture" in seen.system:
        return GROUPING
    return f"```python\n{PICTURE if 'decoration' in seen.user else BED}```"


def planner(url: str, **options: object) -> ModelPlanner:
    return ModelPlanner("openai:gpt-4o", base_url=url, **({"timeout": PATIENCE} | options))


def test_a_good_model_groups_and_plans() -> None:
    with serving(good) as server:
        asked = planner(server.url)
        groups = asked.group(SCENE)
        texts = [asked.plan(PlanRequest(SCENE, group)) for group in groups]
    assert [group.label for group in groups] == ["sleeping", "decoration"]
    assert [len(read_program(text, SCENE).statements) for text in texts] == [4, 1]
    assert asked.usage.requests == 3
    assert (asked.usage.input_tokens, asked.usage.output_tokens) == (3000, 600)
    assert asked.usage.cost == pytest.approx(3 * (1000 * 2.5e-6 + 200 * 10e-6))
    assert asked.to_dict()["usage"]["cost"] == asked.usage.cost
    assert asked.warnings == ()


def test_pictures_arrive_in_order_each_under_its_words() -> None:
    with serving(good) as server:
        planner(server.url).plan(REQUEST)
    (seen,) = server.seen
    assert [image.getpixel((0, 0)) for image in seen.images] == [(255, 0, 0), (0, 128, 0), (0, 0, 255)]
    assert seen.images[0].size == (64, 48)
    assert seen.labels[0].startswith("The room from above")
    assert seen.labels[1].startswith("The room from the side")
    assert '"bed-0"' in seen.labels[2]


@pytest.mark.parametrize(
    ("mode", "pictures", "relations"), [("grouped", 3, True), ("no_image", 0, True), ("no_constraint", 3, False)]
)
def test_modes_differ_in_what_is_sent(mode: str, pictures: int, relations: bool) -> None:
    with serving(good) as server:
        planner(server.url, mode=mode).plan(REQUEST)
    assert len(server.seen[0].images) == pictures
    assert ("solver.against_wall" in server.seen[0].system) is relations


def test_one_shot_asks_for_everything_without_grouping() -> None:
    with serving(good) as server:
        asked = planner(server.url, mode="one_shot")
        (group,) = asked.group(SCENE)
        assert not server.seen
        asked.plan(PlanRequest(SCENE, group))
    assert set(group.items) == set(SCENE.by_name)
    assert '"picture[0]"' in server.seen[0].user


def test_prose_around_the_fence_is_no_program() -> None:
    with serving(lambda *_: f"Sure! The **bed** first:\n\n```python\n{BED}```\nHope it helps; x = (") as server:
        text = planner(server.url).plan(REQUEST)
    assert len(read_program(text, SCENE).statements) == 4


def test_forgotten_assets_are_asked_for_with_the_reason() -> None:
    def forgetful(seen: Seen, number: int) -> str:
        return GROUPING if number > 1 else GROUPING.replace('"lamp-0"', '"throne-0"')

    with serving(forgetful) as server:
        groups = planner(server.url).group(SCENE)
    assert len(server.seen) == 2
    assert "These things are in no group: lamp-0." in server.seen[1].user
    assert "These names do not exist: throne-0." in server.seen[1].user
    assert [group.label for group in groups] == ["sleeping", "decoration"]


def test_what_is_never_named_comes_last() -> None:
    with serving(lambda *_: GROUPING.replace('"lamp-0"', '"throne-0"')) as server:
        groups = planner(server.url).group(SCENE)
    assert len(server.seen) == 3
    assert groups[-1].label == LEFT_OVER
    assert groups[-1].items == ("lamp-0",)


def test_a_grouping_in_prose_is_asked_for_again_and_then_made_by_rules() -> None:
    with serving(lambda *_: "I would put the bed first.") as server:
        asked = planner(server.url)
        assert asked.group(SCENE) == OfflinePlanner().group(SCENE)
    assert len(server.seen) == 3
    (warning,) = asked.warnings
    assert warning.startswith("The offline planner's groups are asked for: openai:gpt-4o gave no usable answer: ")
    assert not set("{[<") & set(warning), "no raw JSON in a sentence"


def test_a_model_with_tools_answers_with_a_tool(monkeypatch: pytest.MonkeyPatch) -> None:
    from pydantic_ai.messages import ModelResponse, ToolCallPart
    from pydantic_ai.models.function import FunctionModel

    model = FunctionModel(lambda messages, info: ModelResponse([ToolCallPart(info.output_tools[0].name, GROUPING)]))
    asked = ModelPlanner(model)
    assert [group.label for group in asked.group(SCENE)] == ["sleeping", "decoration"]


def test_tools_over_http_also_with_a_ready_model_asked_twice() -> None:
    from pydantic_ai.models.openai import OpenAIChatModel
    from pydantic_ai.providers.openai import OpenAIProvider

    def with_tools(seen: Seen, number: int) -> Reply:
        return Reply(GROUPING, tool=seen.body["tools"][0]["function"]["name"])

    with serving(with_tools) as server:
        asked = ModelPlanner(OpenAIChatModel("gpt-4o", provider=OpenAIProvider(base_url=server.url)), timeout=PATIENCE)
        first, second = asked.group(SCENE), asked.group(SCENE)
    assert first == second
    assert [group.label for group in first] == ["sleeping", "decoration"]


def test_what_was_wrong_goes_back_with_the_program_until_it_is_right() -> None:
    wrong = "bed[0].position = [1, 1.6, 0.25]\nsolver.against_wal(bed[0], walls[3])"

    def learner(seen: Seen, number: int) -> str:
        return f"```python\n{wrong if number < 3 else BED}\n```"

    with serving(learner) as server:
        asked, feedback, text = planner(server.url), "", ""
        for _ in range(1 + asked.retries):
            text = asked.plan(PlanRequest(SCENE, SLEEPING, feedback=feedback, previous=text))
            try:
                read_program(text, SCENE)
                break
            except ProgramError as error:
                feedback = str(error)
    assert len(server.seen) == 3
    assert "line 2" in server.seen[1].user or "line 3" in server.seen[1].user
    assert "did you mean" in server.seen[2].user.lower()
    assert "solver.against_wal(bed[0], walls[3])" in server.seen[2].user


def test_samples_are_asked_for_at_the_same_time() -> None:
    everybody = threading.Barrier(4)

    def slow(seen: Seen, number: int) -> Reply:
        everybody.wait(PATIENCE)  # no answer before all have asked
        return Reply(BED)

    with serving(slow) as server:
        asked = planner(server.url, samples=4)
        texts = asked.plan_many(REQUEST, 4)
    assert len(texts) == 4
    assert server.most_at_once == 4
    assert len({seen.body["seed"] for seen in server.seen}) == 4
    assert {seen.body["temperature"] for seen in server.seen} == {0.8}
    assert asked.usage.requests == 4


def test_samples_that_fail_are_left_out_and_told() -> None:
    def half(seen: Seen, number: int) -> Reply:
        even = seen.body["seed"] % 2 == 0
        return Reply(BED) if even else Reply("no such thing", 400)

    with serving(half) as server:
        asked = planner(server.url)
        assert len(asked.plan_many(REQUEST, 4)) == 2
    assert asked.warnings[0] == "one of 4 samples is missing: openai:gpt-4o (400): no such thing."


@pytest.mark.parametrize("status", [429, 500, 503])
def test_a_busy_server_is_asked_again_after_the_time_it_names(status: int) -> None:
    def busy(seen: Seen, number: int) -> Reply:
        return Reply("busy", status, {"retry-after-ms": "400"}) if number == 1 else Reply(BED)

    with serving(busy) as server:
        assert planner(server.url).plan(REQUEST) == BED
    assert server.seen[1].at - server.seen[0].at >= 0.39


@pytest.mark.parametrize(
    ("status", "words"),
    [
        (429, r"openai:gpt-4o is still busy after several tries \(429\): out of breath\. Try again later"),
        (500, r"openai:gpt-4o failed after several tries \(500\): out of breath\."),
    ],
)
def test_a_server_that_never_recovers_is_an_error(status: int, words: str) -> None:
    with (
        serving(lambda *_: Reply("out of breath", status, {"retry-after-ms": "20"})) as server,
        pytest.raises(ModelError, match=words),
    ):
        planner(server.url).plan(REQUEST)
    assert len(server.seen) == 3


def test_a_slow_model_is_an_error_in_time() -> None:
    with serving(lambda *_: Reply(BED, wait=30)) as server:
        with pytest.raises(ModelError, match=r"gpt-4o did not answer within 0\.4 s\. Raise --timeout"):
            planner(server.url, timeout=0.4).plan(REQUEST)
        assert not server.closing.is_set(), "the answer is not waited for"


def test_a_model_that_drips_is_an_error_in_time() -> None:
    with serving(lambda *_: Reply(BED, drip=0.1)) as server, pytest.raises(ModelError, match="did not answer within"):
        planner(server.url, timeout=0.5).plan(REQUEST)


def test_ten_megabytes_are_not_read() -> None:
    words = "more than 4 MB, which is no program; it was not read"
    with serving(lambda *_: "x" * 10_000_000) as server, pytest.raises(ModelError, match=words):
        planner(server.url).plan(REQUEST)


def test_a_packed_answer_is_not_unpacked() -> None:
    with (
        serving(lambda *_: Reply(BED, 200, {"Content-Encoding": "gzip"})) as server,
        pytest.raises(ModelError, match="packed bytes"),
    ):
        planner(server.url).plan(REQUEST)


def test_a_long_answer_is_no_program() -> None:
    with serving(lambda *_: "x" * 500_000) as server, pytest.raises(ModelError, match="an answer of 500000 characters"):
        planner(server.url).plan(REQUEST)


@pytest.mark.parametrize(
    "escape",
    [
        "import os\nos.system('touch /tmp/robolayout_escaped')",
        "().__class__.__bases__[0].__subclasses__()",
        "open('/tmp/robolayout_escaped', 'w').write('x')",
        "while True: pass",
    ],
)
def test_what_tries_to_escape_is_a_program_error(escape: str, tmp_path: Path) -> None:
    with serving(lambda *_: f"```python\n{escape}\n```") as server:
        text = planner(server.url, exchanges=tmp_path).plan(REQUEST)
    with pytest.raises(ProgramError):
        read_program(text, SCENE, ProgramLimits(seconds=0.5))
    assert not Path("/tmp/robolayout_escaped").exists()


def test_a_label_that_tries_to_escape_stays_in_the_folder(tmp_path: Path) -> None:
    with serving(good) as server:
        asked = planner(server.url, exchanges=tmp_path / "in" / "exchanges")
        asked.plan(PlanRequest(SCENE, Group("../../../evil\0", "", ("bed-0",))))
    assert [path.parent.name for path in tmp_path.rglob("*.json")] == ["exchanges"]


def test_a_blind_model_plans_from_the_text_alone() -> None:
    def blind(seen: Seen, number: int) -> Reply:
        return Reply("this model does not support image input", 400) if seen.images else Reply(BED)

    with serving(blind) as server:
        asked = planner(server.url)
        assert asked.plan_many(REQUEST, 2) == (BED, BED)
        asked.plan(REQUEST)
    assert [len(seen.images) for seen in server.seen].count(0) == 3
    assert not server.seen[-1].images
    assert asked.warnings == ("openai:gpt-4o does not take pictures; it plans from the text alone (mode no_image).",)


def test_a_fallback_may_be_named_for_a_model_that_sees(monkeypatch: pytest.MonkeyPatch) -> None:
    with serving(good) as server:
        monkeypatch.setenv("OPENAI_BASE_URL", server.url)
        assert planner(server.url, fallback=("openai:gpt-4o-mini",)).plan(REQUEST)
    assert len(server.seen[0].images) == 3


def test_a_refusal_that_is_not_about_pictures_is_an_error() -> None:
    with (
        serving(
            lambda *_: Reply("maximum context length is 100 tokens", 400, {"X-Code": "context_length_exceeded"})
        ) as server,
        pytest.raises(ModelError, match="the room is too large for openai:gpt-4o"),
    ):
        planner(server.url).plan(REQUEST)


def test_the_budget_stops_the_job() -> None:
    with serving(good) as server:
        asked = planner(server.url, max_cost=0.04)
        asked.plan(REQUEST)
        with pytest.raises(
            BudgetError,
            match=r"stopped at the budget: openai:gpt-4o has cost \$0\.0225, the next answer would most likely cost "
            r"\$0\.0\d+, --max-cost allows \$0\.0400",
        ):
            for _ in range(8):
                asked.plan(REQUEST)
        asked_for = len(server.seen)
        with pytest.raises(BudgetError, match="stopped at the budget"):
            asked.plan(REQUEST)
    assert len(server.seen) == asked_for >= 2
    assert asked.usage.cost is not None and asked.usage.cost <= 0.04


@pytest.mark.parametrize("most", [0.0001, 0.005, 0.02, 0.03, 0.05, 0.1])
@pytest.mark.parametrize("samples", [1, 4])
def test_a_budget_of_any_size_holds(most: float, samples: int) -> None:
    with serving(good) as server:
        asked = planner(server.url, max_cost=most, samples=samples)
        answers = 0
        try:
            for _ in range(12):
                answers += len(asked.plan_many(REQUEST, samples))
        except BudgetError:
            pass
        assert answers == len(server.seen), "what was paid for is used"
    assert (asked.usage.cost or 0.0) <= most + 0.0045, "at most one answer dearer than its estimate"


def test_an_answer_dearer_than_the_whole_budget_is_used() -> None:
    with serving(good) as server:
        asked = planner(server.url, max_cost=0.002)
        asked._client.budget.price = lambda sent, received: Decimal("0.001")  # a price list that is out of date
        assert asked.plan(REQUEST)
        assert asked._client.budget.spent == Decimal("0.0045")


def test_a_server_that_tells_no_usage_has_its_tokens_estimated() -> None:
    with serving(lambda *_: Reply(BED, untold=True)) as server:
        asked = planner(server.url)
        asked.plan(REQUEST)
    assert asked.usage.input_tokens > 1000 and asked.usage.output_tokens == len(BED) // 4
    assert "openai:gpt-4o tells no token counts; they are estimated from characters." in asked.warnings


def test_an_answer_that_was_cut_off_is_known() -> None:
    with serving(lambda *_: Reply(BED, finish="length")) as server:
        asked = planner(server.url)
        assert asked.cut_off(asked.plan(REQUEST))
        assert not asked.cut_off("something else")


def test_a_budget_needs_a_price() -> None:
    with serving(good) as server:
        asked = ModelPlanner("my-own-model", base_url=server.url, max_cost=1.0)
        with pytest.raises(InputError, match="no price is known for my-own-model, so --max-cost cannot be kept"):
            asked.plan(REQUEST)
        free = ModelPlanner("my-own-model", base_url=server.url)
        free.plan(REQUEST)
    assert free.usage.cost is None
    assert len(server.seen) == 1


def test_a_wrong_key_is_told_without_the_key(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OPENAI_API_KEY", "sk-very-secret-0123456789")

    def guard(seen: Seen, number: int) -> Reply:
        return Reply(f"Incorrect API key provided: {seen.headers['authorization']}", 401)

    with serving(guard) as server, pytest.raises(ModelError) as caught:
        planner(server.url).plan(REQUEST)
    assert str(caught.value) == (
        "openai:gpt-4o refused the key (401): Incorrect API key provided: Bearer [secret]. "
        "Check the key in the environment and what it allows."
    )


def test_a_wrong_model_name_has_a_suggestion() -> None:
    reply = Reply("The model `gpt-4oo` does not exist", 404, {"X-Code": "model_not_found"})
    with serving(lambda *_: reply) as server, pytest.raises(ModelError) as caught:
        ModelPlanner("openai:gpt-4oo", base_url=server.url).plan(REQUEST)
    assert "there is no model 'openai:gpt-4oo' (404): The model `gpt-4oo` does not exist." in str(caught.value)
    assert "Did you mean 'openai:gpt-4o'?" in str(caught.value)


def test_a_refused_connection_names_the_address() -> None:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with pytest.raises(
        ModelError, match=rf"cannot connect to 127\.0\.0\.1:{port} for openai:gpt-4o: .*Is the server running"
    ):
        planner(f"http://user:password@127.0.0.1:{port}/v1").plan(REQUEST)


def test_names_that_cannot_be_meant() -> None:
    with pytest.raises(
        InputError, match=r"the model 'gpt-4o' names no provider\. Write 'openai:gpt-4o', or give --base-url\."
    ):
        ModelPlanner("gpt-4o")
    with pytest.raises(UnknownNameError, match=r"unknown model provider 'opnai'\. Did you mean 'openai'\? Known: "):
        ModelPlanner("opnai:gpt-4o")
    with pytest.raises(UnknownNameError, match=r"unknown mode 'group'\. Did you mean 'grouped'\?"):
        ModelPlanner("openai:gpt-4o", mode="group")
    with pytest.raises(InputError, match=r"'localhost:8000' is no address of a server\. Give one like http://"):
        ModelPlanner("openai:gpt-4o", base_url="localhost:8000")
    with pytest.raises(InputError, match="a model is needed"):
        ModelPlanner()


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"samples": 0}, "samples is 0; give a number from 1 to 64"),
        ({"retries": 21}, "retries is 21"),
        ({"timeout": 0}, "the timeout is 0 s"),
        ({"max_cost": -1.0}, "the maximum cost is -1 dollars"),
    ],
)
def test_numbers_that_make_no_sense(options: dict[str, float], words: str) -> None:
    with pytest.raises(InputError, match=words):
        ModelPlanner("openai:gpt-4o", **options)


def test_a_missing_key_names_its_variable() -> None:
    with pytest.raises(
        InputError, match="openai needs a key: set the environment variable OPENAI_API_KEY to ask openai:gpt-4o"
    ):
        ModelPlanner("openai:gpt-4o").plan(REQUEST)


def test_a_missing_package_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    from robolayout.planners.model import provider as _model_provider

    def without(provider: str) -> None:
        raise ImportError("Please install `anthropic`, you can use `pip install 'pydantic-ai-slim[anthropic]'`")

    monkeypatch.setattr(_model_provider, "infer_provider_class", without)
    words = r"anthropic models need a further package: pip install 'pydantic-ai-slim\[anthropic\]'"
    with pytest.raises(InputError, match=words):
        ModelPlanner("anthropic:claude-sonnet-4-5")


def test_a_missing_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    import builtins
    import sys

    real = builtins.__import__

    def without(name: str, *args: object, **options: object) -> object:
        if name.partition(".")[0] == "pydantic_ai":
            raise ModuleNotFoundError("No module named 'pydantic_ai'", name="pydantic_ai")
        return real(name, *args, **options)

    for name in ("model.client", "model.errors", "model.provider"):
        monkeypatch.delitem(sys.modules, f"robolayout.planners.{name}", raising=False)
    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(MissingExtraError, match=r"needs the extra 'vlm': pip install 'robolayout\[vlm\]'"):
        ModelPlanner("openai:gpt-4o")


def test_the_environment_may_name_the_server(monkeypatch: pytest.MonkeyPatch) -> None:
    with serving(good) as server:
        monkeypatch.setenv("OPENAI_BASE_URL", server.url)
        ModelPlanner("openai:gpt-4o").plan(REQUEST)
        monkeypatch.setenv("OLLAMA_BASE_URL", server.url)
        ModelPlanner("ollama:llava:13b").plan(REQUEST)
    assert [seen.body["model"] for seen in server.seen] == ["gpt-4o", "llava:13b"]


def test_it_works_where_an_event_loop_is_running() -> None:
    async def notebook() -> str:
        return planner(server.url).plan(REQUEST)

    with serving(lambda *_: BED) as server:
        assert asyncio.run(notebook()) == BED


def test_a_critic_rates_and_amends() -> None:
    def critic(seen: Seen, number: int) -> str:
        if "critic" in seen.system:
            return json.dumps({"score": 6, "reasons": ["The bed blocks the light."]})
        assert "The bed blocks the light." in seen.user
        return BED

    with serving(critic) as server:
        asked = planner(server.url)
        stands = Layout({"bed-0": Pose(1.0, 1.6, 0.25, 0.0)})
        pictures = {"finished top": png("red"), "finished side": png("green")}
        rating = asked.rate(SCENE, stands, pictures, "all demands met")
        text = asked.amend(PlanRequest(SCENE, placed=stands, previous=BED, feedback="\n".join(rating.reasons)))
    assert rating.score == 6
    assert text == BED
    assert "all demands met" in server.seen[0].user
    assert server.seen[0].labels == ["The finished room from above.", "The finished room from the side."]
    assert '{"variable": "bed[0]", "position": [1.0, 1.6, 0.25], "rotation": 0' in server.seen[0].user
    assert "solver.against_wall(bed[0], walls[3])" in server.seen[1].user


def test_a_rating_off_the_scale_is_asked_for_again() -> None:
    with serving(lambda seen, number: json.dumps({"score": 99 if number == 1 else 9})) as server:
        assert planner(server.url).rate(SCENE, Layout({}), {}, "").score == 9
