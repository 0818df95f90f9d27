# Two commands do all the set-up: `make demo` shows what it does, `make test` proves it.
PYTHON ?= python3
BIN := .venv/bin
STAMP := .venv/.installed
DEV := .venv/.installed-dev
SHELL := /bin/bash -o pipefail
SHORT := sed -unE 's/^ *((Collecting|Downloading|Installing|Successfully).{0,90}).*/  \1/p'
TOOLS := if { command -v npm && { command -v chromium || command -v google-chrome; }; } >/dev/null; then export ROBOLAYOUT_NODE_TOOLS=1; fi;

.PHONY: demo test test-all lint bench fuzz docs gallery page tools clean

demo: $(STAMP) ## furnish the example bedroom for a wheelchair user
	@echo "Furnishing the example bedroom for a wheelchair user; the first run compiles the solver, which takes some seconds."
	$(BIN)/robolayout generate examples/bedroom.json --agent wheelchair --out out/bedroom
	@echo "Open out/bedroom/report.html in a browser; the pictures are out/bedroom/top.png, view.png and plan.svg."

test: $(DEV) tools ## run the test suite on all cores
	$(TOOLS) $(BIN)/python -m pytest -n auto --dist worksteal -q -m "not slow"

test-all: $(DEV) tools ## run everything, slow tests too
	$(TOOLS) $(BIN)/python -m pytest -n auto --dist worksteal -q

lint: $(DEV) ## ruff and pyright
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/pyright

bench: $(DEV) ## measure quality and speed; writes docs/benchmarks.md
	$(BIN)/python -m benchmarks

fuzz: $(DEV) ## read 100,000 spoiled files (ROBOLAYOUT_FUZZ=n for another number); writes docs/benchmarks.md
	$(BIN)/python -m benchmarks --section fuzz --fresh

docs: $(DEV) ## write the generated pages
	$(BIN)/python -m docs.generate

gallery: $(DEV) ## build docs/gallery from all examples
	$(BIN)/python -m docs.gallery

page: web/node_modules ## bundle the viewer of report.html into the package
	cd web && npm run build --silent

$(STAMP): pyproject.toml constraints.txt
	@echo "Installing RoboLayout and what it needs into .venv: about 850 MB on disk, one to five minutes."
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --progress-bar on --disable-pip-version-check -c constraints.txt -e . | $(SHORT)
	@touch $@

$(DEV): $(STAMP)
	@echo "Installing what the tests need, simulators and readers of every format among it: about 1.3 GB more."
	$(BIN)/python -m pip install --progress-bar on --disable-pip-version-check -c constraints.txt -e '.[dev]' | $(SHORT)
	@touch $@

tools: # npm packages and a browser: what only tests need; without root and without them, their tests are skipped
	@command -v npm >/dev/null || $(MAKE) apt-npm
	@command -v chromium >/dev/null || command -v google-chrome >/dev/null || $(MAKE) apt-chromium
	@if command -v npm >/dev/null; then $(MAKE) tests/tools/node_modules; fi

apt-%:
	@if [ "$$(id -u)" = 0 ]; then apt-get update -q && apt-get install -qy $*; \
	else echo "no $* here, and no root to install it: the tests that need it are skipped; put it on your PATH to run them."; fi

tests/tools/node_modules: tests/tools/package.json
	cd tests/tools && npm install --no-audit --no-fund --no-package-lock --loglevel=error
	@touch $@

web/node_modules: web/package.json
	cd web && npm install --no-audit --no-fund --no-package-lock --loglevel=error
	@touch $@

clean: ## remove what the other targets made
	rm -rf .venv out tests/tools/node_modules web/node_modules
