"""`robolayout batch` and `robolayout evaluate`: data sets of rooms, and any folder of rooms measured."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer import Argument, Option

from robolayout._errors import InputError
from robolayout._text import TOLD
from robolayout.cli.options import ForBody, Told, names, spread
from robolayout.cli.terminal import bulleted, say, table, warn

if TYPE_CHECKING:
    from robolayout.many.dataset import Progress

EVERY = 30.0  # seconds between two lines about the progress where nobody looks at a terminal

Workers = Annotated[int, Option(min=1, max=1024, help="Rooms at the same time.")]


@spread
def batch(  # noqa: PLR0913 - one parameter per option
    spec: Annotated[str, Argument(help="A SPEC file (TOML), one room in words, or a scene file.")],
    out: Annotated[Path, Option(help="Folder of the data set: new, or one of the same SPEC to go on with.")],
    told: Told,
    count: Annotated[int | None, Option(min=1, help="Rooms in all.")] = None,
    seed: Annotated[int | None, Option(min=0, help="Settles every choice.")] = None,
    keys: Annotated[
        list[str] | None, Option("--set", metavar="KEY=VALUE", help="Any key of the SPEC; may be repeated.")
    ] = None,
    keep_unmet: Annotated[bool, Option("--keep-unmet", help="Keep rooms that do not meet their demands.")] = False,
    workers: Workers = 1,
    cluster: Annotated[str | None, Option(help="ray: make rooms as tasks of a Ray cluster.")] = None,
    address: Annotated[str | None, Option(help="Of the cluster, HOST:PORT; without it one is started here.")] = None,
) -> None:
    """Make a data set of many rooms, or go on with one."""
    from robolayout.many import batch as make
    from robolayout.many import read_spec
    from robolayout.many.spec import value_of

    if cluster not in (None, "ray"):
        raise InputError(f"--cluster {cluster!r} is not known: it is ray, or left out.")
    if address and not cluster:
        raise InputError("--address is that of a cluster: give --cluster ray with it, or leave it out.")
    changes: dict[str, Any] = {"count": count, "seed": seed, "keep_unmet": keep_unmet or None}
    for given in keys or ():
        changes |= value_of(given)
    ready = read_spec(spec, **{key: value for key, value in changes.items() if value is not None})
    with told.progress() as tell:
        lines = _lines(tell, quiet=told.quiet or told.as_json)
        found = make(ready, out, workers=workers, cluster=(address or "local") if cluster else None, progress=lines)

    def show() -> None:
        say(f"{found.met} of {found.rooms} rooms meet all their demands.")
        if found.unmet:
            say(f"{found.unmet} do not, and were kept.")
        bulleted([f"room {index} was given up: {why}" for index, why in found.missing.items()], "index")
        if found.replaced:
            rows = [[str(number), why] for why, number in list(found.replaced.items())[: TOLD.shown]]
            table(f"{sum(found.replaced.values())} tries were replaced", ["", "why"], rows)
        files = ("index.csv", "index.parquet", "index.html", "contact.png", "README.md")
        say(*(str(found.folder / name) for name in files))

    told.tell({**vars(found), "folder": str(found.folder)}, show)
    raise typer.Exit(0 if found.ok else 1)


def _lines(tell: Callable[[str], None], *, quiet: bool) -> Callable[[Progress], None]:
    """Return what shows the progress: on a terminal always, elsewhere a line now and then."""
    last = monotonic()

    def told(now: Progress) -> None:
        nonlocal last
        tell(str(now))
        if not quiet and not sys.stderr.isatty() and monotonic() - last > EVERY:
            last = monotonic()
            warn(str(now))

    return told


@spread
def evaluate(  # noqa: PLR0913 - one parameter per option
    folder: Annotated[Path, Argument(help="A folder of rooms: runs, a batch, scenes with layouts, scene states.")],
    body: ForBody,
    told: Told,
    against: Annotated[Path | None, Option(help="Another folder, paired with it by name.")] = None,
    by: Annotated[str, Option(help="Group by what a batch drew, such as solver,reach.")] = "",
    scenes: Annotated[Path | None, Option(help="Folder of the scene files, if elsewhere.")] = None,
    out: Annotated[Path | None, Option(help="Also write tables and a page with plots here.")] = None,
    workers: Workers = 1,
) -> None:
    """Measure every room of a folder, whoever made it."""
    from robolayout._files import check_writable
    from robolayout.many import evaluate as measure
    from robolayout.many import write_evaluation

    if out is not None:
        check_writable(out)
    where = {"against": against, "scenes": scenes, **vars(body)}
    with told.progress() as tell:
        found = measure(folder, by=names(by), workers=workers, progress=tell, **where)
    files = [] if out is None else write_evaluation(found, out)
    for name, why in found.skipped.items():
        warn(f"warning: {name} was not read: {why}")
    data = {"rows": found.rows, "skipped": found.skipped}
    told.tell(data, lambda: say(*found.to_markdown().splitlines(), *map(str, files)))
    raise typer.Exit(0 if found.rows and not found.skipped else 1)
