"""The recordings in `recordings/`: programs written by hand as a strong model writes them, in the form of the prompt.

`recordings/<room>/scene.json` is the room and `recordings/<room>/<mode>/*.json` are the exchanges, without the prompts that they
answer. They have the faults that such models have: two relations that settle one heading, a relation that does not exist, a list
where a thing is meant, distances smaller than the furniture, a picture hung where nobody reaches it, things never mentioned.
`python tests/planners/vlm_recordings.py` writes their keys again after the form of a key has changed.
"""

from __future__ import annotations

import json
from pathlib import Path

from robolayout.planners.model.exchange import FORMAT, read_exchanges
from robolayout.planners.model.planner import EVERYTHING
from robolayout.planners.model.prompt import PROMPT_VERSION, digest, given_data
from robolayout.scene import Scene, load_scene

FOLDER = Path(__file__).parent / "recordings"
ROOMS = tuple(sorted(path.name for path in FOLDER.iterdir() if path.is_dir()))


def scene_of(room: str) -> Scene:
    return load_scene(FOLDER / room / "scene.json")


def exchange(scene: Scene, mode: str, slot: tuple[str, str, int, int], text: str) -> dict[str, object]:
    """Return an exchange written by hand."""
    kind, label, attempt, sample = slot
    return {
        "format": FORMAT,
        "prompt_version": PROMPT_VERSION,
        "model": "written by hand",
        "kind": kind,
        "label": label,
        "attempt": attempt,
        "sample": sample,
        "turn": 1,
        "key": "",
        "state": "",
        "answer": {
            "parts": [{"kind": "text", "content": text}],
            "model": "written by hand",
            "finish_reason": "stop",
            "usage": {"input_tokens": 0, "output_tokens": 0, "cost": None},
        },
    }


def rekey(room: str, mode: str) -> None:
    """Write the keys of one recording again."""
    from robolayout.planners.model.grouping import Grouping, groups_of

    folder, scene = FOLDER / room / mode, scene_of(room)
    entries = read_exchanges(folder)
    grouping = entries.get(("group", EVERYTHING, 1, 1, 1))
    groups = {}
    if grouping:
        answer = Grouping.model_validate_json(grouping["answer"]["parts"][0]["content"])
        groups = {group.label: group for group in groups_of(scene, answer)}
    for path in sorted(folder.glob("*.json")):
        entry = json.loads(path.read_text())
        data = given_data(scene, groups.get(entry["label"]), entry["kind"])
        entry["key"] = digest({"mode": mode, **data})
        entry["prompt_version"] = PROMPT_VERSION
        path.write_text(json.dumps(entry, ensure_ascii=False, indent=1) + "\n")


if __name__ == "__main__":
    for name in ROOMS:
        for folder in sorted((FOLDER / name).iterdir()):
            if folder.is_dir():
                rekey(name, folder.name)
