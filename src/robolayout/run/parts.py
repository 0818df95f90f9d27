"""Programs of groups: what one says about its own group, and all of them as one program."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from robolayout._text import printable
from robolayout.planners import Group
from robolayout.program import Guess, Program, Statement
from robolayout.scene import Scene


def about(program: Program, group: Group, here: Scene, before: tuple[Statement, ...]) -> Program:
    """Return what a program says about a group and things already there, after the earlier groups' statements."""
    mine = set(group.items)
    new = [statement for statement in program.statements if _concerns(statement, mine, here)]
    numbered = tuple(replace(statement, number=i) for i, statement in enumerate((*before, *new), 1))
    guesses = {name: guess for name, guess in program.guesses.items() if name in mine}
    wishes = tuple(wish for wish in program.wishes if _concerns(wish, mine, here))
    return replace(program, statements=numbered, wishes=wishes, guesses=guesses)


def joined(parts: Sequence[tuple[Group, Program]]) -> Program:
    """Return one program that says what the groups' programs say, in plain statements under a heading for each group."""
    lines: list[str] = []
    statements, wishes = list[Statement](), list[Statement]()
    guesses: dict[str, Guess] = {}
    for group, part in parts:
        heading = printable(f"{group.label}: {group.rationale}")
        lines.append(f"# {heading.strip(': ')}")
        lines += part.to_text().splitlines()
        own = (*part.statements, *part.wishes)
        for line, statement in enumerate(own, len(lines) - len(own) + 1):
            kept = statements if statement.wish is None else wishes
            kept.append(replace(statement, line=line, source=lines[line - 1], number=len(kept) + 1))
        guesses |= part.guesses
    text = "".join(f"{line}\n" for line in lines)
    expressions = {name: text for _, part in parts for name, text in part.expressions.items()}
    notes = tuple(note for _, part in parts for note in part.notes)
    dropped = tuple(message for _, part in parts for message in part.dropped)
    return Program(text, tuple(statements), guesses, notes, dropped, expressions, tuple(wishes))


def _concerns(statement: Statement, mine: set[str], here: Scene) -> bool:
    """Return whether a statement is about things of a group, and about nothing that is not there yet."""
    names = set(statement.relation.asset_names())
    return bool(names & mine) and names <= set(here.by_name)


def strays(program: Program, group: Group, here: Scene) -> Iterator[str]:
    """Yield what is wrong with statements of a program that are left out because of the things that they are about."""
    mine = set(group.items)
    for statement in program.statements:
        if not _concerns(statement, mine, here):
            later = [n for n in statement.relation.asset_names() if n not in here.by_name]
            names = ", ".join(program.expressions.get(name, name) for name in later)
            reason = f"{names} comes later" if later else "it is not about a thing of this group"
            yield f"line {statement.line}: {statement.source}: {reason}."
