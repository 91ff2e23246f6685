# The checks of the whole source, besides the tests.  Each folder's own are in
# its rules.mk, and so are those of tests/machines and tests/mutants.

# The chapters -----------------------------------------------------------------

##@ Check

check-manifest: ## compare book/chapters, README.md, src/ and tests/
	@sh tests/manifest.sh
	@$(MAKE) help >/dev/null

check-layers: ## check the order of the layers and modules of src/
	@awk -f src/layers.awk $(sort $(shell find src -name '*.[ch]')) >/dev/null

run_chapters = BUILD=$(BUILD) COMPILE='$(CC) $(WARNINGS) -std=c17' \
	sh tests/chapters.sh
##@ Build

chapter: need-check ## build and test the code of chapters 1 to N=3
	@MAKE='$(MAKE)' $(run_chapters) '$(N)'

##@ Check

# Their tests note which lines of src/ they run, for `make coverage`.
chapters_built = $(BUILD)/chapter/all
counting = -O1 --coverage -fprofile-update=atomic
check-chapters: need-chapters ## check that no chapter needs a later one
check-chapters: check-manifest check-layers
	@python3 book/fragments.py check src
	@python3 tests/book/fragments_test.py
	@find $(chapters_built) -name '*.gcda' -delete 2>/dev/null || true
	@MAKE='$(MAKE) CC=gcc' CFLAGS='$(counting)' TF_TEST_PERCENT=5 \
	    $(run_chapters) all

coverage: check-chapters need-coverage ## list which lines of src/ the tests run; at least 95 %
	@gcovr --filter src/ --object-directory $(chapters_built) -j $$(nproc) \
	    --fail-under-line 95 $(chapters_built)/src
.PHONY: check-manifest check-layers chapter check-chapters coverage

# The source -------------------------------------------------------------------

source_files = $(shell find src figures tests book examples -name '*.[ch]')

check-format: need-format ## check that the code is formatted as .clang-format says
	@clang-format --dry-run -Werror $(source_files)

##@ Build

format: need-format ## format the code as .clang-format says
	@clang-format -i $(source_files)

include_paths = -Isrc -Ifigures -Itests -I$(BUILD)/drawing \
	-I$(dir $(public_header)) $$(cat $(BUILD)/renderer.flags)

##@ Check

# Of OpenMP only gcc has the header at hand.
openmp = book/openmp.c

# Two false positives of cppcheck:
# returnDanglingLifetime: it mistakes a struct for a pointer to its arguments;
# memleak: it believes that a pointer is lost when its bytes are copied.
check-static: $(BUILD)/renderer.flags $(generated) $(public_header) $(threads_header)
check-static: need-static ## analyze the code: warnings, clang-tidy, cppcheck
	@for cc in gcc clang; do \
	    echo $(filter-out $(openmp),$(filter %.c,$(source_files))) | \
	    xargs -P $$(nproc) -n 16 $$cc $(WARNINGS) -Werror -std=c17 \
	    $(include_paths) $$(pkg-config --cflags check) -fsyntax-only || \
	    exit 1; done
	@gcc $(WARNINGS) -Werror -std=c17 $(include_paths) -fopenmp -fsyntax-only \
	    $(openmp)
	@cppcheck --quiet --error-exitcode=1 --std=c11 -Isrc -Ifigures \
	    -Itests -j $$(nproc) --enable=warning,performance,portability \
	    --suppress=returnDanglingLifetime \
	    --suppress=memleak:figures/renderer/list.c src figures tests examples
	@find src figures -name '*.c' | xargs -P $$(nproc) -n 4 sh -c 'clang-tidy \
	    --quiet --warnings-as-errors="*" "$$@" -- -std=c17 $(include_paths) \
	    2>/dev/null' sh
.PHONY: check-format format check-static

proofs: need-proofs ## prove the error bounds with the constants in the code
	@python3 tests/proofs/prove.py $(SCRIPT)
	@$(if $(SCRIPT),,python3 tests/proofs/prove.py $(wildcard exercises/*.gappa))
	@python3 tests/proofs/worst.py
	@python3 tests/proofs/prove_test.py
.PHONY: proofs

# The builds -------------------------------------------------------------------

check-compilers: need-compilers ## check that gcc and clang give the same answers
	@MAKE='$(MAKE) $(parallel)' BUILD=$(BUILD) sh tests/compilers.sh

check-simd: need-compilers ## check that compilers vectorize the loops over lanes
	@BUILD=$(BUILD) sh tests/simd.sh

check-reproducible: need-book ## check that two builds are identical, films or FILM= too
	@MAKE='$(MAKE) $(parallel)' BUILD=$(BUILD) FILM=$(FILM) sh tests/reproducible.sh
.PHONY: check-compilers check-simd check-reproducible
