# Every target does all the set-up it needs: packages, configuring, building. `make help` lists them.

JOBS ?= $(shell nproc)
TRAMLINE_DATA ?= $(abspath ../shared/data)
export TRAMLINE_DATA

RELEASE := build/release
TRAMLINE := $(RELEASE)/apps/tramline/tramline
CTEST := ctest --parallel $(JOBS) --output-on-failure --no-tests=error
SOURCES = $(shell git ls-files '*.cpp' '*.h')
# Longest a part of `make long` may take.
LIMIT := timeout --foreground 60m

.DEFAULT_GOAL := build
.NOTPARALLEL:
.SUFFIXES:

# --- for everyone -------------------------------------------------------------------------------

.PHONY: build
build: packages whole ## build everything, optimised (what plain `make` does)
	cmake --build $(RELEASE) -j $(JOBS)

.PHONY: demo
demo: packages-program ## build the program alone, plan the example field and check the plan; results in out/
	@test -e $(RELEASE)/build.ninja || cmake --preset demo
	cmake --build $(RELEASE) -j $(JOBS) --target tramline
	mkdir -p out
	$(TRAMLINE) plan examples/riverside.geojson --width 3 --radius 6 -o out/riverside.gpkg --picture out/riverside.png
	$(TRAMLINE) check out/riverside.gpkg --field examples/riverside.geojson
	@echo
	@echo "The plan, for a GIS:   out/riverside.gpkg"
	@echo "The picture:           out/riverside.png"
	@echo "The program:           $(TRAMLINE) (try --help)"
	@if $(DEMO_ONLY); then echo "For its page (tramline serve) and everything else: make"; fi

.PHONY: test
test: packages-test layout build ## check the layout, build, and run the tests; those on real data where TRAMLINE_DATA is found
	$(CTEST) --test-dir $(RELEASE) -LE slow

.PHONY: page
page: packages ## bundle the page into build/page, to look at what the program is built with
	node web/tools/packages.mjs npm
	node web/node_modules/typescript/bin/tsc --noEmit -p web
	node web/tools/build.mjs --out build/page

.PHONY: serve
serve: program ## build the program and serve its page, http://127.0.0.1:8750
	$(TRAMLINE) serve

.PHONY: page-pictures
page-pictures: packages-test program ## draw the pictures of docs/page.md anew
	TRAMLINE=$(TRAMLINE) node tests/page/pictures.mjs docs/images

.PHONY: page-speed
page-speed: packages-test program ## first paint, and frames a second with 5,000 swaths drawn in software
	TRAMLINE=$(TRAMLINE) node tests/page/speed.mjs

.PHONY: gallery
gallery: program ## plan 24 real fields and draw them on one contact sheet, outside the repository
	cmake --build $(RELEASE) -j $(JOBS) --target tramline_gallery
	tools/gallery.sh $(RELEASE)

.PHONY: qgis-plugin
qgis-plugin: packages ## zip the plugin for QGIS, to be installed from there: out/tramline_processing.zip
	tools/qgis_plugin.sh out/tramline_processing.zip

.PHONY: benches
benches: build
	cmake --build $(RELEASE) -j $(JOBS) --target benches

.PHONY: sweeps
sweeps: build
	cmake --build $(RELEASE) -j $(JOBS) --target sweeps

.PHONY: bench
bench: benches ## measure; table on the terminal, figures into bench/results/
	tools/bench.py $(RELEASE)

.PHONY: papers papers-real
papers: program ## repeat the tables and figures of the three papers, into docs/papers
	PYTHONPATH=tools python3 -B -m papers --tramline $(TRAMLINE)
papers-real: program ## the same, and those that need the real fields of TRAMLINE_DATA, into out/papers
	PYTHONPATH=tools python3 -B -m papers --tramline $(TRAMLINE) --real

.PHONY: lint
lint: packages-lint layout build/clang/build.ninja ## the layout, and clang-tidy over all sources
	run-clang-tidy -quiet -j $(JOBS) -p build/clang '/(src/tramline|include/tramline|apps)/'

