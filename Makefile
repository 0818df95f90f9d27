# Two commands do all the set-up: `make demo` shows what it does, `make test` proves it.
PYTHON ?= python3
BIN := .venv/bin
STAMP := .venv/.installed
DEV := .venv/.installed-dev

.PHONY: demo test test-all lint bench docs gallery page browser clean

demo: $(STAMP) ## furnish the example bedroom for a wheelchair user
	$(BIN)/robolayout generate examples/bedroom.json --agent wheelchair --out out/bedroom

test: $(DEV) tests/tools/node_modules browser ## run the test suite on all cores
	ROBOLAYOUT_NODE_TOOLS=1 $(BIN)/python -m pytest -n auto --dist worksteal -q -m "not slow"

test-all: $(DEV) tests/tools/node_modules browser ## run everything, slow tests too
	ROBOLAYOUT_NODE_TOOLS=1 $(BIN)/python -m pytest -n auto --dist worksteal -q

lint: $(DEV) ## ruff and pyright
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/pyright

bench: $(DEV) ## measure quality and speed; writes docs/benchmarks.md
	$(BIN)/python -m benchmarks

docs: $(DEV) ## write the generated pages
	$(BIN)/python -m docs.generate

gallery: $(DEV) ## build docs/gallery from all examples
	$(BIN)/python -m docs.gallery

page: web/node_modules ## bundle the viewer of report.html into the package
	cd web && npm run build --silent

$(STAMP): pyproject.toml constraints.txt
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install -q --disable-pip-version-check -c constraints.txt -e .
	@touch $@

$(DEV): $(STAMP)
	$(BIN)/python -m pip install -q --disable-pip-version-check -c constraints.txt -e '.[dev]'
	@touch $@

tests/tools/node_modules: tests/tools/package.json
	command -v npm >/dev/null || (apt-get update -q && apt-get install -qy npm)
	cd tests/tools && npm install --no-audit --no-fund --no-package-lock --loglevel=error
	@touch $@

web/node_modules: web/package.json
	command -v npm >/dev/null || (apt-get update -q && apt-get install -qy npm)
	cd web && npm install --no-audit --no-fund --no-package-lock --loglevel=error
	@touch $@

browser: # what the tests of report.html open it in
	@command -v chromium >/dev/null || (apt-get update -q && apt-get install -qy chromium)

clean: ## remove what the other targets made
	rm -rf .venv out tests/tools/node_modules web/node_modules
