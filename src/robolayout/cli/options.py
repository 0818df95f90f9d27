"""Options that several commands share, each said once: a command takes dataclasses of them, `spread` gives typer their fields."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, fields, is_dataclass
from functools import cached_property, update_wrapper
from inspect import Parameter, Signature, signature
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, get_type_hints

from typer import Argument, Option

from robolayout._errors import InputError
from robolayout._files import check_writable
from robolayout.cli.terminal import progress, say, warn

if TYPE_CHECKING:
    from robolayout.scene import Agent, Layout, Scene

SeedOption = Annotated[int, Option(min=0, help="Settles every choice.")]
AssetDirOption = Annotated[Path | None, Option(help="Folder of the assets that the scene refers to.")]
QuietOption = Annotated[bool, Option("--quiet", help="Print nothing but errors.")]
ProgramOption = Annotated[Path | None, Option(help="Also measure the statements of this program.")]
ConstraintsOption = Annotated[Path | None, Option(help="A Python file with constraints of your own; it is run.")]
DateOption = Annotated[str, Option(help="What the sheet to print gives as the date.")]
DoorsOption = Annotated[str, Option(help="How the room's doors stand: swinging, open or shut.")]
BaseUrlOption = Annotated[
    str | None, Option(help="A server that speaks OpenAI's protocol; anthropic:... asks for its own.")
]
MaxCostOption = Annotated[float | None, Option(help="Most dollars to spend on a model.")]
ReplayOption = Annotated[Path | None, Option(help="Answer from recorded exchanges, offline.")]
KnowledgeOption = Annotated[
    list[Path] | None, Option(help="A file with kinds of things, roles and rooms of your own; may be repeated.")
]
SceneArgument = Annotated[str, Argument(help="A scene file (JSON).")]
LayoutArgument = Annotated[Path, Argument(help="A layout file (JSON).")]


def read_constraints(path: Path | None) -> None:
    """Make the relations of a user's file known."""
    if path is not None:
        from robolayout.constraints import register_file

        register_file(path)


def spread(command: Callable[..., None]) -> Callable[..., None]:
    """Return a command that takes the fields of its dataclasses one by one, as typer wants them."""
    groups: dict[str, type[Any]] = {
        n: hint for n, hint in get_type_hints(command).items() if isinstance(hint, type) and is_dataclass(hint)
    }

    def flat(function: Callable[..., Any]) -> Iterator[Parameter]:
        hints = get_type_hints(function, include_extras=True)
        for one in signature(function).parameters.values():
            if one.name in groups:
                yield from flat(groups[one.name])
            else:
                yield one.replace(annotation=hints[one.name], kind=Parameter.KEYWORD_ONLY)

    def called(**given: Any) -> None:
        made = {
            name: group(**{one.name: given.pop(one.name) for one in fields(group)}) for name, group in groups.items()
        }
        command(**given, **made)

    update_wrapper(called, command).__dict__["__signature__"] = Signature(list(flat(command)))
    return called


@dataclass(frozen=True, kw_only=True)
class Told:
    """What is printed."""

    quiet: QuietOption = False
    as_json: Annotated[bool, Option("--json", help="Print JSON for machines.")] = False

    def tell(self, data: object, show: Callable[[], None]) -> None:
        """Print data for machines, or what people read, or nothing."""
        if self.as_json:
            say(json.dumps(data))
        elif not self.quiet:
            show()

    def progress(self) -> AbstractContextManager[Callable[[str], None]]:
        """Show the running phase."""
        return progress(self.quiet or self.as_json)


@dataclass(frozen=True, kw_only=True)
class ForBody:
    """For whom a scene is read, and from where."""

    agent: Annotated[str | None, Option(help="Body or bodies: names or files, separated by commas.")] = None
    asset_dir: AssetDirOption = None

    @cached_property
    def agents(self) -> tuple[Agent, ...]:
        """The bodies that were named; none where nothing was said."""
        from robolayout.scene import load_agents

        return () if self.agent is None else load_agents(self.agent)

    def of(self, scene: Scene) -> Scene:
        """Return a scene for the bodies that were named."""
        return scene.with_agents(*self.agents) if self.agents else scene

    def read(self, path: str, knowledge: Sequence[Path] = (), *, quiet: bool = False) -> Scene:
        """Read a scene; show what was mended on reading and, unless quiet, what is of no known kind."""
        from robolayout.assets import unknown_kinds
        from robolayout.scene import load_scene

        known = scene = load_scene(path, self.asset_dir)
        if knowledge:
            from robolayout.planners import OfflinePlanner

            known = OfflinePlanner(knowledge).recognised(scene)
        for warning in (*scene.warnings, *(() if quiet else unknown_kinds(known.assets))):
            warn(f"warning: {warning}")
        return self.of(scene)


@dataclass(frozen=True, kw_only=True)
class Laid(ForBody):
    """A scene with its layout."""

    scene: SceneArgument
    layout: LayoutArgument

    def read_both(self, *, quiet: bool = False) -> tuple[Scene, Layout]:
        """Read scene and layout."""
        from robolayout.scene import load_layout

        scene = self.read(self.scene, quiet=quiet)
        return scene, load_layout(self.layout, scene)


def names(given: str) -> list[str]:
    """Return names that are separated by commas."""
    return [name.strip() for name in given.split(",") if name.strip()]


def need(other: str, given: Mapping[str, object]) -> None:
    """Refuse options that are given though they mean nothing without another one."""
    for name in (name for name, value in given.items() if value):
        raise InputError(f"--{name.replace('_', '-')} means nothing without {other}: give that, too, or leave it out.")


def ending(path: Path, what: str, allowed: Sequence[str]) -> str:
    """Return the ending of a file that is to be written, if it is allowed and the file's folder can be written to."""
    if path.suffix.lower() not in allowed:
        raise InputError(f"{what} cannot be written to {path}: name a file that ends in {' or '.join(allowed)}.")
    check_writable(path.absolute().parent)
    return path.suffix.lower()
