"""`report.html`: a run to look at in a browser, in one file that asks nobody for anything.

| file | what it holds |
|---|---|
| `_content` | the run as plain data: assets, statements, verdicts and figures |
| `_agents` | the part of it that differs from body to body |
| `_document` | data, scene and viewer put together, so that nothing in a scene can act on the page |
| `data/` | the viewer, made from the folder `web` of the repository by `make page` |
"""

from __future__ import annotations

from robolayout.page._content import content as content
from robolayout.page._document import document as document
from robolayout.page._document import part as part
from robolayout.page._document import sealed as sealed
