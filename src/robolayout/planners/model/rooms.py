"""From words to a scene by a model: the room and its things as it answers them, read and checked as any scene file is."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, TypeGuard

from pydantic import BaseModel, Field

from robolayout._errors import SceneError
from robolayout.assets import CATALOGUE, find_category, own_assets
from robolayout.assets.catalogue import FILE
from robolayout.assets.category import PLACES, Category
from robolayout.planners.sentence import SIZES, Understanding, asset_entry
from robolayout.scene import Layout, Pose, Scene, agent_names, scene_from_dict, variable_name
from robolayout.words import read_words

GIVEN = ("count", "opening", "refusal", "room size", "room area", "room height")
"""Rows of the ledger that a scene meets or not before anything is placed."""


class Thing(BaseModel):
    """Some things of one kind."""

    kind: str = Field(description="a kind of the list, word for word, or a short name of your own")
    count: int = Field(ge=1, le=200)
    size: list[float] | None = Field(default=None, description="depth, width, height in metres, if not as listed")
    place: Literal["floor", "wall", "ceiling", "object"] | None = Field(default=None, description="where it may be")
    description: str = ""
    asked: bool = Field(default=True, description="whether the words ask for it")


class Gap(BaseModel):
    """A door or a window."""

    wall: int
    offset: float
    width: float
    height: float
    sill: float = Field(default=0.9, description="of a window, metres above the floor")


class Furnishing(BaseModel):
    """A room and what is in it."""

    room_type: str
    corners: list[list[float]] = Field(description="[x, y] of the floor's corners, counter-clockwise, metres")
    wall_height: float
    doors: list[Gap]
    windows: list[Gap]
    body: str | None = None
    things: list[Thing]
    assumed: list[str] = Field(default_factory=list, description="one sentence for each choice of yours")


@dataclass(frozen=True)
class Choice:
    """A kind of thing that a model may choose."""

    size: tuple[float, float, float]  # depth, width and height in metres
    places: tuple[str, ...]  # where it may be
    entry: Mapping[str, object]  # what a scene file says of it


def choices(folder: Path | None) -> dict[str, Choice]:
    """Return the built-in kinds by name, then those of a user's own catalogue, which take the place of built-in ones."""
    found = {kind.name: _choice(kind) for kind in CATALOGUE.values()}
    if has_catalogue(folder):
        for own in own_assets(folder).assets:
            places = tuple(place for place in PLACES if getattr(own, f"on_{place}"))
            found[own.name] = Choice(own.size, places, {"from": own.name})
    return found


def _choice(kind: Category) -> Choice:
    return Choice(kind.size, kind.places, asset_entry(kind, kind.size))


def has_catalogue(folder: Path | None) -> TypeGuard[Path]:
    """Return whether a folder of assets has a catalogue."""
    return folder is not None and (folder / FILE).is_file()


def choices_text(known: Mapping[str, Choice]) -> str:
    """Return the kinds as lines of the prompt."""
    rows = (f"{name}: {' x '.join(f'{v:g}' for v in one.size)}, {', '.join(one.places)}" for name, one in known.items())
    return "# The kinds\n\n" + "\n".join(row.replace("`", "'") for row in rows)


class Furnisher:
    """Reads what a model answered to a sentence; a user's own assets are in a folder, with a catalogue or without."""

    def __init__(self, text: str, folder: Path | None) -> None:
        self.text, self.folder, self.known = text.strip(), folder, choices(folder)

    def complaint(self, answer: Furnishing) -> str | None:
        """Return what is wrong with an answer, for the model to mend; None if nothing is."""
        try:
            scene = self.scene(answer)
        except SceneError as error:
            return f"The room cannot be read: {error}"
        there = Layout({asset.name: Pose(0.0, 0.0, 0.0, 0.0) for asset in scene.assets})
        wrong = [
            f"{row.words!r} asks for {row.understanding}, and it is: {row.value}"
            for row in read_words(scene).judged(scene, there)
            if (row.kind in GIVEN and row.verdict == "unmet") or (row.kind, row.verdict) == ("count", "not understood")
        ]
        taken = sum(a.size[0] * a.size[1] for a in scene.assets if a.on_floor and not a.is_flat)
        if taken > SIZES.fullest * scene.room.area:
            wrong.append(
                f"what stands on the floor covers {taken:.1f} m2 of {scene.room.area:.1f} m2, at most {SIZES.fullest:.0%} may be"
            )
        return f"The words are not met: {'; '.join(wrong)}. Answer again." if wrong else None

    def understanding(self, answer: Furnishing) -> Understanding:
        """Return what was understood, as for a sentence that is read without a model."""
        x0, y0, x1, y1 = self.scene(answer).room.bounds
        wished, added = Counter[str](), Counter[str]()
        for thing in answer.things:
            (wished if thing.asked else added)[thing.kind] += thing.count
        shape = "rectangular" if len(answer.corners) == 4 else f"{len(answer.corners)}-cornered"
        size = (round(x1 - x0, 2), round(y1 - y0, 2))
        kind, *assumed = (" ".join(said.split()) for said in (answer.room_type, *answer.assumed))
        return Understanding(
            self.text, kind, size, shape, answer.wall_height, answer.body, wished, added, tuple(assumed), ignored=()
        )

    def scene(self, answer: Furnishing) -> Scene:
        """Return the scene of an answer; raises `SceneError` for what no scene file may say."""
        counts, assets = Counter[str](), dict[str, object]()
        for thing in answer.things:
            stem, entry = variable_name(thing.kind), self._entry(thing)
            assets |= {f"{stem}-{counts[stem] + i}": entry for i in range(thing.count)}
            counts[stem] += thing.count
        data: dict[str, object] = {
            "task_description": self.text,
            "boundary": {"floor_vertices": [[*at, 0.0] for at in answer.corners], "wall_height": answer.wall_height},
            "doors": [door.model_dump(exclude={"sill"}) for door in answer.doors],
            "windows": [window.model_dump() for window in answer.windows],
        }
        if answer.body is not None:
            if answer.body not in agent_names():
                raise SceneError(f"there is no body {answer.body!r}; known are {', '.join(agent_names())}.")
            data["agent"] = answer.body
        catalogue = {"catalogue": FILE} if has_catalogue(self.folder) else {}
        return scene_from_dict({**data, "assets": assets, **catalogue}, base=self.folder, asset_dir=self.folder)

    def _entry(self, thing: Thing) -> dict[str, object]:
        """Return a thing as a scene file has it."""
        meant = find_category(thing.kind)  # the built-in kind that the words mean
        choice = self.known.get(thing.kind) or (None if meant.group == "unknown" else _choice(meant))
        size = thing.size or (choice and choice.size)
        place = thing.place or (choice and choice.places[0])
        if size is None or place is None or len(size) != 3:
            raise SceneError(
                f"{thing.kind!r} is no kind of the list: give its size (depth, width, height) and its place."
            )
        entry: dict[str, object] = dict(choice.entry) if choice else {}
        if thing.kind not in self.known:
            entry["category"] = thing.kind
        if choice is None or thing.place is not None:
            entry |= {f"on{at.title()}": at == place for at in PLACES}
        if "from" not in entry:
            entry["assetMetadata"] = {"boundingBox": dict(zip("xyz", size, strict=True))}
        return entry | ({"description": thing.description} if thing.description else {})
