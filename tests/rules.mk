# The tests: a file a module, with the module's path, besides those of the
# figures and, in tests/whole, of the whole library.
#
# The framework of the tests is called check; pkg-config knows how to use it.
# USES: options that some tests are compiled with.  EMULATOR: the command that
# runs tests of another machine, see tests/machines.  TF_TEST_PERCENT: the part
# of its random cases that a test tries; tests read it from the environment.

# Every test is a program, linked with what it uses of tests/support, where
# main() is.  A build of the first chapters leaves out the support that needs
# more than they have, and the tests of the whole.
SUPPORT := $(wildcard tests/support/*.c) tests/bench/workloads.c \
	tests/bench/layers.c tests/bench/measuring.c
FIGURE_TESTS := $(wildcard tests/renderer/*.c tests/draw/*.c tests/figures/*.c)
ifndef partial
WHOLE := $(wildcard tests/whole/*.c) $(FIGURE_TESTS)
# tests/whole/expansion and bench use the figures' expansion.
$(BUILD)/support.a: $(BUILD)/drawing/kit/expansion.o
else
SUPPORT := $(call compiling,$(SUPPORT))
endif
TESTS := $(patsubst %.c,$(BUILD)/%,$(wildcard $(MODULES:%=tests/%.c)) $(WHOLE))
FUZZERS := $(patsubst %.c,$(BUILD)/%,$(wildcard tests/fuzz/*.c))

$(BUILD)/support.a: $(SUPPORT:%.c=$(BUILD)/%.o)

$(BUILD)/tests/%.o: tests/%.c $(BUILD)/flags | need-tests
	@echo 'compile $<' && mkdir -p $(@D)
	$(Q)$(COMPILE) -I$(SRC) -Itests -Ifigures $(USES) \
	    $$(pkg-config --cflags check) -MMD -MP -c $< -o $@

$(BUILD)/tests/%: $(BUILD)/tests/%.o $(BUILD)/support.a $(BUILD)/program.a \
		$(experimental_library)
	@echo 'link    $@'
	$(Q)$(link_experiments) $$(pkg-config --libs check) $(LIBRARIES) -lgmp \
	    -lm -o $@

# These have the simulator in them, and with it the library that it uses.
simulating = $(addprefix $(BUILD)/tests/,whole/scenes soak/scenes program/frame_file \
	program/simulation_folder program/simulate_command program/cloth_simulated \
	bench/flowing)
$(BUILD)/tests/simulate/% $(simulating): LIBRARIES = $(SPARSE)

# These count calls of these functions, or let them fail.
$(BUILD)/tests/whole/allocations $(BUILD)/tests/whole/no_memory: LIBRARIES = -Wl,--wrap=malloc \
	-Wl,--wrap=calloc -Wl,--wrap=realloc -Wl,--wrap=aligned_alloc

# The tests of the figures need more: their rule overrides the pattern above.
# The library's own do without the figures' libraries.
figure_tests = $(FIGURE_TESTS:%.c=$(BUILD)/%)
library_tests = $(filter-out $(figure_tests),$(TESTS))
$(figure_tests:=.o): $(BUILD)/renderer.flags | $(generated)
$(figure_tests:=.o): USES = $(drawing_flags)
$(figure_tests): $(BUILD)/%: $(BUILD)/%.o $(BUILD)/support.a $(figure_archives)
	@echo 'link    $@'
	$(Q)$(link_experiments) @$(BUILD)/renderer.libraries \
	    $$(pkg-config --libs check) $(SPARSE) -lgmp -lm -o $@

# Leaks of the libraries that figures use are not ours, and a test that requests
# more memory than there is wants NULL, from the sanitizer, too.
leaks = suppressions=$(CURDIR)/tests/renderer/leaks.supp:print_suppressions=0
allocation = allocator_may_return_null=1

$(BUILD)/tests/%.log: $(BUILD)/tests/% $(program_file) FORCE \
		| $(if $(WHOLE),$(drawing_file))
	@TANGLEFREE=$(abspath $(program_file)) \
	TANGLEFREE_DRAW=$(abspath $(drawing_file)) \
	LSAN_OPTIONS=$(leaks) ASAN_OPTIONS=$(allocation) EMULATOR='$(EMULATOR)' \
	    sh tests/run-test.sh $< tests/$* $@

# Tests that cannot be built have no log, and are counted all the same.
check: need-check ## build and run the tests
	@rm -f $(TESTS:=.log); $(MAKE) $(parallel) -k -O run-tests; built=$$?; \
	sh tests/count-checks.sh $(TESTS:=.log) && [ $$built = 0 ]

run-tests: $(library_file) $(program_file) $(TESTS:=.log) \
	$(if $(WHOLE),$(drawing_file) check-renderer)
.PHONY: check run-tests

sanitizers = -fsanitize=address,undefined,float-cast-overflow \
	-fno-sanitize-recover=all -fno-omit-frame-pointer

# Of the tests of figures, all.c draws every one, and the others would only take
# long to link.  It comes first since it takes longest.
sanitized_tests = $(BUILD)/tests/figures/all \
	$(filter-out $(BUILD)/tests/figures/%,$(figure_tests)) $(library_tests)
check-sanitize: ## run the tests under AddressSanitizer and UBSan
	@$(MAKE) check BUILD=$(BUILD)/sanitize TF_TEST_PERCENT=5 \
	    CFLAGS='-O1 -g $(sanitizers)' \
	    TESTS='$(sanitized_tests:$(BUILD)/%=$(BUILD)/sanitize/%)'

# Threads of the test answer at once what one answered before.  The log is made
# even if checks fail; grep sees whether it says that all passed.
thread_logs = $(patsubst %,$(BUILD)/threads/tests/%.log,whole/threads \
	whole/surface_threads)
check-threads: need-check ## run many threads at once under ThreadSanitizer
	@$(MAKE) $(thread_logs) BUILD=$(BUILD)/threads TF_TEST_PERCENT=10 \
	    CFLAGS='-O1 -g -fsanitize=thread'
	@for log in $(thread_logs); do grep -q '^100%' $$log || exit 1; done
.PHONY: check-sanitize check-threads

coverage: need-coverage ## list which lines of src/ the tests run; at least 95 %
	@find $(BUILD)/coverage -name '*.gcda' -delete 2>/dev/null || true
	@$(MAKE) check BUILD=$(BUILD)/coverage TF_TEST_PERCENT=5 CC=gcc \
	    CFLAGS='-O0 --coverage -fprofile-update=atomic' \
	    TESTS='$(library_tests:$(BUILD)/%=$(BUILD)/coverage/%)' WHOLE=
	@gcovr --filter src/ --object-directory $(BUILD)/coverage --fail-under-line 95
.PHONY: coverage

# Fuzzing finds new inputs in a copy of each corpus.  To trace comparisons of
# numbers, too, would take two thirds of the time and find nothing.
SECONDS = 60
fuzzing = -fsanitize=fuzzer-no-link -fno-sanitize-coverage=trace-cmp
fuzz: need-fuzz ## run every fuzzer for SECONDS=60
	@$(MAKE) $(parallel) -k -O run-fuzzers BUILD=$(BUILD)/fuzz CC=clang \
	    CFLAGS='-O1 -g $(sanitizers) $(fuzzing)' \
	    LDFLAGS=-fsanitize=fuzzer

run-fuzzers: $(FUZZERS:=.found)
$(BUILD)/tests/fuzz/%.found: $(BUILD)/tests/fuzz/% FORCE
	@mkdir -p $(BUILD)/corpus/$* && cp -R tests/fuzz/corpus/$*/. $(BUILD)/corpus/$*
	@$< -max_total_time=$(SECONDS) -artifact_prefix=$<- $(BUILD)/corpus/$* \
	    >$@ 2>&1 || { tail -n 60 $@; false; }
	@printf '%-32s %s\n' tests/fuzz/$* "$$(grep '^Done' $@)"
.PHONY: fuzz run-fuzzers

# Interrupted, this prints how to go on.
COUNT = 100000000
FROM = 0
soak: $(BUILD)/tests/soak/soak ## answer COUNT=100000000 queries in two ways, and compare
	@$< $(COUNT) $(FROM)

soak-vectors: $(BUILD)/tests/soak/vectors ## compare COUNT=100000000 verdicts by vectors with the reference's
	@$< $(COUNT)

soak-response: COUNT = 10000
soak_response = $(patsubst %,$(BUILD)/tests/%,soak/response whole/response \
	whole/response_cases)
soak-response: $(soak_response) ## resolve and judge COUNT=10000 random proposals, and longer scenes
	@$< $(COUNT) $(FROM)
	@TF_TEST_PERCENT=200 $(BUILD)/tests/whole/response
	@TF_TEST_PERCENT=400 $(BUILD)/tests/whole/response_cases

soak-surgery: COUNT = 500000
soak-surgery: $(BUILD)/tests/soak/surgery ## try COUNT=500000 operations on surfaces, and judge each
	@$< $(COUNT) $(FROM)

soak-topology: COUNT = 100000
soak-topology: $(BUILD)/tests/soak/topology ## merge, pinch and drop among COUNT=100000 operations, and judge each
	@$< $(COUNT) $(FROM)

soak-scenes: $(BUILD)/tests/soak/scenes ## simulate and judge all scenes of the simulator
	@$<
.PHONY: soak soak-vectors soak-response soak-surgery soak-topology soak-scenes

# What is measured -------------------------------------------------------------

benches = bench surfaces speed
bench: $(benches:%=$(BUILD)/tests/bench/%) ## time the library
	@for program in $^; do $$program; done

# With the usual flags, whatever CFLAGS of this build.
measure: ## time the library again for the book, in figures/measured.csv
	@$(MAKE) BUILD=$(BUILD)/measured CFLAGS=-O3 LDFLAGS= \
	    $(benches:%=$(BUILD)/measured/tests/bench/%)
	@echo 'measure figures/measured.csv'
	@sh tests/bench/measure.sh '$(CC)' -O3 \
	    $(benches:%=$(BUILD)/measured/tests/bench/%) >$(BUILD)/measured/new.csv
	@mv $(BUILD)/measured/new.csv figures/measured.csv

bench-response: $(BUILD)/tests/bench/response ## time the response to contacts of cloth
	@$<

$(BUILD)/tests/bench/solvers.o: | need-solvers
$(BUILD)/tests/bench/solvers: LIBRARIES = -llapacke
compare-solvers: $(BUILD)/tests/bench/solvers ## compare the solvers of impact zones
	@$< tests/bench/zones.txt

compare-sweeps: $(BUILD)/tests/bench/sweeps ## compare numbers of sweeps on steps of cloth
	@$<

solver_benches = $(BUILD)/measured/tests/bench/solvers \
	$(BUILD)/measured/tests/bench/sweeps
measure-solvers: ## do both again for the book, in figures/solvers.csv
	@$(MAKE) BUILD=$(BUILD)/measured CFLAGS=-O3 LDFLAGS= $(solver_benches)
	@echo 'measure figures/solvers.csv'
	@sh tests/bench/solvers.sh '$(CC)' -O3 tests/bench/zones.txt \
	    $(solver_benches) >$(BUILD)/measured/solvers.csv
	@mv $(BUILD)/measured/solvers.csv figures/solvers.csv

collect-zones: $(BUILD)/tests/bench/collect_zones ## collect zones again for that, in tests/bench/zones.txt
	@$< >$(BUILD)/zones.txt
	@mv $(BUILD)/zones.txt tests/bench/zones.txt

counts: $(BUILD)/tests/bench/counts ## count the contacts that the report's rule misses
	@$<

# Files of TF_SHARED_DATA, ../shared/data unless set, that are absent are left
# out, with a note.
compare: $(BUILD)/tests/bench/compare ## compare the methods: what a query costs, how often each is wrong
	@$<
	@awk -f tests/bench/published.awk tests/bench/published.csv

measure-roads: ## compare the methods again for the book, in figures/roads.csv
	@$(MAKE) BUILD=$(BUILD)/measured CFLAGS=-O3 LDFLAGS= \
	    $(BUILD)/measured/tests/bench/compare
	@echo 'measure figures/roads.csv'
	@sh tests/bench/compare.sh '$(CC)' -O3 \
	    $(BUILD)/measured/tests/bench/compare tests/bench/published.csv \
	    >$(BUILD)/measured/roads.csv
	@mv $(BUILD)/measured/roads.csv figures/roads.csv

measure-response: ## time the response again for the book, in figures/response.csv
	@$(MAKE) BUILD=$(BUILD)/measured CFLAGS=-O3 LDFLAGS= \
	    $(BUILD)/measured/tests/bench/response
	@echo 'measure figures/response.csv'
	@sh tests/bench/response.sh '$(CC)' -O3 \
	    $(BUILD)/measured/tests/bench/response \
	    >$(BUILD)/measured/response.csv
	@mv $(BUILD)/measured/response.csv figures/response.csv

measure-simulation: ## run and time the scenes again for the book, in figures/simulation.csv
	@$(MAKE) $(parallel) BUILD=$(BUILD)/measured CFLAGS=-O3 program
	@echo 'measure figures/simulation.csv'
	@sh tests/bench/simulation.sh '$(CC)' -O3 $(BUILD)/measured/tanglefree \
	    $(BUILD)/measured/frames >$(BUILD)/measured/simulation.csv
	@mv $(BUILD)/measured/simulation.csv figures/simulation.csv

measure-topology: ## merge, pinch and drop at random again for the book, in figures/topology.csv
	@$(MAKE) BUILD=$(BUILD)/measured CFLAGS=-O3 LDFLAGS= \
	    $(BUILD)/measured/tests/soak/topology
	@echo 'measure figures/topology.csv'
	@sh tests/bench/topology.sh '$(CC)' -O3 \
	    $(BUILD)/measured/tests/soak/topology 500000 20000 \
	    >$(BUILD)/measured/topology.csv
	@mv $(BUILD)/measured/topology.csv figures/topology.csv

measure-remeshing: need-remeshing ## remesh meshes of another program again for the book, in figures/remeshing.csv
	@$(MAKE) $(parallel) BUILD=$(BUILD)/measured CFLAGS=-O3 program
	@echo 'measure figures/remeshing.csv'
	@sh tests/bench/remeshing.sh '$(CC)' -O3 $(BUILD)/measured/tanglefree \
	    $(BUILD)/measured/remeshed >$(BUILD)/measured/remeshing.csv
	@mv $(BUILD)/measured/remeshing.csv figures/remeshing.csv

measure-surgery: ## leave out tests of surgery again for the book, in figures/surgery.csv
	@$(MAKE) BUILD=$(BUILD)/measured CFLAGS=-O3 LDFLAGS= \
	    $(BUILD)/measured/tests/soak/surgery
	@echo 'measure figures/surgery.csv'
	@sh tests/bench/surgery.sh '$(CC)' -O3 \
	    $(BUILD)/measured/tests/soak/surgery 100000 \
	    >$(BUILD)/measured/surgery.csv
	@mv $(BUILD)/measured/surgery.csv figures/surgery.csv

measure-flowing: ## let surfaces flow again for the book, in figures/flowing.csv
	@$(MAKE) BUILD=$(BUILD)/measured CFLAGS=-O3 LDFLAGS= \
	    $(BUILD)/measured/tests/bench/flowing
	@echo 'measure figures/flowing.csv'
	@sh tests/bench/flowing.sh '$(CC)' -O3 \
	    $(BUILD)/measured/tests/bench/flowing \
	    >$(BUILD)/measured/flowing.csv
	@mv $(BUILD)/measured/flowing.csv figures/flowing.csv
.PHONY: bench bench-response measure compare-solvers compare-sweeps \
	measure-solvers measure-topology \
	collect-zones counts compare measure-roads measure-response \
	measure-simulation measure-surgery \
	measure-remeshing measure-flowing
