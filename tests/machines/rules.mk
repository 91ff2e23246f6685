# The tests on other machines, which are emulated.

# s390x is big-endian, and the library finds out how it rounds by an experiment.
# The names are those of compilers and emulators; then come Debian's, where they
# differ.
machines = aarch64 s390x
debian_aarch64 = arm64

##@ Check for long

check-machines: $(machines:%=check-machine-%) ## run the tests on emulated ARM and s390x machines
.PHONY: check-machines $(machines:%=check-machine-%)

machine = $(BUILD)/machines/$*
machine_root = $(abspath $(machine))/packages/root/usr
machine_cc = $*-linux-gnu-gcc $(patsubst %,-isystem $(machine_root)/%,include \
	include/$*-linux-gnu)
# CHOLMOD is linked statically.  What only its parallel kernels need, and the
# orders by METIS, which we do not use, stays unresolved; whatever else might be
# missing, the program of this machine would miss, too.
machine_sparse = -Wl,--unresolved-symbols=ignore-all -lcholmod -lamd -lcolamd \
	-lcamd -lccolamd -lsuitesparseconfig

$(machines:%=check-machine-%): check-machine-%: $(BUILD)/machines/%/packages \
		$(BUILD)/machines/%/emulated $(program_file) $(public_header) | need-machines
	@$(MAKE) check BUILD=$(machine) TF_TEST_PERCENT=2 \
	    CC='$(machine_cc)' \
	    LDFLAGS='-static -L$(machine_root)/lib/$*-linux-gnu' \
	    SPARSE='$(machine_sparse)' \
	    TESTS='$(library_tests:$(BUILD)/%=$(machine)/%)' WHOLE= \
	    EMULATOR='env TANGLEFREE=$(abspath $(machine))/emulated qemu-$*'
	@sh tests/machines/answers.sh $(program_file) >$(machine)/native
	@sh tests/machines/answers.sh $(machine)/emulated >$(machine)/answers
	@! grep -A 2 ' exact ' $(machine)/native | grep '^status'
	@cmp $(machine)/native $(machine)/answers
	@awk -f $(abi)/description.awk -f $(abi)/layouts.awk $(abi_record) | \
	    $(machine_cc) -std=c17 -I$(dir $(public_header)) -fsyntax-only -x c -
	@echo 'the same answers: $*'

# The program, as tests start it.
$(BUILD)/machines/%/emulated: | $(BUILD)
	@mkdir -p $(@D) && printf '#!/bin/sh\nexec qemu-%s %s "$$@"\n' $* \
	    $(abspath $(@D))/tanglefree >$@ && chmod +x $@

$(BUILD)/machines/%/packages: tests/machines/packages.sh | need-machines
	@echo 'fetch   $@' && mkdir -p $(@D)
	@sh $< $(or $(debian_$*),$*) $(abspath $@).new
	@rm -rf $@ && mv $@.new $@