.PHONY: layout
layout: packages-layout ## clang-format over all sources, shellcheck over the scripts
	@clang-format-14 --dry-run -Werror $(SOURCES)
	shellcheck .ci/run tools/*.sh tests/cli/common/*.sh
	@rm -rf build/setups
	@tests/cli/run_golden.py --setups build/setups
	shellcheck --shell=bash build/setups/*.sh

.PHONY: goldens
goldens: program ## write the golden outputs of tests/cli anew; read the difference before you commit it
	tests/cli/run_golden.py --update --tramline $(TRAMLINE)

.PHONY: format
format: packages-layout ## lay out all sources as .clang-format says
	clang-format-14 -i $(SOURCES)

.PHONY: clean
clean: ## remove what was built and the results of the demo
	rm -rf build out

.PHONY: help
help: ## show this list
	@awk -F ':.*## ' '/^[a-z0-9-]+:.*## / {printf "  make %-18s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

# --- set-up -------------------------------------------------------------------------------------

.PHONY: packages packages-program packages-layout packages-test packages-qgis packages-lint
packages: ## install the Debian packages that are missing
	@tools/install-packages.sh program build
packages-program:
	@tools/install-packages.sh program
packages-layout:
	@tools/install-packages.sh layout
packages-test:
	@tools/install-packages.sh program build layout test
packages-qgis:
	@tools/install-packages.sh program build qgis
packages-lint:
	@tools/install-packages.sh program build lint

# One rule for every preset of CMakePresets.json. Afterwards ninja configures again by itself.
build/%/build.ninja: CMakePresets.json
	cmake --preset $*
	@touch $@

# `make demo` configures without server, tests and benchmarks. What it compiled is kept when the rest is added.
DEMO_ONLY = grep -qs '^TRAMLINE_SERVER:.*=OFF' $(RELEASE)/CMakeCache.txt

.PHONY: whole
whole: $(RELEASE)/build.ninja
	@if $(DEMO_ONLY); then cmake --preset release -DTRAMLINE_SERVER=ON -DTRAMLINE_PYTHON=ON -DTRAMLINE_BUILD_TESTS=ON -DTRAMLINE_BUILD_BENCH=ON; fi

.PHONY: program
program: packages whole
	cmake --build $(RELEASE) -j $(JOBS) --target tramline

# --- the long tests: each part stands alone and takes an hour at most on two cores -----------------

LONG := long-properties long-scenes long-best-bound long-bound-ways long-bound-divisions long-best-brute long-best-real long-best-real-1 \
  long-best-real-2 long-best-real-3 long-tally-real long-real-1 long-real-2 long-real-3 \
  long-obstacles-3 long-obstacles-6 long-obstacles-12 long-obstacles-24 long-headlands \
  long-headland-plans-6 long-headland-plans-12 long-headland-plans-24 long-turns-3 long-turns-6 \
  long-turns-24 long-route-3 long-route-6 long-route-24 long-route-carried long-route-towed long-machines long-whole-plans long-maps long-order \
  long-coverage long-task-sets long-manoeuvres long-watch long-serve long-kills long-page long-slow long-planted long-batch long-batch-dask long-qgis \
  long-registers long-fuzz-logs long-fuzz-readers \
  long-fuzz-coverage long-lint long-debug long-asan long-tsan long-clang

.PHONY: long $(LONG)
long: $(LONG) ## all the long tests, one after another; each part below can be run alone

long-properties: build ## every property with 20,000 random cases
	TRAMLINE_CASES=20000 $(LIMIT) $(CTEST) --test-dir $(RELEASE) -L properties

long-scenes: build ## 10,000 random scenes full of obstacles, planned in every way and verified
	TRAMLINE_CASES=10000 $(LIMIT) $(RELEASE)/tests/properties/test_obstacle_scenes

# What the best search promises; by themselves, because brute force is slow.
BEST = $(LIMIT) $(RELEASE)/tests/properties/test_best_search
long-best-bound: build ## on 10,000 random fields, no grid of 1,000 costs less than the bound
	TRAMLINE_CASES=10000 $(BEST) --gtest_filter='*NoGridCostsLess*'
long-bound-ways: build ## on 10,000 random fields with obstacles, no ways past them cost less than the bound of their box
	TRAMLINE_CASES=10000 $(BEST) --gtest_filter='*NoWaysPastObstacles*:*NoSidesOfOneObstacle*'
long-bound-divisions: build ## on 10,000 random fields, no division costs less than the bounds of any plan, with prices
	TRAMLINE_CASES=10000 $(BEST) --gtest_filter='*NoDivisionCostsLess*'
long-best-brute: build ## 200 random fields against brute force, and against the sweep
	TRAMLINE_CASES=200 $(BEST) --gtest_filter='-*NoGridCostsLess*:*NoWaysPastObstacles*:*NoSidesOfOneObstacle*:*NoDivisionCostsLess*'
long-best-real: sweeps ## the best search against the sweep over the real fields, default prices
	$(LIMIT) $(RELEASE)/tests/real/best_real
long-best-real-1: sweeps ## the same, Versleijen's scenario 1
	$(LIMIT) $(RELEASE)/tests/real/best_real --scenario 1
long-best-real-2: sweeps ## the same, Versleijen's scenario 2
	$(LIMIT) $(RELEASE)/tests/real/best_real --scenario 2
long-best-real-3: sweeps ## the same, Versleijen's scenario 3
	$(LIMIT) $(RELEASE)/tests/real/best_real --scenario 3
long-tally-real: sweeps ## the closed-form tally against polygon clipping over the real fields
	$(LIMIT) $(RELEASE)/tests/real/tally_real

# One scenario of Versleijen over all real fields: least overlap, least uncovered, fewest turns.
SWEEP = $(LIMIT) $(RELEASE)/tests/real/sweep_real
long-real-1: sweeps ## Versleijen's scenario 1 (least overlap) over the real fields
	TRAMLINE_SCENARIO=1 $(SWEEP)
long-real-2: sweeps ## Versleijen's scenario 2 (least uncovered) over the real fields
	TRAMLINE_SCENARIO=2 $(SWEEP)
long-real-3: sweeps ## Versleijen's scenario 3 (fewest turns) over the real fields
	TRAMLINE_SCENARIO=3 $(SWEEP)

# One working width over all real fields with obstacles: all tracks cut, as in Versleijen, and cheapest.
OBSTACLES = $(LIMIT) $(RELEASE)/tests/real/obstacle_sweep
long-obstacles-3: sweeps ## ways past the obstacles of the real fields, 3 m wide, and what a stop's price does
	$(OBSTACLES) --width 3
	$(OBSTACLES) --stop-prices
long-obstacles-6: sweeps ## the same, 6 m wide
	$(OBSTACLES) --width 6
long-obstacles-12: sweeps ## the same, 12 m wide
	$(OBSTACLES) --width 12
long-obstacles-24: sweeps ## the same, 24 m wide
	$(OBSTACLES) --width 24

long-headlands: sweeps ## headland passes round all real fields: drivable, in place, areas that add up
	$(LIMIT) $(RELEASE)/tests/real/headland_sweep

# One working width over all real fields, with 0, 1 and 2 passes and with and without one round obstacles.
HEADLAND_PLANS = $(LIMIT) $(RELEASE)/tests/real/headland_plans
long-headland-plans-6: sweeps ## plans of all real fields with every number of headland passes, 6 m wide, verified
	$(HEADLAND_PLANS) 6
long-headland-plans-12: sweeps ## the same, 12 m wide
	$(HEADLAND_PLANS) 12
long-headland-plans-24: sweeps ## the same, 24 m wide
	$(HEADLAND_PLANS) 24

# Headlands as the turns of one machine need them, over all real fields.
AUTOMATIC_HEADLANDS = $(LIMIT) $(RELEASE)/tests/real/automatic_headlands
long-turns-3: sweeps ## automatic headlands over the real fields, 3 m wide and 6 m radius: no turn leaves the land
	$(AUTOMATIC_HEADLANDS) 3 6 forward
long-turns-6: sweeps ## the same, 6 m wide and reversing
	$(AUTOMATIC_HEADLANDS) 6 6 reversing
long-turns-24: sweeps ## the same, 24 m wide and 8 m radius
	$(AUTOMATIC_HEADLANDS) 24 8 forward

# The whole route of one machine, over all real fields.
ROUTES = $(LIMIT) $(RELEASE)/tests/real/route_real
long-route-3: sweeps ## whole routes over the real fields, 3 m wide and 6 m radius: verified, on the land, how near to the quickest
	$(ROUTES) 3 6 forward
long-route-6: sweeps ## the same, 6 m wide and reversing
	$(ROUTES) 6 6 reversing
long-route-24: sweeps ## the same, 24 m wide and 8 m radius
	$(ROUTES) 24 8 forward
long-route-carried: sweeps ## the same of a tractor with an implement 6 m wide behind it, over every second field
	$(ROUTES) 6 6 carrying curated/2
long-route-towed: sweeps ## the same of a tractor with a sprayer 27 m wide in tow
	$(ROUTES) 27 8 towing

long-machines: sweeps ## real fields planned for machines, with settings and between gates drawn at random: verified
	printf '%s\n' 1 2 3 4 | xargs -P 2 -I SEED $(LIMIT) $(RELEASE)/tests/real/machines_real 250 SEED

long-whole-plans: sweeps ## plans of least whole cost over real fields: cheaper than those by the cost of tracks, than random layouts, and than in the directions that were driven
	$(LIMIT) $(RELEASE)/tests/real/whole_plans 6 6 forward 3 30
	$(LIMIT) $(RELEASE)/tests/real/driven_directions

long-maps: sweeps ## maps of all real fields, straight and curved, with headlands, verified
	$(LIMIT) $(RELEASE)/tests/real/map_real
	$(LIMIT) $(RELEASE)/tests/real/map_real --width 4 --headlands 2

long-order: sweeps ## the driving order of all real fields, straight and curved: hops against a nearest-neighbour tour
	$(LIMIT) $(RELEASE)/tests/real/order_real

long-coverage: sweeps ## 10,000 random drives and all real logs: the exact engine of coverage against polygon booleans
	$(LIMIT) $(RELEASE)/tests/real/coverage_real
	TRAMLINE_CASES=10000 $(LIMIT) $(RELEASE)/tests/coverage/test_coverage_properties

long-task-sets: build ## task sets and AgOpenGPS folders of all curated real fields, 1 and 400 fields a set, read by independent readers
	cmake --build $(RELEASE) -j $(JOBS) --target task_set_check field_folder_check
	TRAMLINE=$(TRAMLINE) TASK_SET_CHECK=$(RELEASE)/tests/isoxml/task_set_check \
	  FOLDER_CHECK=$(RELEASE)/tests/io/agopengps/field_folder_check $(LIMIT) node tests/isoxml/curated_fields.mjs $(TRAMLINE_DATA)/fields/fields.geojson

long-manoeuvres: build ## the shortest ways between 100,000 random pairs of poses: right, and no longer than OMPL's
	TRAMLINE_CASES=100000 $(LIMIT) $(RELEASE)/tests/turns/test_turns_properties --gtest_filter='*Ompl'
	TRAMLINE_CASES=3000 $(LIMIT) $(RELEASE)/tests/turns/test_turns_properties --gtest_filter='-*Ompl'

long-watch: packages-test build ## `tramline watch` killed at 20 random moments and taken up again, and its other tests
	TRAMLINE_KILLS=20 $(LIMIT) $(CTEST) --test-dir $(RELEASE) -L watch

long-serve: program ## ten minutes of a live feed at 50 Hz before `tramline serve`, with readers: its memory stays as it is
	$(LIMIT) tests/server/soak/serve_soak.py --tramline $(TRAMLINE) --seconds 600 --hertz 50

long-batch: program ## `tramline batch` killed at 60 random moments and resumed: the same bytes as without
	TRAMLINE_KILLS=60 $(LIMIT) tests/cli/batch_test.py $(TRAMLINE)

long-batch-dask: packages-test build ## 100,000 fields on Dask, workers killed five times and the scheduler once: the bytes of `tramline batch`
	PYTHONPATH=$(RELEASE)/python $(LIMIT) /usr/bin/python3 -B python/tests/kills/batch_kills.py --tramline $(TRAMLINE) \
	  --parcels $(TRAMLINE_DATA)/fields/fields-all.geojson --fields 100000 --kills 5

long-qgis: packages-qgis qgis-plugin program ## the plugin in QGIS without windows: all algorithms, bad input, cancelled, layers of projects
	TRAMLINE=$(TRAMLINE) PLUGIN=out/tramline_processing.zip $(LIMIT) /usr/bin/python3 -B qgis/tests/headless_test.py

long-kills: program ## `tramline serve` killed 300 times while it stores: nothing that was answered is lost
	$(LIMIT) tests/server/kills/serve_kills.py --tramline $(TRAMLINE) --kills 300

long-slow: packages-test benches sweeps ## the tests that take longest, which `make test` leaves out; benchmarks and sweeps are built too
	$(LIMIT) $(CTEST) --test-dir $(RELEASE) -L slow

long-planted: program ## changes planted into plan files, each into every plan; plans of random fields priced again
	$(LIMIT) tests/cli/planted_changes_test.py --tramline $(TRAMLINE) --examples examples --every-plan
	TRAMLINE_CASES=60 $(LIMIT) tests/cli/price_again_test.py --tramline $(TRAMLINE) --examples examples

long-page: build packages-test ## the page in a browser: whole jobs, registers of 39,200 parcels, 300 real fields, odd ones planned and reviewed, live work, by keyboard, axe-core
	TRAMLINE=$(TRAMLINE) TRAMLINE_LONG=1 node --test --test-concurrency=1 $(foreach part,plans/whole plans/compare fields/register fields/farm fields/real live plans/hand plans/plan plans/along fields/draw review keyboard axe,tests/page/$(part).test.mjs)

# Refused fields are part of the register: they are listed in the output and are no failure.
long-registers: program ## plan every field of the registers, slivers and oddities included
	mkdir -p out
	$(LIMIT) $(TRAMLINE) plan $(TRAMLINE_DATA)/fields/fields-all.geojson --all --width 6 --radius 6 --json \
	  > out/registers.jsonl || test $$? -eq 3
	@echo "$$(wc -l < out/registers.jsonl) lines in out/registers.jsonl"

long-fuzz-coverage: packages-lint build/fuzz/build.ninja ## the exact engine of coverage against polygon booleans, ten minutes
	cmake --build build/fuzz -j $(JOBS) --target fuzz_tile_coverage
	$(LIMIT) tools/fuzz.sh build/fuzz 600 tile_coverage

long-fuzz-logs: packages-lint build/fuzz/build.ninja ## the readers of logs and patterns on bytes gone wrong, ten minutes each, two at a time
	cmake --build build/fuzz -j $(JOBS) --target fuzz
	$(LIMIT) tools/fuzz.sh build/fuzz 600 csv_log nmea_log gpx_log time_log task_data spray_pattern

long-fuzz-readers: packages-lint build/fuzz/build.ninja ## the readers of fields, machines, plans and requests likewise, twelve minutes each, two at a time
	cmake --build build/fuzz -j $(JOBS) --target fuzz
	$(LIMIT) tools/fuzz.sh build/fuzz 720 field_file agopengps_folder machine_file plan_text plan_file request_body

long-debug: packages build/debug/build.ninja ## the fast tests in a build that is not optimised, with the standard library's assertions
	cmake --build build/debug -j $(JOBS)
	$(LIMIT) $(CTEST) --test-dir build/debug -LE "properties|search|scenes|real|page|install|slow"

long-asan: packages build/asan-ubsan/build.ninja ## all tests but the slowest with address and undefined-behaviour sanitizers
	cmake --build build/asan-ubsan -j $(JOBS)
	UBSAN_OPTIONS=print_stacktrace=1 $(LIMIT) $(CTEST) --test-dir build/asan-ubsan -LE slow

long-tsan: packages build/tsan/build.ninja ## the tests labelled `threads` with the thread sanitizer
	cmake --build build/tsan -j $(JOBS)
	TSAN_OPTIONS="suppressions=$(abspath tools/tsan.supp) ignore_noninstrumented_modules=1" \
	  $(LIMIT) $(CTEST) --test-dir build/tsan -L threads

long-lint: lint ## clang-tidy over all sources

long-clang: packages-lint build/clang/build.ninja ## all tests built by clang
	cmake --build build/clang -j $(JOBS)
	$(LIMIT) $(CTEST) --test-dir build/clang
