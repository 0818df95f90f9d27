"""The furniture list of a sheet: a number for everything that stands, hangs or lies, what stands on what, and sizes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

from robolayout.render._schedule import Row
from robolayout.scene import Asset, Layout, Scene


@dataclass(frozen=True)
class Furniture:
    """What a sheet says of the things in a room."""

    # the number of each thing that has one; equal things have numbers that follow each other
    numbers: Mapping[str, int]
    carriers: Mapping[str, str]  # for each thing without a number, the numbered one that carries it
    rows: tuple[Row, ...]  # the list


def furniture(scene: Scene, layout: Layout, below: Mapping[str, str]) -> Furniture:
    """Return the numbers and the list of everything in a scene; what stands on another thing (`below`) is listed with it."""
    carriers = {name: _lowest(name, below) for name in below}
    kinds: dict[tuple[str, tuple[float, ...]], list[Asset]] = {}
    for asset in scene.assets:
        kinds.setdefault((asset.category, asset.size), []).append(asset)
    order = [asset for kind in kinds.values() for asset in kind]
    numbered = [asset for asset in order if asset.name in layout and asset.name not in carriers]
    numbers = {asset.name: number for number, asset in enumerate(numbered, 1)}
    rows = [_row(found, spans([numbers[a.name] for a in found]), "") for found in _kinds(numbered)]
    for found in _kinds([asset for asset in order if asset.name in carriers]):
        on = spans(sorted({numbers[carriers[asset.name]] for asset in found}))
        rows.append(_row(found, "", f"on {on}"))
    rows += [_row(found, "-", "not placed") for found in _kinds([a for a in order if a.name not in layout])]
    return Furniture(numbers, carriers, tuple(rows))


def spans(numbers: Sequence[int]) -> str:
    """Return rising numbers in words: "3", "4-9, 12"."""
    runs: list[list[int]] = []
    for number in numbers:
        if runs and runs[-1][-1] == number - 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    return ", ".join(str(run[0]) if len(run) == 1 else f"{run[0]}-{run[-1]}" for run in runs)


def centimetres(metres: float) -> str:
    """Return a length in whole centimetres, below 10 cm to a millimetre."""
    return f"{100 * metres:.0f}" if metres >= 0.1 else f"{round(100 * metres, 1):g}"


def _kinds(assets: Sequence[Asset]) -> list[list[Asset]]:
    """Return neighbours of one category and size together."""
    return [list(found) for _, found in groupby(assets, lambda asset: (asset.category, asset.size))]


def _row(found: Sequence[Asset], mark: str, note: str) -> Row:
    asset = found[0]
    depth, width, height = map(centimetres, asset.size)
    count = f"{len(found)} x " if len(found) > 1 and not mark.isdigit() else ""
    words = f"{count}{asset.category or asset.name}" + (f", {note}" if note else "")
    return Row(words, mark, f"{width} x {depth} x {height}")


def _lowest(name: str, below: Mapping[str, str]) -> str:
    """Return what carries a thing in the end; each step leads lower, so that there is an end."""
    while name in below:
        name = below[name]
    return name
