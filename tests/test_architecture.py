"""The house rules of DESIGN section 2 and STYLE section 5, read from the source with `ast`.

Every failure names file, line and rule. The rules themselves are tested on small sources at the end of the file.
"""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
SOURCE = ROOT / "src"
PACKAGE = SOURCE / "robolayout"
FILES = sorted(PACKAGE.rglob("*.py"))

STATIONS = ("planners", "solve", "verify", "render", "export")
LAYERS: dict[str, float] = {
    "_errors": 0,
    "_version": 0,
    "_text": 0,
    "_color": 0,
    "_lazy": 0,
    "_files": 0.5,
    "_geometry": 0,
    "_grid": 0,
    "_reading": 0.5,
    "scene": 1,
    "assets": 2,
    "floor": 3,
    "constraints": 3,
    "program": 4,
    "words": 4.5,
    **dict.fromkeys(STATIONS, 5),
    "page": 6,
    "run": 7,
    "many": 7.5,
    "": 8,  # the package's own page, which shows them all
    "cli": 9,
    "__main__": 10,
}
FORBIDDEN = dict.fromkeys(
    [("verify", "_geometry"), ("verify", "floor")], "the judge shares no mathematics with the solver"
)
MAX_FUNCTION, MAX_FILE = 60, 450
BANNED_CALLS = ("print", "exec", "eval", "compile", "__import__", "breakpoint", "input")
BROAD = ("Exception", "BaseException")
EDGES = {"render/_gl.py": 1, "cli/guard.py": 1}
"""Files that may catch everything, and how often: the GL loader raises plain Exception where there is no EGL; the
command line ends whatever happens in one sentence."""


@dataclass(frozen=True)
class Import:
    """One import of a module of this package."""

    line: int
    module: str
    lazy: bool


def module_name(path: Path, root: Path = SOURCE) -> str:
    """Return the dotted name of a file."""
    parts = path.relative_to(root).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def layer(module: str) -> str:
    """Return the folder or file directly under the package that a module belongs to."""
    return module.split(".")[1] if "." in module else ""


def parse(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"), filename=str(path))


def imports(tree: ast.Module, module: str, is_package: bool, known: frozenset[str]) -> Iterator[Import]:
    """Yield every import of this package's modules; `lazy` are those in functions or for type checking only."""
    lazy_nodes: set[int] = set()
    for node in ast.walk(tree):
        checking = isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test)
        if checking or isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)):
            lazy_nodes |= {id(child) for child in ast.walk(node)}
    for node in ast.walk(tree):
        lazy = id(node) in lazy_nodes
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            parents = module.split(".")[: None if is_package else -1]
            base = ".".join(parents[: len(parents) - node.level + 1]) if node.level else ""
            origin = ".".join(part for part in (base, node.module) if part)
            names = [f"{origin}.{a.name}" if f"{origin}.{a.name}" in known else origin for a in node.names]
        elif isinstance(node, ast.Constant) and node.value in known - {"robolayout"}:
            names, lazy = [str(node.value)], True  # the name of a module that is imported later
        else:
            continue
        for name in dict.fromkeys(names):
            if name.split(".")[0] == "robolayout":
                yield Import(node.lineno, name, lazy)


def layering(module: str, found: list[Import]) -> Iterator[tuple[int, str]]:
    """Yield (line, rule) for every import that runs against the layers."""
    here = layer(module)
    if here not in LAYERS:
        yield 1, f"{here!r} has no place in the order of imports; give it one in tests/test_architecture.py"
        return
    for item in found:
        there = layer(item.module)
        if there not in LAYERS:
            yield item.line, f"imports {item.module}, which has no place in the order of imports"
        elif here == there:
            continue
        elif here in STATIONS and there in STATIONS:
            yield item.line, f"{here} imports {there}: stations never import each other"
        elif (here, there) in FORBIDDEN:
            yield item.line, f"{here} imports {there}: {FORBIDDEN[here, there]}"
        elif there != "_errors" and LAYERS[there] >= LAYERS[here]:
            yield item.line, f"{here} imports {there or 'the package itself'}, which is not below it"


