"""Classrooms and lecture rooms."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, board, four
from robolayout.assets.palette import (
    BLACK,
    BLUE,
    BRIGHT,
    CORK,
    DARK,
    GREEN,
    IVORY,
    LIGHT_GREY,
    PAPER,
    RED,
    SLATE,
    STEEL,
    WHITE,
    YELLOW,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, sheared, slab


def student_desk(p: Piece) -> Iterator[Part]:
    """Yield a pupil's desk: a top over a book shelf on steel legs."""
    yield board(p, p.wood, (p.h - 0.025, p.h))
    yield box(
        "shelf", p.front, (p.x[0] + 0.05, p.x[1] - 0.06), (p.y[0] + 0.05, p.y[1] - 0.05), (p.h - 0.16, p.h - 0.145)
    )
    yield box(
        "back", p.front, (p.x[0] + 0.035, p.x[0] + 0.05), (p.y[0] + 0.05, p.y[1] - 0.05), (p.h - 0.16, p.h - 0.025)
    )
    yield from four(p, STEEL, p.h - 0.025, thick=0.03, inset=0.015)
    yield box("books", BRIGHT[p.variant % 5], (p.x[0] + 0.08, p.x[1] - 0.1), (-0.1, 0.1), (p.h - 0.145, p.h - 0.09))


def whiteboard(p: Piece) -> Iterator[Part]:
    """Yield a board with frame, tray and some writing: white, black or cork."""
    dark, cork = p.kind == "blackboard", p.kind == "bulletin board"
    field = SLATE if dark else CORK if cork else WHITE
    frame = p.wood if dark or cork else STEEL
    back, b = p.x[0] + 0.4 * p.d, 0.03
    yield box("board", field, (p.x[0], back), (p.y[0] + b, p.y[1] - b), (b, p.h - b))
    for y in ((p.y[0], p.y[0] + b), (p.y[1] - b, p.y[1])):
        yield box("frame", frame, (p.x[0], back + 0.004), y, p.z)
    for z in ((0.0, b), (p.h - b, p.h)):
        yield box("frame", frame, (p.x[0], back + 0.004), (p.y[0] + b, p.y[1] - b), z)
    if not cork:
        yield box("tray", frame, (back + 0.004, p.x[1]), (-0.3 * p.w, 0.3 * p.w), (0.004, 0.02))
    yield from _notes(p, back, cork, dark)


def _notes(p: Piece, face: float, cork: bool, dark: bool) -> Iterator[Part]:
    """Yield notes pinned on cork, or lines of writing."""
    rng = p.rng()
    if cork:
        columns = max(2, round(p.w / 0.24))
        for i in range(columns):
            y, z = p.y[0] + (i + 0.5) * p.w / columns, p.h * rng.uniform(0.35, 0.62)
            tone = (PAPER, YELLOW, BLUE, PAPER, GREEN)[i % 5]
            yield box("note", tone, (face, face + 0.1 * p.d), (y - 0.07, y + 0.07), (z - 0.1, z + 0.1))
            yield box("pin", RED, (face + 0.1 * p.d, p.x[1]), (y - 0.008, y + 0.008), (z + 0.07, z + 0.086))
        return
    for i in range(4):
        z = p.h * (0.78 - 0.13 * i)
        y0 = -0.36 * p.w
        yield box(
            "writing",
            IVORY if dark else (BLUE, RED, BLUE, GREEN)[i],
            (face, face + 0.001 + 0.01 * p.d),
            (y0, y0 + p.w * rng.uniform(0.2, 0.42)),
            (z, z + 0.018),
        )


def lectern(p: Piece) -> Iterator[Part]:
    """Yield a lectern; the speaker stands behind it, the audience at +x."""
    yield box("foot", p.dark, p.x, (0.9 * p.y[0], 0.9 * p.y[1]), (0.0, 0.04))
    yield box("column", p.wood, (-0.2 * p.d, 0.3 * p.d), (-0.34 * p.w, 0.34 * p.w), (0.04, 0.8 * p.h))
    top = box("desk", p.dark, (0.96 * p.x[0], 0.9 * p.x[1]), p.y, (0.8 * p.h, 0.83 * p.h))
    top.vertices[:, 2] += (top.vertices[:, 0] - p.x[0]) / p.d * 0.12 * p.h
    yield top
    yield box("emblem", p.accent, (0.3 * p.d, 0.32 * p.d), (-0.14 * p.w, 0.14 * p.w), (0.5 * p.h, 0.68 * p.h))
    yield cylinder("microphone", BLACK, (0.3 * p.d, 0.0), 0.012, (0.88 * p.h, p.h), sides=8)


def stage(p: Piece) -> Iterator[Part]:
    """Yield a low platform with a step."""
    yield box("deck", p.wood, (p.x[0], 0.36 * p.d), p.y, (0.0, p.h))
    yield box("edge", p.dark, (0.36 * p.d, 0.36 * p.d + 0.02), p.y, (0.0, p.h - 0.003))
    yield box("step", p.wood, (0.36 * p.d + 0.02, p.x[1]), (-0.3 * p.w, 0.3 * p.w), (0.0, 0.5 * p.h))


