# Tanglefree: `make` builds everything, the book too, and installs the packages
# that are missing (see need-%); `make library` needs only a compiler.
# `make check` tests, `make help` lists the rest.  GNU make must be 4.2 or
# later, for $(file <...).
#
# This file builds the library and the program.  Each folder's rules.mk has its
# own rules and checks: src/package (the library as users get it), figures,
# book, exercises, tests, tests/bench, tests/machines and tests/mutants.  The checks of
# the whole source are in tests/checks.mk.
#
# book/chapters is the one list of modules: a line a chapter, its slug and then
# its modules, which are paths below src/ without their endings.  Those below
# files/, formats/, writers/, scenes/, simulate/ and program/ make the program, all
# others the library, but for threads/: it is a library of its own, and a part of
# the program.
#
# All output goes to $(BUILD), except for install, measure, format and the
# exercises (WORK).

PREFIX = /usr/local
BUILD = build

ifeq ($(origin CC),default)
CC = gcc
endif
CFLAGS ?= -O3
WARNINGS = -Wall -Wextra -Wpedantic -Wshadow -Wconversion

# IEEE comes last, where CFLAGS cannot undo it: arithmetic as it is written,
# with every part of -ffast-math off.  -ffp-contract=off is there twice: clang's
# -fno-fast-math resets it, and warns unless it was off before.
IEEE = -ffp-contract=off -fno-fast-math -fno-associative-math \
	-fno-reciprocal-math -fno-finite-math-only -fsigned-zeros -ffp-contract=off

# These are dropped altogether, as is -Ofast: at link time they add start-up
# code that flushes subnormal numbers to zero.
kept_flags = $(filter-out -ffast-math -funsafe-math-optimizations, \
	$(CFLAGS:-Ofast=-O3))

# No path is in what COMPILE makes, so that builds in two places are the same, and
# a tree of the first chapters is src/ to who counts lines.
COMPILE = $(CC) $(CPPFLAGS) $(WARNINGS) $(kept_flags) -std=c17 $(IEEE) \
	"-ffile-prefix-map=$(CURDIR)=." -ffile-prefix-map=$(BUILD)/=build/ \
	$(partial:%=-ffile-prefix-map=%/=src/)
LINK = $(CC) $(kept_flags) $(LDFLAGS)

# Recipes show one line for each file they make, or with V=1 all commands.
Q = $(if $(V),,@)
MAKEFLAGS += --no-builtin-rules --no-print-directory

# Sub-makes use all processors unless -j was given.
parallel = $(if $(filter -j%,$(MAKEFLAGS)),,-j$(shell nproc))

# A recipe that fails leaves no target behind.
.DELETE_ON_ERROR:
# What is made on the way to something else stays.
.SECONDARY:
# What depends on FORCE is made every time.
.PHONY: FORCE

# need-book comes first: it installs the packages of all the others at once.
##@ Start here

all: need-book ## build everything, as `make` does
	@$(MAKE) $(parallel) library program drawing draw-figures book

# The groups in their order; those of the targets are where their rules are.
groups = Start here|Build|Check|Check for long|Book and figures|Exercises|$\
	A course|Measure|Measure again for the book, in figures/measured|$\
	Package and install
help: ## list the targets
	@awk -v order='$(groups)' -f tests/help.awk \
	    $(filter Makefile %rules.mk %checks.mk,$(MAKEFILE_LIST))
	@echo
	@echo 'Settings: BUILD=dir, CC=clang, CFLAGS=-O2, V=1 (show the commands).'

# The modules ------------------------------------------------------------------

# A build of the first chapters alone (tests/chapters.sh) sets CHAPTERS, and
# sets SRC to a tree of their files only.
CHAPTERS := $(shell grep -c '^[a-z]' book/chapters)
SRC = src
partial := $(filter-out src,$(SRC))

# $(call compiling,FILES): in such a build, those whose includes are in its tree
# (-MM fails otherwise).
compiling = $(if $(partial),$(foreach file,$(1),$(if $(shell \
	$(CC) -MM -I$(SRC) -Itests -Ifigures $(file) 2>/dev/null),$(file))),$(1))

# '#' and 'Part:' lines of the list are skipped.
MODULES := $(shell awk '/^[a-z]/ && n++ < $(CHAPTERS) { \
	for (i = 2; i <= NF; i++) print $$i }' book/chapters)
MAIN := $(filter program/main,$(MODULES))
THREADS := $(filter threads/%,$(MODULES))
CLIENTS := $(THREADS) $(filter files/% formats/% writers/% scenes/% simulate/% \
	program/%,$(MODULES))
PROGRAM := $(filter-out $(MAIN),$(CLIENTS))
LIBRARY := $(filter-out $(CLIENTS),$(MODULES))

# The program's library of sparse matrices, which the simulator uses.
SPARSE = -lcholmod

# Its library of compressed files.
ZLIB = -lz

# Its library of YAML, which files of scenes are.
YAML = -lyaml

# $(call objects,MODULES): of those that have a .c file.
objects = $(patsubst $(SRC)/%.c,$(BUILD)/src/%.o,$(wildcard $(1:%=$(SRC)/%.c)))

library_file = $(BUILD)/libtanglefree.a
program_file = $(MAIN:program/main=$(BUILD)/tanglefree)

library: $(library_file) ## build the library alone, which needs only a compiler
program: $(program_file) ## build the program, tanglefree
.PHONY: all help library program

# program.a is for the tests; the program is main and the same modules.
$(library_file): $(call objects,$(LIBRARY))
$(BUILD)/program.a: $(call objects,$(PROGRAM))

# All archives: their objects are added above and in the rules.mk; the list is a
# prerequisite so that a removed module leaves the archive.
$(BUILD)/%.a: book/chapters
	@echo 'archive $@'
	$(Q)rm -f $@ && ar rcsD $@ $(filter %.o,$^)

$(BUILD)/tanglefree: $(call objects,$(MAIN)) $(BUILD)/program.a $(library_file)
	@echo 'link    $@'
	$(Q)$(LINK) $^ $(SPARSE) $(YAML) $(ZLIB) -lm -o $@
$(BUILD)/src/simulate/dynamics.o $(BUILD)/src/simulate/filed_scene.o \
    $(BUILD)/src/scenes/scene_reader.o $(BUILD)/src/scenes/scene_file.o \
    $(BUILD)/src/formats/file_bytes.o $(BUILD)/src/files/gzip_stream.o: \
    | need-program

# Prerequisites after | are order-only: made first, but newer ones do not cause
# a rebuild.
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

##@ Build

clean: ## remove all output
	rm -rf $(BUILD)
.PHONY: clean

# The packages -----------------------------------------------------------------

# need-book and the like install the packages that tests/packages lists.
need-%:
	@CC='$(CC)' sh tests/install-packages.sh $*

deps: need-all ## install the packages that all targets need
.PHONY: deps

# The rest ---------------------------------------------------------------------

include src/package/rules.mk
include figures/rules.mk
include book/rules.mk
include tests/rules.mk
include tests/checks.mk
include tests/bench/rules.mk
include tests/machines/rules.mk
include exercises/rules.mk
include tests/mutants/rules.mk

# What the compiler found out about headers.
-include $(wildcard $(BUILD)/*/*.d $(BUILD)/*/*/*.d $(BUILD)/*/*/*/*.d)