def form(tree: ast.Module, lines: int) -> Iterator[tuple[int, str]]:
    """Yield (line, rule) for everything that breaks the rules of form."""
    if lines > MAX_FILE:
        yield lines, f"file has {lines} lines, at most {MAX_FILE}"
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            length = (node.end_lineno or node.lineno) - node.lineno + 1
            if length > MAX_FUNCTION:
                yield node.lineno, f"function {node.name} has {length} lines, at most {MAX_FUNCTION}"
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in BANNED_CALLS:
            yield node.lineno, f"{node.func.id}() is banned in the package"
        elif isinstance(node, ast.ExceptHandler):
            names = {n.id for n in ast.walk(node.type) if isinstance(n, ast.Name)} if node.type else {"nothing"}
            if names & {"nothing", *BROAD}:
                yield node.lineno, "catches everything; name the exceptions"
        elif isinstance(node, ast.Global):
            yield node.lineno, f"changes global state: {', '.join(node.names)}"


def undocumented(node: ast.Module | ast.ClassDef, path: str = "module") -> Iterator[tuple[int, str]]:
    """Yield (line, rule) for every public thing without a docstring."""
    if ast.get_docstring(node) is None:
        yield getattr(node, "lineno", 1), f"{path} has no docstring"
    for child in node.body:
        if isinstance(child, ast.ClassDef) and not child.name.startswith("_"):
            yield from undocumented(child, f"class {child.name}")
        elif isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef)) and not child.name.startswith("_"):
            overload = any("overload" in ast.unparse(d) or "setter" in ast.unparse(d) for d in child.decorator_list)
            if ast.get_docstring(child) is None and not overload:
                yield child.lineno, f"function {child.name} has no docstring"


def cycle(graph: dict[str, set[str]]) -> list[str]:
    """Return one cycle of a graph as a list of names, or an empty list."""
    done: set[str] = set()
    for start in sorted(graph):
        path: list[str] = []
        waiting = [(start, iter(sorted(graph[start])))] if start not in done else []
        path += [start] * bool(waiting)
        while waiting:
            name, rest = waiting[-1]
            following = next(rest, None)
            if following is None:
                done.add(name)
                waiting.pop()
                path.pop()
            elif following in path:
                return [*path[path.index(following) :], following]
            elif following not in done:
                path.append(following)
                waiting.append((following, iter(sorted(graph.get(following, ())))))
    return []


KNOWN = frozenset(module_name(path) for path in FILES)


def imports_of(path: Path) -> list[Import]:
    return list(imports(parse(path), module_name(path), path.name == "__init__.py", KNOWN))


def fail_on(path: Path, problems: list[tuple[int, str]]) -> None:
    if problems:
        pytest.fail("\n".join(f"{path.relative_to(ROOT)}:{line}: {rule}" for line, rule in problems), pytrace=False)


by_file = pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(PACKAGE)))


@by_file
def test_imports_follow_the_layers(path: Path) -> None:
    fail_on(path, list(layering(module_name(path), imports_of(path))))


