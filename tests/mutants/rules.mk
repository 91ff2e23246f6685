# The mutants: see tests/mutants/mutants.py.

##@ Check for long

# Everything is compiled anew, for a shared object.
mutants: need-mutants ## break src/ on purpose, and check that tests fail; FILE=
	@$(MAKE) $(parallel) run-mutants BUILD=$(BUILD)/mutants \
	    CFLAGS='-O2 -fPIC' FILE='$(FILE)'

# The tests of the library, but for those that take longer than all others, and
# one that wraps functions, which a linker does not do in a shared object.
unnoticing = lattice neighbours cancelling
noticing = $(filter-out $(unnoticing:%=$(BUILD)/tests/whole/%),$(filter \
	$(BUILD)/tests/whole/% $(LIBRARY:%=$(BUILD)/tests/%),$(TESTS)))
breakable = $(wildcard $(patsubst %,src/%.c,$(LIBRARY) $(PROGRAM)))

run-mutants: $(noticing:=.o) $(BUILD)/support.a $(BUILD)/experiments.a \
		$(descriptions).o
	@TF_TEST_PERCENT=10 python3 tests/mutants/mutants.py $(BUILD) \
	    '$(COMPILE)' '$(wrapped) $(BUILD)/experiments.a $(descriptions).o' \
	    "$$(pkg-config --libs check) -lgmp $(SPARSE) $(YAML) $(ZLIB) -lm" \
	    '$(breakable)' '$(noticing:$(BUILD)/%=%)' $(FILE)
.PHONY: mutants run-mutants
