"""What was asked of a model and what it answered, as files: to look at, and to run a job again without the model.

An answer is found again by its *slot* (which question it was: kind, group, attempt, sample, turn) and belongs to a *key*
(a hash of what the question rests on: room, assets, instruction, agents, group, mode). A key that differs is an error. The
rest of the prompt (our wording, poses of placed things, feedback) only has a hash of its own, `state`: a difference there is
noted and the answer still used, so that a recording outlives a better wording or another machine's last digit. Pictures
count by name, not by pixel. No key, header or address is written, and texts are scrubbed of every secret of the environment.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from hashlib import sha256
from operator import itemgetter
from pathlib import Path
from typing import Any

from robolayout._errors import InputError, ModelError
from robolayout._files import write_atomic
from robolayout._reading import Checker, show
from robolayout.planners.model.prompt import PROMPT_VERSION, Picture, digest

SLOT = ("kind", "label", "attempt", "sample", "turn")  # what tells exchanges of a run apart
Slot = tuple[str, str, int, int, int]
FORMAT = 1  # version of the exchange files
KINDS = ("room", "group", "plan", "rate", "amend", "judge")  # what a model may be asked for
NAME = re.compile(rf"({'|'.join(KINDS)})-[a-z0-9-]*attempt\d+-sample\d+(-turn\d+)?\.json")  # names of exchange files
COST = re.compile(r"\d{1,12}(\.\d{1,30})?(E[+-]?\d{1,2})?", re.ASCII)  # dollars as a recording writes them
MOST_FILES, MOST_BYTES = 10_000, 4_000_000  # exchange files that a recording may have, and bytes of one
MOST_TOKENS = 10**12  # largest count in a recording

_CHECK = Checker(InputError)


@dataclass(frozen=True)
class Question:
    """One question to a model."""

    kind: str  # one of `KINDS`
    label: str  # the group it is about
    attempt: int  # how often this was asked before, plus one
    sample: int  # which of several answers to the same question, from 1
    instructions: str  # the system prompt
    # the user's message: texts, and pictures as label and PNG bytes; what changes least between questions comes first
    parts: tuple[str | Picture, ...]
    key: str  # hash of what the question rests on
    temperature: float = 0.3  # how freely the model answers
    seed: int = 0  # settles the answer, where the provider can

    @property
    def texts(self) -> tuple[str, ...]:
        """The texts of the user's message."""
        return tuple(part for part in self.parts if isinstance(part, str))

    @property
    def images(self) -> tuple[Picture, ...]:
        """The pictures of the user's message."""
        return tuple(part for part in self.parts if not isinstance(part, str))

    @property
    def state(self) -> str:
        """Hash of everything that is sent, pictures by name."""
        return digest([PROMPT_VERSION, self.instructions, list(self.texts), [label for label, _ in self.images]])

    def slot(self, turn: int) -> Slot:
        """Return which exchange of a run this is."""
        return (self.kind, self.label, self.attempt, self.sample, turn)


