# The two commands of the README are `make demo` and `make test`. Both install what is missing on Debian 12 first.
PRESET ?= release
BUILD := build/$(PRESET)
ELSIE := $(BUILD)/bin/elsie

.PHONY: transcript api install package tools all demo test sanitize fuzz fuzz-check bench figures four-resources tables reference format lint dependencies configure clean

all: configure
	cmake --build --preset $(PRESET)

dependencies:
	@scripts/install-dependencies

configure: dependencies
	@cmake --preset $(PRESET) --log-level=WARNING

# Builds and runs the main example: a robot whose behaviours are blended by a network collects four resources.
demo: configure
	cmake --build --preset $(PRESET) --target elsie elsie_shipped_plugins
	@mkdir -p out
	$(ELSIE) run worlds/four_resources.xml --seed 1 --picture out/four_resources.png --record out/four_resources.csv --explain out/four_resources.trace
	$(ELSIE) explain out/four_resources.trace --picture out/who_decided.png
	@echo "Look at out/four_resources.png and out/who_decided.png; the whole run is in out/four_resources.csv."

test: all
	ctest --preset $(PRESET)

# Installs the build: docs/installing.md.
PREFIX ?= /usr/local
install: configure
	cmake --build --preset $(PRESET) --target elsie elsie_shipped_plugins elsie_help
	cmake --install $(BUILD) --prefix $(PREFIX)

# A Debian package of the same.
package: all
	cd $(BUILD) && cpack

# The unit tests under the address and undefined-behaviour sanitizers.
sanitize: dependencies
	@cmake --preset asan --log-level=WARNING
	cmake --build --preset asan --target elsie_unit_tests
	ctest --preset asan

# Damaged input for every reader of files, FUZZ_SECONDS for each: scripts/fuzz.
FUZZ_SECONDS ?= 60
fuzz: configure
	cmake --build --preset $(PRESET) --target elsie elsie_shipped_plugins
	@cmake --preset fuzz --log-level=WARNING
	cmake --build --preset fuzz --target elsie_fuzzers
	scripts/fuzz $(FUZZ_SECONDS) build/fuzz $(BUILD)

# The same for a few seconds, with the build of `make sanitize`.
fuzz-check: configure
	cmake --build --preset $(PRESET) --target elsie elsie_shipped_plugins
	@cmake --preset asan --log-level=WARNING
	cmake --build --preset asan --target elsie_fuzzers
	scripts/fuzz 5 build/asan $(BUILD)

# Benchmarks: docs/performance.md.
bench: all
	scripts/benchmark $(BUILD)

# Results of the shipped worlds over 20 seeds: docs/shipped-worlds.md.
figures: all
	scripts/world-figures $(BUILD)

# The four-resource world with every coordinator, 20 seeds each: docs/four-resources.md.
four-resources: all
	scripts/coordination-figures $(BUILD)

# The published experiments and the study of every coordinator: docs/experiments.md, docs/every-coordinator.md. Continues where it was stopped.
tables: configure
	cmake --build --preset $(PRESET) --target elsie elsie_shipped_plugins
	scripts/tables $(BUILD)

# The generated parts of the plugins' pages in docs/, from their declarations.
reference: configure
	cmake --build --preset $(PRESET) --target elsie elsie_shipped_plugins
	scripts/reference $(BUILD)

# The first page of the tutorial, followed on a fresh clone of what is committed: docs/tutorial/transcript.md, and the pictures of the tutorial.
transcript: configure
	cmake --build --preset $(PRESET) --target elsie elsie_shipped_plugins elsie_help
	tests/tutorial/follow --clone . --transcript docs/tutorial/transcript.md docs/tutorial/1-*.md
	tests/tutorial/follow --installed $(BUILD) --pictures docs/tutorial/[1-9]-*.md

# The reference of the C++ headers; a warning is an error.
api: dependencies
	@mkdir -p out
	doxygen Doxyfile
	@echo "Look at out/api/html/index.html."

tools:
	@scripts/install-dependencies --with-tools

format: tools
	git ls-files '*.cpp' '*.h' | xargs clang-format -i

# clang-tidy reads the flags of a build configured for clang.
lint: tools dependencies
	@cmake -S . -B build/lint -G Ninja -DCMAKE_CXX_COMPILER=clang++ --log-level=WARNING
	git ls-files '*.cpp' '*.h' | xargs clang-format --dry-run -Werror
	git ls-files 'core/*.cpp' 'libraries/*.cpp' 'plugins/*.cpp' 'apps/*.cpp' | xargs -n 4 -P 2 clang-tidy --quiet -p build/lint

clean:
	rm -rf build out
