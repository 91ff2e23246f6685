# Tanglefree: `make` builds, `make check` tests, `make help` tells the rest.
#
# book/chapters is the one list of modules: a line a chapter, its slug and then
# its modules, which are paths below src/ without their endings.  Those below
# program/ make the program, all others the library.  A test is a file a
# module, with the module's path below tests/.  All output goes to $(BUILD).

PREFIX = /usr/local
BUILD = build

ifeq ($(origin CC),default)
CC = gcc
endif
CFLAGS ?= -O3
WARNINGS = -Wall -Wextra -Wpedantic -Wshadow -Wconversion

# What the code relies on comes last, where CFLAGS cannot undo it.
COMPILE = $(CC) $(CPPFLAGS) $(WARNINGS) $(CFLAGS) -std=c17 -ffp-contract=off
LINK = $(CC) $(CFLAGS) $(LDFLAGS)

Q = $(if $(V),,@)
MAKEFLAGS += --no-builtin-rules --no-print-directory
parallel = $(if $(filter -j%,$(MAKEFLAGS)),,-j$(shell nproc))

.DELETE_ON_ERROR:
.SECONDARY:
.PHONY: FORCE

all: library program drawing figures book ## build all: what `make` does

help: ## list the targets
	@sed -n 's/^\([a-z-]*\):.*## /\1\t/p' \
	    Makefile figures/rules.mk book/rules.mk exercises/rules.mk \
	    | expand -t 18
	@echo 'Settings: BUILD=dir, CC=clang, CFLAGS=-O2, V=1 (show the commands).'

# The modules ------------------------------------------------------------------

# A build of the first chapters alone sets CHAPTERS, and sets SRC to a tree of
# their files only.
CHAPTERS := $(shell grep -c '^[a-z]' book/chapters)
SRC = src

# $(call modules,N): the modules of the chapters 1 to N.
modules = $(shell awk '/^[a-z]/ && n++ < $(1) { for (i = 2; i <= NF; i++) \
	print $$i }' book/chapters)

MODULES := $(call modules,$(CHAPTERS))
MAIN := $(filter program/main,$(MODULES))
PROGRAM := $(filter-out $(MAIN),$(filter program/%,$(MODULES)))
LIBRARY := $(filter-out program/%,$(MODULES))

# $(call objects,MODULES): of those that have a .c file.
objects = $(patsubst $(SRC)/%.c,$(BUILD)/src/%.o,$(wildcard $(1:%=$(SRC)/%.c)))

library = $(BUILD)/libtanglefree.a
program = $(MAIN:program/main=$(BUILD)/tanglefree)

library: $(library) ## build the library, libtanglefree.a
program: $(program) ## build the program, tanglefree
.PHONY: all help library program

# program.a is for the tests; the program is main and the same modules.
$(library): $(call objects,$(LIBRARY))
$(BUILD)/program.a: $(call objects,$(PROGRAM))
$(BUILD)/%.a: book/chapters
	@echo 'archive $@'
	$(Q)rm -f $@ && ar rcs $@ $(filter %.o,$^)

$(BUILD)/tanglefree: $(call objects,$(MAIN)) $(BUILD)/program.a $(library)
	@echo 'link    $@'
	$(Q)$(LINK) $^ -lm -o $@

$(BUILD)/src/%.o: $(SRC)/%.c $(BUILD)/flags | need-build
	@echo 'compile $<' && mkdir -p $(@D)
	$(Q)$(COMPILE) -I$(SRC) -MMD -MP -c $< -o $@

# Other flags than those of the last time make everything anew.
ifneq ($(COMPILE) $(LDFLAGS),$(file <$(BUILD)/flags))
$(BUILD)/flags: FORCE | $(BUILD)
	$(file >$@,$(COMPILE) $(LDFLAGS))
endif

$(BUILD):
	@mkdir -p $@

# The figures ------------------------------------------------------------------

include figures/rules.mk
include book/rules.mk

# The tests --------------------------------------------------------------------