@dataclass
class Tape:
    """Writes exchanges to one folder and reads them from another."""

    record: Path | None = None  # folder to write to; None writes nothing
    replay: Path | None = None  # folder to read from; None asks the model
    model: str = ""  # the model's name, written into every exchange
    notes: list[str] = field(default_factory=list[str])  # what was odd in a replay, one sentence each

    def __post_init__(self) -> None:
        if self.record and self.replay and self.record.resolve() == self.replay.resolve():
            both = f"cannot replay {self.replay} and record to it in one run"
            raise InputError(f"{both}. Give another folder to record to.")
        self._started = False
        self._secrets = secrets(os.environ)
        self._recorded = read_exchanges(self.replay) if self.replay else {}
        self.model = self.model or next((str(entry["model"]) for entry in self._recorded.values()), "")

    def scrub(self, text: str) -> str:
        """Return text without any secret of the environment."""
        for secret in self._secrets:
            text = text.replace(secret, "[secret]")
        return text

    def recall(self, question: Question, turn: int) -> dict[str, Any]:
        """Return the recorded exchange of a question, and record it again.

        That of another job, or none for a group, is an `InputError`; none for a later attempt, sample or turn a `ModelError`.
        """
        entry = self._recorded.get(question.slot(turn))
        times = f", attempt {question.attempt}" if question.attempt > 1 else ""
        times += f", sample {question.sample}" if question.sample > 1 else ""
        times += f", turn {turn}" if turn > 1 else ""
        asked = f"{question.kind!r} for group {question.label!r}{times}"
        if entry is None:
            labels = list(dict.fromkeys(label for _, label, *_ in self._recorded))
            groups = ", ".join(map(repr, labels[:6])) + (", ..." if len(labels) > 6 else "")
            first = (question.attempt, question.sample, turn) == (1, 1, 1)
            raise (InputError if first else ModelError)(
                f"{self.replay} holds no answer to {asked}; recorded are "
                f"{len(self._recorded)} exchanges for {groups}. Record again, or replay the same job."
            )
        if entry["key"] != question.key:
            raise InputError(
                f"the answer to {asked} in {self.replay} was given for another room, instruction, "
                "body, group or mode. Record again, or replay the same job."
            )
        if entry["state"] not in ("", question.state) and turn == 1:
            self.notes.append(
                f"the replayed answer to {asked} was given to another wording or another state of the room."
            )
        self._put(question, turn, entry)
        return entry

    def recorded(self, question: Question) -> dict[str, Any]:
        """Return the recorded first exchange of a question; empty if there is none."""
        return self._recorded.get(question.slot(1), {})

    def write(
        self,
        question: Question,
        turn: int,
        answer: Mapping[str, Any] | None,
        feedback: str = "",
        failure: ModelError | None = None,
    ) -> None:
        """Write one exchange, if exchanges are recorded; with `failure` one that came to nothing, and why."""
        entry: dict[str, Any] = {
            "format": FORMAT,
            "prompt_version": PROMPT_VERSION,
            "model": self.model,
            **dict(zip(SLOT, question.slot(turn), strict=True)),
            "key": question.key,
            "state": question.state,
            "request": {
                "instructions": question.instructions,
                "texts": list(question.texts),
                "images": [
                    {"label": label, "bytes": len(png), "sha256": sha256(png).hexdigest()}
                    for label, png in question.images
                ],
                "feedback": feedback,
            },
            "answer": answer,
        } | ({"failure": str(failure), "failed_as": type(failure).__name__} if failure else {})
        self._put(question, turn, _scrubbed(entry, self.scrub))

    def _put(self, question: Question, turn: int, entry: Mapping[str, Any]) -> None:
        """Write one file; the first one takes away the exchanges of an earlier run."""
        if self.record is None:
            return
        if not self._started:
            self._started = True
            for path in self.record.glob("*.json"):
                if NAME.fullmatch(path.name):
                    path.unlink(missing_ok=True)
        text = json.dumps(entry, ensure_ascii=False, indent=1)
        write_atomic(self.record / file_name(question, turn), text.encode("utf-8", "backslashreplace") + b"\n")


def file_name(question: Question, turn: int) -> str:
    """Return the name of an exchange file: kind, group, attempt, sample, and the turn if it is not the first."""
    slug = re.sub(r"[^a-z0-9]+", "-", question.label.lower()).strip("-")[:40]
    short = sha256(question.label.encode("utf-8", "surrogatepass")).hexdigest()[:6]
    parts = [question.kind, f"{slug}-{short}" if slug != question.label else slug]
    parts += [f"attempt{question.attempt}", f"sample{question.sample}"] + ([f"turn{turn}"] if turn > 1 else [])
    return "-".join(part for part in parts if part) + ".json"