@by_file
def test_form(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    problems = list(form(ast.parse(text), len(text.splitlines())))
    broad = [problem for problem in problems if "catches everything" in problem[1]]
    if len(broad) <= EDGES.get(str(path.relative_to(PACKAGE)), 0):
        problems = [problem for problem in problems if problem not in broad]
    fail_on(path, problems)


@by_file
def test_public_things_are_documented(path: Path) -> None:
    fail_on(path, list(undocumented(parse(path))))


@pytest.mark.slow
def test_each_class_name_stands_for_one_class() -> None:
    named: dict[str, list[str]] = {}
    for path in FILES:
        for node in parse(path).body:
            if isinstance(node, ast.ClassDef):
                named.setdefault(node.name, []).append(str(path.relative_to(PACKAGE)))
    assert {name: paths for name, paths in named.items() if len(paths) > 1} == {}


def test_no_import_cycles() -> None:
    graph = {module_name(path): {i.module for i in imports_of(path) if not i.lazy} for path in FILES}
    found = cycle({name: {n for n in targets if n != name} for name, targets in graph.items()})
    assert not found, f"import cycle: {' -> '.join(found)}"


def has_variant(tree: ast.Module, folder: str) -> bool:
    """Return whether a module defines a relation or an exporter."""
    if folder == "constraints":
        classes = [node for node in tree.body if isinstance(node, ast.ClassDef)]
        return any(ast.unparse(base).endswith("Relation") for node in classes for base in node.bases)
    values = [node.value for node in tree.body if isinstance(node, (ast.Assign, ast.AnnAssign))]
    return any(isinstance(value, ast.Call) and ast.unparse(value.func) == "Exporter" for value in values)


@pytest.mark.parametrize(("folder", "least"), [("constraints", 20), ("export", 4)])
def test_every_variant_has_its_line_in_the_folder(folder: str, least: int) -> None:
    page = PACKAGE / folder / "__init__.py"
    text = page.read_text(encoding="utf-8")
    files = [path for path in sorted((PACKAGE / folder).glob("*.py")) if not path.stem.startswith("_")]
    variants = [path.stem for path in files if has_variant(parse(path), folder)]
    assert len(variants) >= least
    missing = [name for name in variants if not re.search(rf"\b{name}\b", text)]
    assert not missing, f"{page.relative_to(ROOT)}: has no line for {', '.join(missing)}"


KNOWN_HERE = frozenset(
    {"robolayout", "robolayout.scene", "robolayout.scene.room", "robolayout.solve", "robolayout.verify"}
)


def broken(source: str, module: str = "robolayout.verify.x") -> list[tuple[int, str]]:
    """Return what the rules say about a source text."""
    tree = ast.parse(source)
    found = list(imports(tree, module, False, KNOWN_HERE))
    return [*layering(module, found), *form(tree, source.count("\n") + 1)]


@pytest.mark.parametrize(
    ("source", "line", "rule"),
    [
        ("import json\nfrom robolayout.solve import x", 2, "verify imports solve: stations never import each other"),
        ("from robolayout import solve", 1, "verify imports solve: stations never import each other"),
        ("from ..solve import x", 1, "verify imports solve: stations never import each other"),
        ("def f():\n    import robolayout.solve.search", 2, "verify imports solve: stations never import each other"),
        (
            "if TYPE_CHECKING:\n    from robolayout.run import x",
            2,
            "verify imports run, which is not below it",
        ),
        (
            "from robolayout._geometry import x",
            1,
            "verify imports _geometry: the judge shares no mathematics with the solver",
        ),
        ("from robolayout import Scene", 1, "verify imports the package itself, which is not below it"),
        (
            "from robolayout.gadgets import x",
            1,
            "imports robolayout.gadgets, which has no place in the order of imports",
        ),
        ("import_module('robolayout.solve')", 1, "verify imports solve: stations never import each other"),
        ("print(1)", 1, "print() is banned in the package"),
        ("x = 1\neval('x')", 2, "eval() is banned in the package"),
        ("try:\n    pass\nexcept:\n    pass", 3, "catches everything; name the exceptions"),
        ("try:\n    pass\nexcept (ValueError, Exception):\n    pass", 3, "catches everything; name the exceptions"),
        ("def f():\n    global x", 2, "changes global state: x"),
        ("def f():\n" + "    pass\n" * 60, 1, "function f has 61 lines, at most 60"),
        ("\n" * 450, 451, "file has 451 lines, at most 450"),
    ],
)
def test_a_broken_rule_is_found(source: str, line: int, rule: str) -> None:
    assert broken(source) == [(line, rule)]


def test_what_the_rules_allow() -> None:
    assert broken("from robolayout._errors import x\nfrom robolayout.scene import room\nconsole.print(1)") == []
    assert broken("from .y import z") == []


def test_a_module_without_a_layer_is_found() -> None:
    (problem,) = layering("robolayout.gadgets.x", [])
    assert "'gadgets' has no place" in problem[1]


def test_lazy_imports_do_not_count_for_cycles() -> None:
    source = "import robolayout.scene\nif TYPE_CHECKING:\n    import robolayout.solve\ndef f():\n    import robolayout.verify"
    found = imports(ast.parse(source), "robolayout.x", False, KNOWN_HERE)
    assert [(item.module, item.lazy) for item in found] == [
        ("robolayout.scene", False),
        ("robolayout.solve", True),
        ("robolayout.verify", True),
    ]


def test_a_cycle_is_found() -> None:
    assert cycle({"a": {"b"}, "b": {"c"}, "c": {"b"}}) == ["b", "c", "b"]
    assert cycle({"a": {"b", "c"}, "b": {"c"}, "c": set()}) == []


def test_missing_docstrings_are_found() -> None:
    tree = ast.parse(
        '"""A module."""\nclass A:\n    """A."""\n    def f(self): ...\n    def _g(self): ...\ndef h(): ...'
    )
    assert [rule for _, rule in undocumented(tree)] == ["function f has no docstring", "function h has no docstring"]


@pytest.mark.parametrize("module", ["robolayout", "robolayout.scene"])
def test_importing_the_nouns_loads_no_heavy_library(module: str) -> None:
    heavy = [
        "jax",
        "numpy",
        "scipy",
        "shapely",
        "matplotlib",
        "trimesh",
        "moderngl",
        "mujoco",
        "pxr",
        "pydantic",
        "pydantic_ai",
    ]
    code = f"import {module}, sys; assert not set({heavy}) & set(sys.modules), set({heavy}) & set(sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
