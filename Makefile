# The two commands of the README are `make demo` and `make test`. Both install what is missing on Debian 12 and 13 first.
PRESET ?= release
BUILD := build/$(PRESET)
ELSIE := $(BUILD)/bin/elsie
# .ci/run alone sets WARNINGS_ARE_ERRORS: a compiler that warns of more than ours does keeps nobody from building.
CONFIGURE := cmake --log-level=WARNING $(if $(WARNINGS_ARE_ERRORS),-DCMAKE_COMPILE_WARNING_AS_ERROR=ON)

.PHONY: desktop python program configure-program transcript api site install package all demo test test-quick sanitize sanitize-threads fuzz fuzz-check bench examples figures world-hashes library-table weigh mutants coverage four-resources pictures tables comparison reference format lint lint-changed dependencies configure clean

all: configure
	cmake --build --preset $(PRESET)

dependencies:
	@scripts/install-dependencies

configure: dependencies
	@$(CONFIGURE) --preset $(PRESET)

# The program with all its subcommands and plugins: needs fewer packages than the tests do. A build folder that has the tests keeps them.
configure-program:
	@scripts/install-dependencies --program
	@[ -f $(BUILD)/build.ninja ] || $(CONFIGURE) --preset $(PRESET) -DELSIE_BUILD_TESTS=OFF -DELSIE_BUILD_BENCHMARKS=OFF

program: configure-program
	cmake --build --preset $(PRESET) --target elsie_complete

# Builds the program and runs the main job: a robot whose behaviours are blended by a network collects four resources.
demo: program
	@mkdir -p out
	$(ELSIE) run worlds/four_resources.xml --seed 1 --picture out/four_resources.png --record out/four_resources.csv --record out/four_resources.mcap
	$(ELSIE) explain out/four_resources.mcap --picture out/who_decided.png
	@echo "Look at out/four_resources.png and out/who_decided.png; the whole run is in out/four_resources.csv."

# Builds and starts the window: docs/desktop.md.
desktop:
	@scripts/install-dependencies --desktop
	@[ -f $(BUILD)/build.ninja ] || $(CONFIGURE) --preset $(PRESET) -DELSIE_BUILD_TESTS=OFF -DELSIE_BUILD_BENCHMARKS=OFF
	@cmake $(BUILD) --log-level=WARNING >/dev/null
	cmake --build --preset $(PRESET) --target elsie_complete elsie_desktop
	$(BUILD)/bin/elsie-desktop

test: all
	ctest --preset $(PRESET)

# The unit tests but the longest, in less than two minutes after a change of one file.
test-quick: configure
	cmake --build --preset $(PRESET) --target elsie_unit_tests
	ctest --preset $(PRESET) --label-regex '^unit$$' --label-exclude '^long$$'

# The module for Python, in place: docs/python.md.
python:
	@scripts/install-dependencies --python
	@[ -f $(BUILD)/build.ninja ] || $(CONFIGURE) --preset $(PRESET) -DELSIE_BUILD_TESTS=OFF -DELSIE_BUILD_BENCHMARKS=OFF
	@cmake $(BUILD) --log-level=WARNING >/dev/null
	cmake --build --preset $(PRESET) --target elsie_python_complete
	@echo "Now Python finds the module:  export PYTHONPATH=$(CURDIR)/$(BUILD)/lib/python3/dist-packages"

# Installs the build: docs/installing.md.
PREFIX ?= /usr/local
install: configure-program
	cmake --build --preset $(PRESET) --target elsie_complete elsie_help
	cmake --install $(BUILD) --prefix "$(PREFIX)"

# A Debian package of the same.
package: all
	cd $(BUILD) && cpack

# The unit tests under the address and undefined-behaviour sanitizers.
sanitize: dependencies
	@$(CONFIGURE) --preset asan
	cmake --build --preset asan --target elsie_unit_tests
	ctest --preset asan

# What several threads do, under the thread sanitizer.
sanitize-threads: dependencies
	@$(CONFIGURE) --preset tsan
	cmake --build --preset tsan --target elsie_thread_tests
	ctest --preset tsan

