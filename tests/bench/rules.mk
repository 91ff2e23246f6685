# What is measured: programs that print, and figures/measured, which the book and
# its figures read.

##@ Measure

benches = bench surfaces speed
bench: $(benches:%=$(BUILD)/tests/bench/%) ## time the library
	@for program in $^; do $$program; done

bench-response: $(BUILD)/tests/bench/response ## time the response to contacts of cloth
	@$<

bench-cancel: $(BUILD)/tests/bench/cancelling ## time how soon cancelled calls return
	@$<

# Files of TF_SHARED_DATA, ../shared/data unless set, that are absent are left
# out, with a note.
compare: $(BUILD)/tests/bench/compare ## compare the methods: time a query, and errors
	@$<
	@awk -f tests/bench/published.awk tests/bench/published.csv

$(BUILD)/tests/bench/solvers.o: | need-solvers
$(BUILD)/tests/bench/solvers: LIBRARIES = -llapacke
compare-solvers: $(BUILD)/tests/bench/solvers ## compare the solvers of impact zones
	@$< tests/bench/zones.txt

compare-sweeps: $(BUILD)/tests/bench/sweeps ## compare numbers of sweeps on steps of cloth
	@$<

collect-zones: $(BUILD)/tests/bench/collect_zones ## collect the zones that compare-solvers solves
	@$< >$(BUILD)/zones.txt
	@mv $(BUILD)/zones.txt tests/bench/zones.txt

counts: $(BUILD)/tests/bench/counts ## count the contacts that the report's rule misses
	@$<
.PHONY: bench bench-cancel bench-response compare compare-solvers compare-sweeps \
	collect-zones counts

# The surfaces are those of the figures.
$(BUILD)/tests/bench/untangling: $(addprefix $(BUILD)/drawing/kit/,tangles.o meshes.o)

# measure-methods writes figures/measured/methods.csv, by programs that are built
# with the usual flags, whatever those of this build, below $(BUILD)/measured.
# The numbers are what tests/bench/methods.sh prints of the programs' output; it
# takes their paths and the arguments here.
##@ Measure again for the book, in figures/measured

measure-library: ## time the library
measure-methods: ## compare the methods
measure-threads: ## time tasks on several threads
measure-solvers: ## compare the solvers, and numbers of sweeps
measure-response: ## time the response
measure-simulation: ## run and time the scenes
measure-resting: ## watch whether a stack comes to rest
measure-surgery: ## operate at random, with tests left out
measure-remeshing: need-remeshing ## remesh meshes of another program
measure-topology: ## merge, pinch and drop at random
measure-flowing: ## let surfaces flow
measure-untangling: ## untangle surfaces
measured = library methods threads solvers response simulation resting \
	surgery remeshing topology flowing untangling

programs_library = $(benches:%=tests/bench/%)
programs_methods = tests/bench/compare
arguments_methods = tests/bench/published.csv
programs_threads = tests/bench/threads
programs_solvers = tests/bench/solvers tests/bench/sweeps
arguments_solvers = tests/bench/zones.txt
programs_response = tests/bench/response
programs_simulation = tanglefree tests/bench/coupling
programs_resting = tests/bench/resting
programs_surgery = tests/soak/surgery
arguments_surgery = 100000
programs_remeshing = tanglefree
programs_topology = tests/soak/topology
arguments_topology = 500000 20000
programs_flowing = tests/bench/flowing
programs_untangling = tests/bench/untangling

$(measured:%=measure-%): measure-%:
	@$(MAKE) $(parallel) BUILD=$(BUILD)/measured CFLAGS=-O3 LDFLAGS= \
	    $(programs_$*:%=$(BUILD)/measured/%)
	@echo 'measure figures/measured/$*.csv'
	@sh tests/bench/measure.sh $* '$(CC)' -O3 \
	    $(programs_$*:%=$(BUILD)/measured/%) $(arguments_$*) \
	    >$(BUILD)/measured/$*.csv
	@mv $(BUILD)/measured/$*.csv figures/measured/$*.csv

measure-all: ## all of these, one after the other
	@for name in $(measured); do $(MAKE) measure-$$name || exit 1; done
.PHONY: measure-all $(measured:%=measure-%)
