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
	$(addprefix tests/bench/,layers.c latency.c measuring.c surface_calls.c \
	adaptive_calls.c)
# figures/all.c draws every figure and takes longest, so it comes first.
FIGURE_TESTS := $(wildcard $(addsuffix /*.c,$(addprefix tests/,figures renderer \
	draw kit)))
ifndef partial
WHOLE := $(FIGURE_TESTS) $(wildcard tests/whole/*.c)
# tests/whole/expansion and bench use the figures' expansion.
$(BUILD)/support.a: $(BUILD)/drawing/kit/expansion.o
else ifneq ($(origin SUPPORT),command line)
SUPPORT := $(call compiling,$(SUPPORT))
endif
TESTS := $(patsubst %.c,$(BUILD)/%,$(WHOLE) $(wildcard $(MODULES:%=tests/%.c)))
FUZZERS := $(patsubst %.c,$(BUILD)/%,$(wildcard $(addsuffix .c,$(addprefix \
	tests/fuzz/,$(or $(FUZZER),*)))))

$(BUILD)/support.a: $(SUPPORT:%.c=$(BUILD)/%.o)

$(BUILD)/tests/%.o: tests/%.c $(BUILD)/flags | need-tests
	@echo 'compile $<' && mkdir -p $(@D)
	$(Q)$(COMPILE) -I$(SRC) -Itests -Ifigures $(USES) \
	    $$(pkg-config --cflags check) -MMD -MP -c $< -o $@

$(BUILD)/tests/%: $(BUILD)/tests/%.o $(BUILD)/support.a $(BUILD)/program.a \
		$(experimental_library)
	@echo 'link    $@'
	$(Q)$(link_experiments) $$(pkg-config --libs check) $(LIBRARIES) $(ZLIB) \
	    -lgmp -lm -o $@

# These have the simulator in them, and with it the library that it uses.
simulating = $(addprefix $(BUILD)/tests/,whole/rest whole/scenes soak/scenes program/frame_file program/steps_file \
	program/simulation_folder program/simulate_command program/step_fields \
	bench/flowing bench/coupling bench/resting)
$(BUILD)/tests/simulate/% $(simulating): LIBRARIES = $(SPARSE) $(YAML)

# These read scenes.
scenic = $(addprefix $(BUILD)/tests/,fuzz/scene scenes/scene_file scenes/scene_reader \
	program/surface_command program/resolve_command)
$(scenic): LIBRARIES = $(YAML)

# This lets calls of these functions fail.
$(BUILD)/tests/threads/threads: LIBRARIES = -Wl,--wrap=malloc \
	-Wl,--wrap=pthread_create
$(BUILD)/tests/whole/cancelling: LIBRARIES = -Wl,--wrap=tf_side \
	-Wl,--wrap=tf_nearest_points -Wl,--wrap=tf_squared_distance \
	-Wl,--wrap=tf_dynamic_tree_find \
	-Wl,--wrap=tf_find_edge -Wl,--wrap=tf_watch_done

# These see what users see.
public = $(BUILD)/tests/fuzz/interface $(fuzz_calls:.o=) \
	$(addprefix $(BUILD)/tests/whole/,misuse adaptive_misuse)
fuzz_calls = $(patsubst %.c,$(BUILD)/%.o,$(wildcard tests/fuzz/calls/*.c))
$(public:=.o): USES = -I$(dir $(public_header))
$(public:=.o): $(public_header)
$(BUILD)/tests/fuzz/interface: $(fuzz_calls)

# The tests of the figures need more: their rule overrides the pattern above.
# The library's own do without the figures' libraries.
# What figures print is tested by one program, with a file for each part.
figure_tests = $(FIGURE_TESTS:%.c=$(BUILD)/%)
figure_parts = $(patsubst %.c,$(BUILD)/%.o,$(wildcard tests/figures/parts/*.c))
library_tests = $(filter-out $(figure_tests),$(TESTS))
$(figure_tests:=.o) $(figure_parts): $(BUILD)/renderer.flags | $(generated)
$(figure_tests:=.o) $(figure_parts): USES = $(drawing_flags)
$(BUILD)/tests/figures/numbers: $(figure_parts)
$(figure_tests): $(BUILD)/%: $(BUILD)/%.o $(BUILD)/support.a $(figure_archives)
	@echo 'link    $@'
	$(Q)$(link_experiments) @$(BUILD)/renderer.libraries \
	    $$(pkg-config --libs check) $(SPARSE) $(YAML) $(ZLIB) -lgmp -lm -o $@

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
##@ Start here

check: need-check ## build and run the tests
	@rm -f $(TESTS:=.log); $(MAKE) $(parallel) -k -O run-tests \
	    $(if $(partial),SUPPORT='$(SUPPORT)'); built=$$?; \
	sh tests/count-checks.sh $(TESTS:=.log) && [ $$built = 0 ]

run-tests: $(library_file) $(program_file) $(TESTS:=.log) \
	$(if $(WHOLE),$(drawing_file) check-renderer)
.PHONY: check run-tests

sanitizers = -fsanitize=address,undefined,float-cast-overflow \
	-fno-sanitize-recover=all -fno-omit-frame-pointer

# Of the tests of figures, all.c draws every one, and the others would only draw
# them again.  It comes first since it takes longest.
sanitized_tests = $(BUILD)/tests/figures/all \
	$(filter-out $(BUILD)/tests/figures/%,$(figure_tests)) $(library_tests)
##@ Check

check-sanitize: ## run the tests under AddressSanitizer and UBSan
	@$(MAKE) check BUILD=$(BUILD)/sanitize TF_TEST_PERCENT=2 \
	    CFLAGS='-O1 -g1 $(sanitizers)' \
	    TESTS='$(sanitized_tests:$(BUILD)/%=$(BUILD)/sanitize/%)'

# Threads of the test answer at once what one answered before.  The log is made
# even if checks fail; grep sees whether it says that all passed.
thread_logs = $(patsubst %,$(BUILD)/threads/tests/%.log,base/memory whole/threads \
	whole/surface_threads threads/threads)
check-threads: need-check ## run many threads at once under ThreadSanitizer
	@$(MAKE) $(thread_logs) BUILD=$(BUILD)/threads TF_TEST_PERCENT=10 \
	    CFLAGS='-O1 -g1 -fsanitize=thread'
	@for log in $(thread_logs); do grep -q '^100%' $$log || exit 1; done
.PHONY: check-sanitize check-threads

# Fuzzing finds new inputs in a copy of each corpus.  To trace comparisons of
# numbers, too, would take two thirds of the time and find nothing.
SECONDS = 60
fuzzing = -fsanitize=fuzzer-no-link -fno-sanitize-coverage=trace-cmp
##@ Check for long

fuzz: need-fuzz ## run every fuzzer, or FUZZER=interface, for SECONDS=60
	@$(MAKE) $(parallel) -k -O run-fuzzers BUILD=$(BUILD)/fuzz CC=clang \
	    CFLAGS='-O1 -g1 $(sanitizers) $(fuzzing)' \
	    LDFLAGS=-fsanitize=fuzzer

# What a fuzzer says of its own doing would push out of sight what it found.
without_progress = sed '/^\#[0-9]/d; /NEW_FUNC/d; /^\#.*Recommended/,/^\#.*End of/d'

run-fuzzers: $(FUZZERS:=.found)
# To choose inputs by entropy takes longer than to make the calls.
$(BUILD)/tests/fuzz/interface.found: fuzzer_options = -entropic=0 -max_len=256 \
	-len_control=5
$(BUILD)/tests/fuzz/%.found: $(BUILD)/tests/fuzz/% FORCE
	@mkdir -p $(BUILD)/corpus/$* && cp -R tests/fuzz/corpus/$*/. $(BUILD)/corpus/$*
	@$< $(fuzzer_options) -max_total_time=$(SECONDS) -artifact_prefix=$<- \
	    $(BUILD)/corpus/$* \
	    >$@ 2>&1 || { $(without_progress) $@ | tail -n 60; false; }
	@printf '%-32s %s\n' tests/fuzz/$* "$$(grep '^Done' $@)"
.PHONY: fuzz run-fuzzers

# Interrupted, this prints how to go on.
COUNT = 100000000
FROM = 0
soak: $(BUILD)/tests/soak/soak ## answer COUNT=100000000 queries in two ways
	@$< $(COUNT) $(FROM)

soak-vectors: $(BUILD)/tests/soak/vectors ## compare COUNT=100000000 verdicts by vectors
	@$< $(COUNT)

soak-response: COUNT = 10000
soak_response = $(patsubst %,$(BUILD)/tests/%,soak/response whole/response \
	whole/response_cases)
soak-response: $(soak_response) ## resolve COUNT=10000 random proposals, longer scenes
	@$< $(COUNT) $(FROM)
	@TF_TEST_PERCENT=200 $(BUILD)/tests/whole/response
	@TF_TEST_PERCENT=400 $(BUILD)/tests/whole/response_cases

soak-surgery: COUNT = 500000
soak-surgery: $(BUILD)/tests/soak/surgery ## try COUNT=500000 operations on surfaces
	@$< $(COUNT) $(FROM)

soak-remeshing: COUNT = 200000
soak-remeshing: $(BUILD)/tests/soak/remeshing ## judge COUNT=200000 operations with sharp edges
	@$< $(COUNT) $(FROM)

soak-topology: COUNT = 100000
soak-topology: $(BUILD)/tests/soak/topology ## merge and pinch among COUNT=100000 operations
	@$< $(COUNT) $(FROM)

soak-scales: COUNT = 10000
soak-scales: $(BUILD)/tests/soak/scales ## remesh and move COUNT=10000 scenes of any size
	@$< $(COUNT) $(FROM)

soak-zones: COUNT = 10000
soak-zones: $(BUILD)/tests/soak/zones ## resolve COUNT=10000 steps from tangled starts
	@$< $(COUNT) $(FROM)
	@$< 500 $(FROM) weak

soak-scenes: $(BUILD)/tests/soak/scenes ## simulate all scenes, and judge every step
	@$<

.PHONY: soak soak-vectors soak-response soak-surgery soak-remeshing soak-topology \
	soak-scales soak-zones soak-scenes