# Damaged input for every reader of files, FUZZ_SECONDS for each: scripts/fuzz.
FUZZ_SECONDS ?= 60
fuzz: configure
	cmake --build --preset $(PRESET) --target elsie_complete
	@$(CONFIGURE) --preset fuzz
	cmake --build --preset fuzz --target elsie_fuzzers
	scripts/fuzz $(FUZZ_SECONDS) build/fuzz $(BUILD)

# The same for a few seconds, with the build of `make sanitize`.
fuzz-check: configure
	cmake --build --preset $(PRESET) --target elsie_complete
	@$(CONFIGURE) --preset asan
	cmake --build --preset asan --target elsie_fuzzers
	scripts/fuzz 5 build/asan $(BUILD)

# Benchmarks: docs/internals/performance.md.
bench: all
	scripts/benchmark $(BUILD)

# The worlds of examples/08-senses, 09-acts and 10-swarms with twenty seeds: each succeeds, and fails without its sense or actuator. Those of 11-any-language with five.
examples: program
	ELSIE=$(CURDIR)/$(ELSIE) examples/08-senses/check 20
	ELSIE=$(CURDIR)/$(ELSIE) examples/09-acts/check 20
	ELSIE=$(CURDIR)/$(ELSIE) examples/10-swarms/check 20
	ELSIE=$(CURDIR)/$(ELSIE) examples/11-any-language/check 5

# Results of the shipped worlds over 20 seeds: docs/shipped-worlds.md.
figures: all
	scripts/world-figures $(BUILD)

# The state hash of every shipped world, which a test compares: tests/program/world_hashes.txt.
world-hashes: all
	scripts/world-hashes $(BUILD) --renew tests/program/world_hashes.txt

# Lines, sizes and needs of the libraries: docs/internals/architecture.md.
library-table: all
	scripts/library-table $(BUILD)

# How much there is to read, and to touch for a change.
weigh: all
	scripts/weigh . $(BUILD)

# How many planted faults the unit tests notice.
mutants: dependencies
	scripts/mutants

# How often the intervals of reports hold the true value: docs/research/statistics.md.
coverage: configure
	cmake --build --preset $(PRESET) --target bench_interval_coverage
	scripts/coverage $(BUILD)

# The pictures of worlds in docs/.
pictures: program
	$(ELSIE) run worlds/drives.xml --seed 1 --quiet --picture docs/pictures/drives.png
	scripts/sense-pictures $(BUILD)
	scripts/layout-pictures $(BUILD)
	scripts/coordinator-pictures $(BUILD)
	scripts/report-pictures $(BUILD)

# The four-resource world with every coordinator, 20 seeds each: docs/research/four-resources.md.
four-resources: all
	experiments/reproduction/coordination-figures $(BUILD)

# The published experiments, the deciding experiment and the study of every coordinator: docs/research/experiments.md, docs/research/original-step.md,
# docs/research/every-coordinator.md. Goes on where it was stopped; SEEDS of the deciding experiment, at most 20, take two and a half hours in all.
SEEDS ?= 20
tables: configure
	experiments/reproduction/tables $(BUILD) --seeds $(SEEDS)

# The study of every coordinator alone: docs/research/every-coordinator.md. Goes on where it was stopped.
comparison: configure
	experiments/reproduction/tables $(BUILD) --only every_coordinator

# The generated parts of the plugins' pages in docs/, from their declarations.
reference: program
	scripts/reference $(BUILD)

# The first page of the tutorial, followed on a fresh clone of what is committed: docs/internals/tutorial-transcript.md, and the pictures of the tutorial.
transcript: configure
	cmake --build --preset $(PRESET) --target elsie_complete elsie_help
	tests/tutorial/follow --clone . --transcript docs/internals/tutorial-transcript.md docs/tutorial/1-*.md
	tests/tutorial/follow --installed $(BUILD) --pictures docs/tutorial/[1-9]-*.md

# The reference of the C++ headers; a warning is an error.
api: dependencies
	@mkdir -p out
	doxygen Doxyfile
	@echo "Look at out/api/html/index.html."

# The pages as a site with search.
site:
	@scripts/install-dependencies --site
	@scripts/site

format: dependencies
	git ls-files '*.cpp' '*.h' | xargs clang-format -i

# The style of the whole tree, and of what differs from main.
lint: dependencies
	scripts/lint

lint-changed: dependencies
	scripts/lint --changed

clean:
	rm -rf build out