def secrets(environment: Mapping[str, str]) -> tuple[str, ...]:
    """Return the values of environment variables that hold keys, longest first."""
    found = {
        value
        for name, value in environment.items()
        if len(value) >= 6 and re.search(r"(KEY|TOKEN|SECRET|PASSWORD|CREDENTIALS)$", name.upper())
    }
    return tuple(sorted(found, key=lambda value: (-len(value), value)))


def read_exchanges(folder: Path) -> dict[Slot, dict[str, Any]]:
    """Return the exchanges of a folder by slot; raises `InputError` for a folder or file that is none."""
    paths = sorted(folder.glob("*.json")) if folder.is_dir() else []
    if not paths:
        meant = "the folder that a run with a model wrote"
        raise InputError(f"{folder} holds no recorded exchanges (*.json). Give {meant}.")
    found: dict[Slot, dict[str, Any]] = {}
    for path in paths[:MOST_FILES]:
        try:
            entry = _checked(_CHECK.read_json(path, "the recorded exchange", MOST_BYTES))
        except InputError as error:
            what = f"no recorded exchange of format {FORMAT}"
            raise InputError(f"{path} is {what}: {error} Record the job again.") from None
        found[itemgetter(*SLOT)(entry)] = entry
    return found


def _checked(value: object) -> dict[str, Any]:
    """Return an exchange if it has what a replay needs."""
    entry = dict(_CHECK.mapping(value, "it"))
    if entry.get("format") != FORMAT:
        raise InputError(f"format is {show(entry.get('format'))}.")
    for key in ("kind", "label", "key", "state", "model"):
        _CHECK.text(_CHECK.required(entry, key, "it"), key)
    for key in ("attempt", "sample", "turn"):
        _whole(_CHECK.required(entry, key, "it"), key, least=1)
    if "request" in entry:
        request = _CHECK.mapping(entry["request"], "request")
        _CHECK.sequence(_CHECK.required(request, "images", "request"), "request.images", most=1000)
    failure = _CHECK.text(entry.get("failure", ""), "failure", most=MOST_BYTES)
    answer = _CHECK.required(entry, "answer", "it")
    if answer is not None or not failure:
        _check_answer(_CHECK.mapping(answer, "answer"))
    return entry


def _check_answer(answer: Mapping[str, object]) -> None:
    """Raise if what a model said lacks what is made of it."""
    for i, value in enumerate(_CHECK.sequence(_CHECK.required(answer, "parts", "answer"), "answer.parts", most=1000)):
        where = f"answer.parts[{i}]"
        part = _CHECK.mapping(value, where)
        kind = _CHECK.required(part, "kind", where)
        if kind not in ("text", "tool-call"):
            raise InputError(f"{where}.kind is {show(kind)}; allowed are 'text' and 'tool-call'.")
        for key in ("content", "tool")[: 1 + (kind == "tool-call")]:
            _CHECK.text(_CHECK.required(part, key, where), f"{where}.{key}", most=MOST_BYTES)
    for key in ("model", "finish_reason"):
        if (said := _CHECK.required(answer, key, "answer")) is not None:
            _CHECK.text(said, f"answer.{key}")
    usage = _CHECK.inner(answer, "usage", "answer", "answer.usage")
    for key in ("input_tokens", "output_tokens"):
        _whole(_CHECK.required(usage, key, "answer.usage"), f"answer.usage.{key}", least=0)
    cost = _CHECK.required(usage, "cost", "answer.usage")
    if cost is not None and not COST.fullmatch(_CHECK.text(cost, "answer.usage.cost")):
        raise InputError(f"answer.usage.cost is {show(cost)}, not dollars such as '0.0045'.")


def _whole(value: object, where: str, least: int) -> None:
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= MOST_TOKENS:
        raise InputError(f"{where} is {show(value)}, not a whole number from {least} to {MOST_TOKENS}.")


def _scrubbed(value: Any, scrub: Any) -> Any:
    if isinstance(value, str):
        return scrub(value)
    if isinstance(value, Mapping):
        return {key: _scrubbed(item, scrub) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_scrubbed(item, scrub) for item in value]
    return value
