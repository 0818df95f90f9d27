"""`report.html`: a run to look at in a browser, in one file that asks nobody for anything; `make page` bundles its viewer from `web`."""

from __future__ import annotations

from robolayout.page._content import content as content
from robolayout.page._document import document as document
from robolayout.page._document import part as part
from robolayout.page._document import sealed as sealed
