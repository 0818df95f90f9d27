"""One HTML file of data, scene and viewer, in which nothing that a scene says can act.

Names and descriptions come from files that anybody may have written. They go into the page as data that no browser runs:
`<`, `>` and `&` are escaped, the viewer shows them as text only, and the page's policy allows the two hashes of its own
script and style and nothing else, no address included.
"""

from __future__ import annotations

import base64
import hashlib
import json
import re
from collections.abc import Mapping, Sequence
from functools import cache
from html import escape
from importlib.resources import files
from typing import Any

_ESCAPES = str.maketrans({"<": "\\u003c", ">": "\\u003e", "&": "\\u0026"})


def document(data: Mapping[str, Any], glb: bytes) -> str:
    """Return the page of what `content` returns and the furnished room as GLB, ASCII only."""
    parts = {"asked": _asked(data.get("asked", ())), "glb": base64.b64encode(glb).decode()}
    html, script, style = (part("robolayout.page", name) for name in ("page.html", "viewer.js", "viewer.css"))
    return sealed(html, script, style, data, **parts)


def sealed(template: str, script: str, style: str, data: object, *, images: str = "'none'", **parts: str) -> str:
    """Return a template with one script, one style and data that nothing runs, under a policy that allows no others.

    It has {{policy}}, {{style}}, {{script}}, {{data}} and the names of further parts.
    """
    shown = f"img-src {images}; " if images != "'none'" else ""
    found = {
        **parts,
        "policy": f"default-src 'none'; script-src '{_hash(script)}'; style-src '{_hash(style)}'; {shown}"
        "base-uri 'none'; form-action 'none'",
        "style": style,
        "script": script,
        "data": json.dumps(data, separators=(",", ":"), allow_nan=False).translate(_ESCAPES),
    }
    return re.sub(r"\{\{(\w+)\}\}", lambda match: found[match[1]], template)


def _asked(rows: Sequence[Sequence[str]]) -> str:
    """Return the ledger of what the user asked as a table, every text escaped; nothing where nothing was asked."""
    if not rows:
        return ""
    met = sum(verdict == "met" for *_, verdict, _ in rows)
    judged = sum(verdict in ("met", "unmet") for *_, verdict, _ in rows)
    lines = "".join(f"<tr>{''.join(f'<td>{escape(text)}</td>' for text in row)}</tr>" for row in rows)
    heads = "<tr><th>words</th><th>understood as</th><th>verdict</th><th>measured</th></tr>"
    table = f"<details><summary>Asked: {met} of {judged} met</summary><table>{heads}{lines}</table></details>"
    return table.encode("ascii", "xmlcharrefreplace").decode()


def _hash(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


@cache
def part(package: str, name: str) -> str:
    """Return a file of a page from a package's folder `data`, its lines ended as browsers count them for hashes."""
    return (files(package) / "data" / name).read_text(encoding="utf-8").replace("\r\n", "\n")