def flip_chart(p: Piece) -> Iterator[Part]:
    """Yield an easel with a pad."""
    for y in (-0.4 * p.w, 0.4 * p.w):
        yield sheared(
            "leg",
            p.metal,
            (p.x[1] - 0.025, p.x[1]),
            (y - 0.012, y + 0.012),
            (0.0, 0.98 * p.h),
            lean=(-0.5 * p.d, -0.2 * y),
        )
    yield sheared("stay", p.metal, (p.x[0], p.x[0] + 0.025), (-0.012, 0.012), (0.0, 0.9 * p.h), lean=(0.45 * p.d, 0.0))
    yield sheared("board", WHITE, (0.26 * p.d, 0.26 * p.d + 0.015), p.y, (0.42 * p.h, p.h), lean=(-0.24 * p.d, 0.0))
    yield sheared(
        "pad",
        PAPER,
        (0.26 * p.d + 0.016, 0.26 * p.d + 0.03),
        (0.9 * p.y[0], 0.9 * p.y[1]),
        (0.46 * p.h, 0.98 * p.h),
        lean=(-0.215 * p.d, 0.0),
    )


def lab_bench(p: Piece) -> Iterator[Part]:
    """Yield a laboratory bench with a sink."""
    top = p.h - 0.003
    yield box("plinth", BLACK, (p.x[0] + 0.06, p.x[1] - 0.06), (p.y[0] + 0.06, p.y[1] - 0.06), (0.0, 0.08))
    yield box("cabinets", p.front, (p.x[0] + 0.03, p.x[1] - 0.03), (p.y[0] + 0.03, p.y[1] - 0.03), (0.08, top - 0.04))
    yield box("top", DARK, p.x, p.y, (top - 0.04, top))
    yield box("sink", LIGHT_GREY, (-0.24 * p.d, 0.24 * p.d), (0.26 * p.w, 0.44 * p.w), (top, p.h))


def skeleton(p: Piece) -> Iterator[Part]:
    """Yield a simple skeleton on a stand."""
    yield cylinder("foot", DARK, (0.0, 0.0), 0.46 * p.d, (0.0, 0.03), sides=14)
    yield cylinder("pole", STEEL, (-0.06, 0.0), 0.012, (0.03, 0.9 * p.h), sides=6)
    yield ball("skull", IVORY, (-0.09, 0.11), (-0.08, 0.08), (0.86 * p.h, p.h), rings=4)
    yield cylinder("spine", IVORY, (0.0, 0.0), 0.022, (0.52 * p.h, 0.87 * p.h), sides=8)
    for i in range(5):
        z = (0.64 + 0.04 * i) * p.h
        yield box("rib", IVORY, (-0.07, 0.08), (-0.3 * p.w, 0.3 * p.w), (z, z + 0.016 * p.h))
    yield slab("pelvis", IVORY, (-0.06, 0.07), (-0.16 * p.w, 0.16 * p.w), (0.5 * p.h, 0.57 * p.h), top=(1.2, 1.6))
    for y in (-0.16 * p.w, 0.16 * p.w):
        yield cylinder("leg", IVORY, (0.0, y), 0.02, (0.06 * p.h, 0.52 * p.h), sides=8)
        yield cylinder("arm", IVORY, (0.0, 2.8 * y), 0.018, (0.42 * p.h, 0.8 * p.h), sides=8)
    yield box("shoulders", IVORY, (-0.02, 0.02), p.y, (0.79 * p.h, 0.815 * p.h))


def microscope(p: Piece) -> Iterator[Part]:
    """Yield a microscope."""
    yield box("foot", DARK, p.x, p.y, (0.0, 0.1 * p.h))
    yield box("arm", LIGHT_GREY, (p.x[0], p.x[0] + 0.3 * p.d), (-0.2 * p.w, 0.2 * p.w), (0.1 * p.h, 0.78 * p.h))
    yield box("stage", BLACK, (p.x[0] + 0.3 * p.d, 0.4 * p.d), (-0.4 * p.w, 0.4 * p.w), (0.32 * p.h, 0.37 * p.h))
    yield cylinder("tube", LIGHT_GREY, (0.06 * p.d, 0.0), 0.16 * p.w, (0.5 * p.h, 0.86 * p.h), sides=12)
    yield cylinder("lens", STEEL, (0.06 * p.d, 0.0), (0.05 * p.w, 0.12 * p.w), (0.4 * p.h, 0.5 * p.h), sides=10)
    yield cylinder("eyepiece", BLACK, (0.06 * p.d, 0.0), 0.1 * p.w, (0.86 * p.h, p.h), sides=10)
    yield box("bridge", LIGHT_GREY, (p.x[0] + 0.3 * p.d, 0.0), (-0.12 * p.w, 0.12 * p.w), (0.66 * p.h, 0.74 * p.h))


BUILDERS: dict[str, Builder] = {
    "student desk": student_desk,
    "whiteboard": whiteboard,
    "blackboard": whiteboard,
    "bulletin board": whiteboard,
    "lectern": lectern,
    "host stand": lectern,
    "stage": stage,
    "flip chart": flip_chart,
    "lab bench": lab_bench,
    "microscope": microscope,
    "skeleton model": skeleton,
}
