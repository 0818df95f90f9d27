"""The report for people: Markdown for the folder of a run, HTML for notebooks."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from robolayout._text import TOLD, bullets, paragraph, table
from robolayout._text import markdown as plain
from robolayout.verify.agent_report import AgentReport
from robolayout.verify.limits import JUDGE
from robolayout.verify.use import Use
from robolayout.words import AskedRow

if TYPE_CHECKING:
    from robolayout.verify.report import Report

LABELS = {"reachable_share": "reachable as it stands", "reachable_share_chairs_aside": "reachable with chairs aside"}
"""Names of figures for people, where they are not the keys."""

VERDICTS = {True: "ok", False: "short", None: "-"}  # of a figure; of one that nobody demands there is none


def shown(share: float) -> str:
    """Return a share, rounded down: what is short of a limit does not read as if it met it."""
    return f"{math.floor(100.0 * share + 1e-9) / 100:.2f}"


def label(name: str) -> str:
    """Return what a figure is called for people: "door_clear" is "door clear", "placed_share" is "placed"."""
    return LABELS.get(name) or name.removesuffix("_share").replace("_", " ")


RULES_ARE = "They stand beside the demands above and do not change them."  # what is said over the table of rules


def rule_rows(report: Report) -> list[list[str]]:
    """Return the table of named rules: rule (with its body where there are several), what it asks, what came out, source."""
    several = len(report.agents) > 1
    names = [r.rule.name.replace("_", " ") + (f", {r.agent}" if several else "") for r in report.rules]
    told = [[r.rule.asks, r.measured.text, "met" if r.met else "not met", r.rule.origin] for r in report.rules]
    return [[name, *cells] for name, cells in zip(names, told, strict=True)]


def _told(report: Report) -> list[str]:
    """Return what is said below the table: chairs that are moved aside, wishes, what lies about, notes."""
    told: list[str] = []
    if report.figures["reachable_share"] != report.figures["reachable_share_chairs_aside"]:
        told.append(
            "As it stands, no chair is moved; demanded is what is reached once the chairs at a thing are moved aside."
        )
    if wishes := report.wishes:
        granted = sum(wish["holds"] == (wish["weight"] > 0) for wish in wishes)
        told.append(f"Of {len(wishes)} wishes of the program, which nobody demands, {granted} came true.")
    return [line for text in (*told, *lying_about(report), *report.notes) for line in ("", text)]


def lying_about(report: Report) -> list[str]:
    """Return how many small things lie about and how many of them are fetched, in a sentence; nothing where none do."""
    if not report.dressing:
        return []
    can = " and ".join(f"{name} can fetch {count}" for name, count in report.dressing["fetched"].items())
    return [f"{report.dressing['things']} small things lie about: {can} of them."]


def markdown(report: Report) -> str:
    """Return the content of `report.md`: the table, what is wrong, and the way to each asset."""
    lines = [f"# {plain(report.scene.name)}: {report.verdict}", ""]
    lines += _ledger(report.asked)
    lines += ["| check | result | |", "|---|---:|---|"]
    lines += [
        f"| {name} | {value} | {VERDICTS[met].replace('short', '**short**')} |" for name, value, met in report.rows()
    ]
    lines += _told(report)
    rules = [f"| {' | '.join(map(plain, row))} |" for row in rule_rows(report)]
    head = [RULES_ARE, "", "| rule | asks | measured | | source |", "|---|---|---|---|---|"]
    sections = [
        ("What is wrong", _listed(report.violations)),
        ("Rules of accessibility", [*head, *rules] if rules else rules),
        ("What would help", _listed(line for body in report.agents for line in body.remedies.sentences(body.agent))),
        ("In a simulator", _stability(report.stability) if report.stability else []),
        ("What was moved from its guess", _listed(move.sentence for move in report.moved)),
        *((plain(body.agent.title or body.agent.name), _agent_table(body)) for body in report.agents),
        ("What a model thinks", _listed(report.opinion.get("sentences", ()))),
        ("Who planned", _listed(report.planner.get("sentences", ()))),
    ]
    lines += [line for title, told in sections if told for line in ("", f"## {title}", "", *told)]
    return "\n".join(lines) + "\n"


def html(report: Report) -> str:
    """Return the short table and the first things that are wrong as HTML."""
    bodies = ", ".join(body.agent.title or body.agent.name for body in report.agents)
    rows = [[name, value, VERDICTS[met]] for name, value, met in report.rows()]
    head = paragraph(f"{report.scene.name} for {bodies}: {report.verdict}")
    asked = [[row.words, row.understanding, row.verdict, row.value] for row in report.asked]
    head += table(["words", "understood as", "verdict", "measured"], asked) if asked else ""
    rules = table(["rule", "asks", "measured", "", "source"], rule_rows(report)) if report.rules else ""
    return head + table(["check", "result", ""], rows) + bullets(report.violations, TOLD.shown) + rules


def _ledger(asked: Sequence[AskedRow]) -> list[str]:
    """Return the table of what the user asked."""
    if not asked:
        return []
    lines = ["## What was asked", "", "| words | understood as | verdict | measured |", "|---|---|---|---|"]
    cells = ((row.words, row.understanding, row.verdict, row.value) for row in asked)
    lines += [f"| {' | '.join(plain(' '.join(text.split())) for text in row)} |" for row in cells]
    return [*lines, "", "## What was checked", ""]


def _listed(sentences: Iterable[str]) -> list[str]:
    return [f"- {plain(sentence)}" for sentence in sentences]


def _stability(found: Mapping[str, Any]) -> list[str]:
    """Return what gravity did, in a sentence and one for each asset that did not stay."""
    head = f"After {found['seconds']:g} s of gravity, {found['stable_share']:.2f} of the assets stay where they are."
    return [head, *_listed(found["violations"])]


def _driving(report: AgentReport) -> list[str]:
    """Return what a rectangular body drives to, and after how many reversals."""
    if not report.drives:
        return []
    back = {name: drive.reversals for name, drive in report.drives.items() if drive.reversals}
    times = ", ".join(f"{plain(name)} {count}" for name, count in back.items())
    how = f"; reversals: {times}" if times else ", without a reversal"
    return [f"It drives to {len(report.drives)} things{how}."]


def _usable(use: Use) -> str:
    """Return whether an asset can be used, and what has to be moved for it."""
    if not use.usable:
        return "**no**"
    how = f"yes, {use.approach}" if use.approach else "yes"
    return f"{how}, {plain(' and '.join(use.moved))} moved" if use.moved else how


def _agent_table(report: AgentReport) -> list[str]:
    nav = report.navigation
    figures = [f"{label(name)} {shown(value)}" for name, value in report.figures.items()]
    lines = [f"{', '.join(figures)}."]
    if not nav.scene.room.doors:
        lines.append(f"The room has no door: {plain(report.agent.name)} starts in the largest free part of the floor.")
    largest, needed = report.remedies.largest_disc, 2 * report.agent.radius
    if largest > 0:
        more = " or more" if largest >= JUDGE.wide - 1e-9 else ""
        lines.append(
            f"The widest disc that reaches everything asked is {largest:.2f} m{more}; this body needs {needed:.2f} m."
        )
    if report.headings is not None:
        turns = len(report.headings.turning.geoms)
        lines.append(f"It can turn right round in {turns} {'place' if turns == 1 else 'places'}.")
        lines += _driving(report)
    lines += ["", "| asset | reached | route | narrowest passage | between | usable |"]
    lines.append("|---|---|---:|---:|---|---|")
    for name, passage in nav.passages.items():
        route = nav.routes.get(name)
        length = f"{route.length:.1f} m" if route else "-"
        between = plain(passage.sides) or "-"
        reached = "yes" if nav.reached[name] else "**no**"
        usable = _usable(report.usage.uses[name])
        lines.append(f"| {plain(name)} | {reached} | {length} | {passage.shown} | {between} | {usable} |")
    by_name = nav.scene.by_name
    aside = [reason for name, reason in report.exempt.items() if not by_name[name].lies_about]
    if aside:
        lines += ["", *_listed(f"not asked: {reason}." for reason in aside)]
    return lines