# Every test is a program, linked with what it uses of tests/support, where
# main() is, and of what `make bench` times beside the library.  A build of the
# first chapters leaves out the support that needs more than they have.
SUPPORT := $(wildcard tests/support/*.c) tests/bench/expansion.c
ifeq ($(SRC),src)
WHOLE := $(wildcard tests/whole/*.c) $(FIGURE_TESTS)
else
SUPPORT := $(foreach file,$(SUPPORT),$(if \
	$(shell $(CC) -MM -I$(SRC) -Itests $(file) 2>/dev/null),$(file)))
endif
TESTS := $(patsubst %.c,$(BUILD)/%,$(wildcard $(MODULES:%=tests/%.c)) $(WHOLE))
FUZZERS := $(patsubst %.c,$(BUILD)/%,$(wildcard tests/fuzz/*.c))

$(BUILD)/support.a: $(SUPPORT:%.c=$(BUILD)/%.o)

$(BUILD)/tests/%.o: tests/%.c $(BUILD)/flags | need-check
	@echo 'compile $<' && mkdir -p $(@D)
	$(Q)$(COMPILE) -I$(SRC) -Itests $(USES) $$(pkg-config --cflags check) \
	    -MMD -MP -c $< -o $@

$(BUILD)/tests/%: $(BUILD)/tests/%.o $(BUILD)/support.a $(BUILD)/program.a \
		$(library)
	@echo 'link    $@'
	$(Q)$(LINK) $^ $$(pkg-config --libs check) -lgmp -lm -o $@

# Leaks of the libraries that figures use are not ours.
leaks = suppressions=$(CURDIR)/tests/stage/leaks.supp:print_suppressions=0

# A test tells its checks in the closing line of its log.  One that breaks off
# or checks nothing counts as a check that failed.
broken = 0%: Checks: 1, Failures: 0, Errors: 1
$(BUILD)/tests/%.log: $(BUILD)/tests/% $(program) FORCE
	@TANGLEFREE=$(abspath $(program)) TANGLEFREE_DRAW=$(abspath $(drawing)) \
	LSAN_OPTIONS=$(leaks) \
	$< >$@ 2>&1; status=$$?; \
	grep -q 'Failures: [1-9]\|Errors: [1-9]' $@ || \
	    { [ $$status = 0 ] && grep -q 'Checks: [1-9]' $@; } || \
	    echo "$(broken) (status $$status)" >>$@; \
	closing=$$(grep '%: Checks:' $@ | tail -n 1); \
	case $$closing in 100%*) ;; *) cat $@ ;; esac; \
	printf '%-32s %s\n' tests/$* "$$closing"

check: need-check ## build and run the tests
	@rm -f $(TESTS:=.log); \
	$(MAKE) $(parallel) -k -O run-tests; built=$$?; \
	for log in $(TESTS:=.log); do \
	    grep -s '%: Checks:' $$log || echo '$(broken)'; \
	done | awk '{ bad += $$5 + $$7; good += $$3 - $$5 - $$7 } \
	    END { print "Checks of $(words $(TESTS)) suites:"; \
	          printf "%d passed, %d failed\n", good, bad; exit bad > 0 }' && \
	[ $$built = 0 ]

run-tests: $(library) $(program) $(if $(WHOLE),$(drawing)) $(TESTS:=.log)
.PHONY: check run-tests

sanitizers = -fsanitize=address,undefined,float-cast-overflow \
	-fno-sanitize-recover=all -fno-omit-frame-pointer

check-sanitize: ## run the tests under AddressSanitizer and UBSan
	@$(MAKE) check BUILD=$(BUILD)/sanitize TF_TEST_PERCENT=10 \
	    CFLAGS='-O1 -g $(sanitizers)'
.PHONY: check-sanitize

coverage: need-coverage ## tell what lines of src/ the tests run; 95 % at least
	@find $(BUILD)/coverage -name '*.gcda' -delete 2>/dev/null || true
	@$(MAKE) check BUILD=$(BUILD)/coverage TF_TEST_PERCENT=10 CC=gcc \
	    CFLAGS='-O0 --coverage'
	@gcovr --filter src/ --object-directory $(BUILD)/coverage --fail-under-line 95
.PHONY: coverage

# Fuzzing finds new inputs in a copy of each corpus.
SECONDS = 60
fuzz: need-fuzz ## run every fuzzer for SECONDS=60
	@$(MAKE) $(parallel) -k -O run-fuzzers BUILD=$(BUILD)/fuzz CC=clang \
	    CFLAGS='-O1 -g $(sanitizers) -fsanitize=fuzzer-no-link' \
	    LDFLAGS=-fsanitize=fuzzer

run-fuzzers: $(FUZZERS:=.found)
$(BUILD)/tests/fuzz/%.found: $(BUILD)/tests/fuzz/% FORCE
	@mkdir -p $(BUILD)/corpus/$* && cp -R tests/fuzz/corpus/$*/. $(BUILD)/corpus/$*
	@$< -max_total_time=$(SECONDS) -artifact_prefix=$<- $(BUILD)/corpus/$* \
	    >$@ 2>&1 || { tail -n 60 $@; false; }
	@printf '%-32s %s\n' tests/fuzz/$* "$$(grep '^Done' $@)"
.PHONY: fuzz run-fuzzers

bench: $(BUILD)/bench/program ## time the library
	@$<

# Figures show what was measured, so that this may need no more than they do.
timing = $(patsubst tests/%.c,$(BUILD)/bench/%.o,tests/bench/bench.c \
	tests/bench/workloads.c tests/bench/expansion.c tests/support/generator.c)
$(BUILD)/bench/program: $(timing) $(library)
	@echo 'link    $@'
	$(Q)$(LINK) $^ -lm -o $@

$(BUILD)/bench/%.o: tests/%.c $(BUILD)/flags | need-build
	@echo 'compile $<' && mkdir -p $(@D)
	$(Q)$(COMPILE) -I$(SRC) -Itests -MMD -MP -c $< -o $@

# Measured once, with the usual flags, whatever CFLAGS of this build.
measure: ## time the library anew for the figures of the book
	@$(MAKE) build/measured/bench/program BUILD=build/measured CFLAGS=-O3 LDFLAGS=
	@echo 'measure $(measured)'
	@build/measured/bench/program --header >$(measured).new
	@mv $(measured).new $(measured)

$(measured): figures/measured.h tests/bench/bench.c tests/bench/workloads.c
	@$(MAKE) measure

.PHONY: bench measure

counts: $(BUILD)/tests/bench/counts ## count what the report's rule misses
	@$<
.PHONY: counts

# The chapters -----------------------------------------------------------------

# $(call refuse,WORDS,WHY): a complaint for each of the words.
refuse = $(foreach word,$(1),echo '$(word) $(2)'; wrong=1;)
twice = $(foreach word,$(sort $(1)),$(if \
	$(filter-out 1,$(words $(filter $(word),$(1)))),$(word)))

sources = $(shell cd src && find * -name '*.[ch]')
tested = $(filter-out support/% whole/% fuzz/% bench/% stage/% draw/% \
	figures/%,$(shell cd tests && find * -name '*.c'))

check-manifest: ## compare book/chapters with src/ and tests/
	@wrong=0; \
	$(call refuse,$(call twice,$(shell awk '/^[a-z]/ { print $$1 }' \
	    book/chapters)),names two chapters) \
	$(call refuse,$(call twice,$(MODULES)),is in book/chapters twice) \
	$(call refuse,$(filter-out $(basename $(sources)),$(MODULES)),is in \
	    book/chapters but not in src/) \
	$(call refuse,$(filter-out $(MODULES:=.c) $(MODULES:=.h),$(sources)),in \
	    src/ is in no line of book/chapters) \
	$(call refuse,$(filter-out $(MODULES:=.c),$(tested)),in tests/ tests no \
	    module) \
	$(call refuse,$(filter-out $(tested) program/main.c,$(filter \
	    %.c,$(sources))),in src/ has no test in tests/) \
	exit $$wrong

tree = $(BUILD)/chapter/$(N)/tree
files = $(shell cd src && ls $(patsubst %,%.[ch],$(call modules,$(N))) \
	2>/dev/null)

# A module that is needed too early moves to an earlier line of book/chapters.
known = echo 'The first $(N) chapters have only: $(call modules,$(N))'

chapter: need-check ## build and test the first N=3 chapters alone
	$(if $(filter $(N),$(shell seq $(CHAPTERS))),,$(error Which chapter? \
	    make chapter N=1 to N=$(CHAPTERS)))
	@rm -rf $(tree) && for file in $(files); do \
	    mkdir -p $(tree)/$$(dirname $$file) && \
	    ln -s $(CURDIR)/src/$$file $(tree)/$$file || exit 1; done
	@for header in $(filter %.h,$(files)); do $(COMPILE) -I$(tree) \
	    -fsyntax-only -x c $(tree)/$$header || { $(known); exit 1; }; done
	@$(MAKE) check BUILD=$(BUILD)/chapter/$(N) SRC=$(tree) CHAPTERS=$(N) || \
	    { $(known); exit 1; }

check-chapters: need-chapters ## see that each chapter needs no later one
	@wrong=0; $(MAKE) check-manifest || wrong=1; \
	python3 book/fragments.py check src || wrong=1; \
	python3 tests/book/fragments_test.py || wrong=1; \
	for n in $$(seq $(CHAPTERS)); do echo "Chapter $$n"; \
	    $(MAKE) chapter N=$$n TF_TEST_PERCENT=5 || wrong=1; done; exit $$wrong
.PHONY: check-manifest chapter check-chapters

# The source -------------------------------------------------------------------

code = $(shell find src figures tests book -name '*.[ch]')

check-format: need-format ## compare the layout with .clang-format
	@clang-format --dry-run -Werror $(code)

format: need-format ## lay the code out as .clang-format says
	@clang-format -i $(code)

paths = -Isrc -Ifigures -Itests -I$(dir $(measured)) \
	$$(cat $(BUILD)/stage.flags)

# cppcheck takes a struct for a pointer to the arguments that it came from, and
# a pointer that is copied byte by byte for lost.
check-static: $(BUILD)/stage.flags $(measured)
check-static: need-static ## read the code: warnings, clang-tidy, cppcheck
	@for cc in gcc clang; do $$cc $(WARNINGS) -Werror -std=c17 $(paths) \
	    $$(pkg-config --cflags check) -fsyntax-only $(filter %.c,$(code)) \
	    || exit 1; done
	@cppcheck --quiet --error-exitcode=1 --std=c11 -Isrc -Ifigures \
	    -Itests -j $$(nproc) --enable=warning,performance,portability \
	    --suppress=returnDanglingLifetime \
	    --suppress=memleak:figures/stage/list.c src figures tests
	@find src figures -name '*.c' | xargs -P $$(nproc) -n 4 sh -c 'clang-tidy \
	    --quiet --warnings-as-errors="*" "$$@" -- -std=c17 $(paths) \
	    2>/dev/null' sh
.PHONY: check-format format check-static

proofs: need-proofs ## prove the error bounds, from the constants in the code
	@python3 tests/proofs/prove.py
	@python3 tests/proofs/worst.py
	@python3 tests/proofs/prove_test.py
.PHONY: proofs

# Four builds must give the same answers to the last bit, and a build that
# gives other answers must not come about.
compilers = gcc-O0 gcc-O2 gcc-O3 clang-O2
answers = $(compilers:%=$(BUILD)/compilers/%/answers)

check-compilers: need-compilers ## see that gcc and clang give the same answers
	@$(MAKE) $(parallel) $(answers)
	@for other in $(answers); do \
	    cmp $(firstword $(answers)) $$other || exit 1; done
	@echo 'the same answers: $(compilers)'
	@for cc in gcc clang; do for file in src/contract.c src/tanglefree.h; do \
	    $$cc -std=c17 -ffast-math -Isrc -fsyntax-only -x c $$file 2>&1 | \
	        grep -q 'error.*fast-math' || \
	        { echo "$$cc -ffast-math takes $$file"; exit 1; }; done; done
	@echo 'refused: -ffast-math'
	@echo 'int main(void) { return 0; }' | gcc -x c - -x none -o /dev/null \
	    -Wl,--whole-archive $(BUILD)/compilers/gcc-O0/libtanglefree.a \
	    -Wl,--no-whole-archive -lm
	@echo 'linked: libc and libm only'

$(answers): $(BUILD)/compilers/%/answers: FORCE
	@$(MAKE) library program BUILD=$(@D) CC=$(word 1,$(subst -, ,$*)) \
	    CFLAGS='-$(word 2,$(subst -, ,$*)) -Werror'
	@for kind in point-edge point-triangle edge-edge; do \
	for arithmetic in exact clamped report perturbed integer64 \
	    integer128; do \
	for output in csv json summary; do \
	    echo "$$kind $$arithmetic $$output"; \
	    $(@D)/tanglefree query --kind $$kind --arithmetic $$arithmetic \
	        --output $$output tests/queries/$$kind.csv 2>&1 || echo "status $$?"; \
	done; done; done >$@
	@! grep -A 2 ' exact ' $@ | grep '^status'
.PHONY: check-compilers

# The installation -------------------------------------------------------------

prefix = $(DESTDIR)$(PREFIX)
headers = $(patsubst src/%,%,$(wildcard $(LIBRARY:%=src/%.h)))
version = $(shell sed -n 's/.*"tanglefree \([0-9.]*\)".*/\1/p' \
	src/program/main.c)

install: library program drawing ## install to PREFIX=/usr/local, below DESTDIR=
	@install -d $(prefix)/bin $(prefix)/lib/pkgconfig
	@install $(program) $(drawing) $(prefix)/bin
	@install -m 644 $(library) $(prefix)/lib
	@for header in $(headers); do install -D -m 644 src/$$header \
	    $(prefix)/include/tanglefree/$$header || exit 1; done
	@printf '%s\n' 'Name: tanglefree' \
	    'Description: Exact continuous collision detection' \
	    'Version: $(version)' \
	    'Cflags: -I$(abspath $(PREFIX))/include/tanglefree' \
	    'Libs: -L$(abspath $(PREFIX))/lib -ltanglefree -lm' \
	    >$(prefix)/lib/pkgconfig/tanglefree.pc
	@echo 'installed to $(prefix)'

uninstall: ## remove what install put there
	@rm -rf $(prefix)/include/tanglefree
	@rm -f $(prefix)/bin/tanglefree $(prefix)/bin/tanglefree-draw \
	    $(prefix)/lib/libtanglefree.a $(prefix)/lib/pkgconfig/tanglefree.pc

# README.md has a console session and a C program; both must do what it tells.
scratch = $(abspath $(BUILD)/install)
installed = PKG_CONFIG_PATH=$(scratch)/lib/pkgconfig pkg-config

check-install: need-check ## install to build/install, try README.md there
	@rm -rf $(scratch)
	@$(MAKE) install PREFIX=$(scratch) DESTDIR=
	@sed -n '/^```console/,/^```$$/{/^```/d;p}' README.md >$(scratch)/session
	@sed -n 's/^\$$ //p' $(scratch)/session | sh >$(scratch)/answers
	@grep -v '^\$$ ' $(scratch)/session | diff - $(scratch)/answers
	@sed -n '/^```c$$/,/^```$$/{/^```/d;p}' README.md >$(scratch)/example.c
	@$(CC) $(scratch)/example.c $$($(installed) --cflags --libs tanglefree) \
	    -o $(scratch)/example
	@grep -F "$$($(scratch)/example)" README.md
	@test "$$($(scratch)/bin/tanglefree --version)" = \
	    "tanglefree $$($(installed) --modversion tanglefree)"
	@$(MAKE) uninstall PREFIX=$(scratch) DESTDIR=
	@! find $(scratch)/bin $(scratch)/lib $(scratch)/include -type f | grep .

clean: ## remove all output
	rm -rf $(BUILD)
.PHONY: install uninstall check-install clean

# The packages -----------------------------------------------------------------

# Who needs it, the Debian package (where newer systems do not have it, those
# behind the bar), how to see that it is there (a command, a header, a file of
# pkg-config's, a font, or an option that clang links with), and what for.
compiler = $(firstword $(CC))
define packages
build     $(compiler)     $(compiler)       compiles the code
build     libc6-dev       math.h            has the headers of the C library
check     check           check.h           is the framework of the tests
check     libgmp-dev      gmp.h             gives the tests exact numbers
check     pkg-config      pkg-config        tells how to link the tests
check     ffmpeg          ffmpeg            encodes the films of the tests
figures   pkg-config      pkg-config        tells how to link the figures
figures   libosmesa6-dev|libegl-dev,libgl1-mesa-dri osmesa.pc|egl.pc draws solids
figures   libpango1.0-dev pangocairo.pc     sets the letters of figures
figures   libcairo2-dev   cairo.pc          draws lines and writes PDF and SVG
figures   libpng-dev      libpng.pc         writes PNG
figures   fontconfig      fc-list           finds the letters of figures
figures   fonts-stix      font:STIXGeneral  has the letters of figures
book      python3-sphinx  sphinx-build      makes pages of the text
book      python3-myst-parser python:myst_parser reads Markdown
book      python3-sphinxcontrib.bibtex python:sphinxcontrib.bibtex reads BibTeX
book      nodejs          node              runs KaTeX
book      libjs-katex     /usr/share/javascript/katex/katex.js sets formulas
book      fonts-texgyre   font:TeXGyrePagella has the letters of the text
book      fonts-texgyre-math font:TeXGyrePagellaMath has those of formulas
book      fonts-inconsolata font:Inconsolata has the letters of the code
pdf       texlive-xetex   xelatex           sets the print
pdf       texlive-latex-extra tcolorbox.sty has the boxes of the print
pdf       texlive-fonts-recommended pzdr.tfm is what links are made with
pdf       latexmk         latexmk           runs xelatex until all is settled
site      chromium        chromium          is the browser of the check
site      chromium-driver chromedriver      steers the browser
site      python3-selenium python:selenium  tells the driver what to do
chapters  python3         python3           runs the check of the fragments
fuzz      clang           clang             compiles the fuzzers
fuzz      libclang-rt-dev -fsanitize=fuzzer runs the fuzzers
compilers clang           clang             is one of the compilers
exercises python3         python3           takes you through the exercises
exercises unifdef         unifdef           cuts your files out of the exercises
coverage  gcovr           gcovr             makes the table of lines
format    clang-format    clang-format      lays out the code
static    clang           clang             is one of the compilers
static    clang-tidy      clang-tidy        reads the code for errors
static    cppcheck        cppcheck          reads the code for errors
proofs    gappa           gappa             proves bounds of rounding errors
proofs    python3         python3           runs the proofs
endef

needs = build check figures book pdf site chapters fuzz compilers coverage \
	format static proofs exercises
.PHONY: $(needs:%=need-%) deps
need-check need-figures need-book need-compilers need-format: | need-build
ifeq ($(SRC),src)
need-check: | need-figures
endif
need-chapters need-fuzz need-coverage need-static need-exercises: | need-check
need-pdf need-site: | need-book

deps: | $(needs:%=need-%) ## install the packages that all targets need

$(needs:%=need-%): export PACKAGES = $(packages)
$(needs:%=need-%): need-%:
	@missing=$$(echo "$$PACKAGES" | while read -r who package sign purpose; do \
	    [ $$who = $* ] || continue; \
	    for one in $$(echo "$$sign" | tr '|' ' '); do \
	        case $$one in \
	        *.h) $(CC) -E -include $$one -x c /dev/null ;; \
	        *.pc) pkg-config --exists $${one%.pc} ;; \
	        font:*) fc-list "$${one#font:}" | grep . ;; \
	        *.sty|*.tfm) kpsewhich $$one ;; \
	        python:*) /usr/bin/python3 -c "import $${one#python:}" ;; \
	        /*) [ -e $$one ] ;; \
	        -*) echo 'int LLVMFuzzerTestOneInput(void) { return 0; }' | \
	            clang $$one -x c - -o /dev/null ;; \
	        *) command -v $$one ;; \
	        esac >/dev/null 2>&1 && \
	        { [ $$one = $${sign%%|*} ] || \
	            ! apt-cache show $${package%|*} >/dev/null 2>&1; } && \
	        continue 2; \
	    done; \
	    echo "$$package is missing; it $$purpose." | \
	        sed 's/|\([^ ]*\)/ (or \1)/; s/,\(.*)\)/ and \1/' >&2; \
	    case $$package in *'|'*) a=$${package%|*}; \
	        package="\$$(apt-cache show $$a >/dev/null 2>&1 && echo $$a \
	            || echo $${package#*|} | tr , ' ')" ;; \
	    esac; \
	    printf ' %s' "$$package"; done); \
	[ "$$missing" ] || exit 0; \
	command -v apt-get >/dev/null || { \
	    echo "These are Debian's names; please install them and try again."; \
	    exit 1; }; \
	install='apt-get update; apt-get install -y --no-install-recommends'; \
	install="$$install$$missing"; \
	run=; if [ "$$(id -u)" = 0 ]; then run=env; \
	elif command -v sudo >/dev/null; then run='sudo env'; fi; \
	if [ "$$run" ]; then \
	    echo "Installing: $$install"; \
	    $$run DEBIAN_FRONTEND=noninteractive sh -c "$$install" && exit 0; \
	fi; \
	echo "Please type, as root: $$install" >&2; exit 1

include exercises/rules.mk

# What the compiler found out about headers.
-include $(patsubst %,%.d,$(basename $(call objects,$(MODULES)) \
	$(SUPPORT:%.c=$(BUILD)/%.o) $(TESTS:=.o) $(FUZZERS:=.o) $(timing) \
	$(BUILD)/tests/bench/counts.o \
	$(call drawn,$(STAGE) $(DRAW) $(wildcard figures/*.c))))
