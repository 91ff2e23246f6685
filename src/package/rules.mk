# The package: what users get of the library, and its installation.
#
# The public header, $(BUILD)/include/tanglefree.h, is made of the headers of
# src/ that include base/api.h.  The library comes as an archive, as a shared
# library, and as two files to compile along, in $(BUILD)/single.  The threads
# of src/threads are a library upon it, with a header, an archive and two files.

version := $(shell sed -n 's/^\#define TF_VERSION "\(.*\)"$$/\1/p' \
	src/base/version.h)
soname := libtanglefree.so.$(firstword $(subst ., ,$(version)))

public_header = $(BUILD)/include/tanglefree.h
shared_library = $(BUILD)/libtanglefree.so.$(version)
shared_links = $(BUILD)/$(soname) $(BUILD)/libtanglefree.so
threads_header = $(BUILD)/include/tanglefree_threads.h
threads_library = $(BUILD)/libtanglefree_threads.a
single_files = $(foreach name,tanglefree tanglefree_threads,\
	$(BUILD)/single/$(name).c $(BUILD)/single/$(name).h)

library: $(public_header) $(shared_library) $(shared_links)
library: $(threads_header) $(threads_library)
##@ Package and install

single: $(single_files) ## make the library a single file, in build/single
.PHONY: single

# $(call paste,SCRIPT): what it makes of the library's files, and
# $(call paste,SCRIPT,threads): of those upon it.
paste = echo 'paste   $@' && mkdir -p $(@D) && \
	awk -f src/package/source.awk -f src/package/$(1).awk -v src=src \
	    -v version=$(version) $(if $(2),-v added=$(2)) $(LIBRARY) \
	    $(if $(2),$(THREADS)) >$@
pasted = book/chapters LICENSE src/package/source.awk \
	$(wildcard $(LIBRARY:%=src/%.[ch]) $(THREADS:%=src/%.[ch]))

$(public_header): src/package/header.awk $(pasted)
	@$(call paste,header)
$(threads_header): src/package/header.awk $(pasted)
	@$(call paste,header,threads)
$(BUILD)/single/tanglefree.c: src/package/single.awk $(pasted)
	@$(call paste,single)
$(BUILD)/single/tanglefree_threads.c: src/package/single.awk $(pasted)
	@$(call paste,single,threads)
$(BUILD)/single/%.h: $(BUILD)/include/%.h
	@mkdir -p $(@D) && cp $< $@

# Only the libraries are built with hidden symbols: in a program that would also
# hide argp_program_version, which libc looks up.
$(call objects,$(LIBRARY) $(THREADS)): private COMPILE += -fPIC \
	-fvisibility=hidden

$(threads_library): $(call objects,$(THREADS))

$(shared_library): $(call objects,$(LIBRARY)) book/chapters
	@echo 'link    $@'
	$(Q)$(LINK) -shared -Wl,-soname,$(soname) -Wl,--no-undefined \
	    $(filter %.o,$^) -lm -o $@
$(shared_links): $(shared_library)
	@ln -sf $(<F) $@

# The manual pages -------------------------------------------------------------

# That of a command is made of its file and the help of the command, and the help
# of what the file has for it; others are as they are.
manual = src/package/manual
pages = $(addprefix $(BUILD)/man/,$(notdir $(wildcard $(manual)/*.[1-9])))
draw_page = $(BUILD)/man/tanglefree-draw.1
descriptions = $(BUILD)/man/descriptions

program: $(if $(MAIN),$(pages))
drawing: $(draw_page)

$(BUILD)/man/%.1: $(manual)/%.1 $(manual)/page.awk $(program_file)
	@echo 'write   $@'
	$(Q)ARGP_HELP_FMT= $(EMULATOR) $(program_file) \
	    $(patsubst tanglefree%,%,$(subst -, ,$*)) --help | \
	    awk -f $(manual)/page.awk - $< >$@

$(BUILD)/man/%.5: $(manual)/%.5
	@mkdir -p $(@D) && cp $< $@
$(draw_page): figures/draw/tanglefree-draw.1
	@mkdir -p $(@D) && cp $< $@

$(descriptions).c: $(manual)/help.awk $(wildcard $(manual)/tanglefree-*.1)
	@echo 'write   $@' && mkdir -p $(@D)
	$(Q)awk -f $^ >$@
$(descriptions).o: $(descriptions).c $(BUILD)/flags | need-build
	$(Q)$(COMPILE) -c $< -o $@
$(BUILD)/program.a: $(descriptions).o

# The scenes that the program has built in, as files ---------------------------

scenes = $(addprefix $(BUILD)/scenes/,sphere.yaml stack.yaml twist.yaml \
	knot.yaml curtain.yaml flag.yaml plane-chain.yaml spheres.yaml \
	dumbbell.yaml enright.yaml turbulence.yaml star.yaml sheets.yaml)

$(BUILD)/scenes/%.yaml: $(program_file)
	@echo 'write   $@' && mkdir -p $(@D)
	$(Q)$(EMULATOR) $(program_file) simulate list $* >$@

# The installation -------------------------------------------------------------

# A line a file: where below PREFIX, and what, "->" for a link.
define installed
bin/tanglefree $(program_file)
include/tanglefree.h $(public_header)
include/tanglefree_threads.h $(threads_header)
lib/libtanglefree.a $(library_file)
lib/libtanglefree_threads.a $(threads_library)
lib/libtanglefree.so.$(version) $(shared_library)
lib/$(soname) -> libtanglefree.so.$(version)
lib/libtanglefree.so -> libtanglefree.so.$(version)
lib/pkgconfig/tanglefree.pc src/package/tanglefree.pc
lib/pkgconfig/tanglefree_threads.pc src/package/tanglefree_threads.pc
lib/cmake/tanglefree/tanglefreeConfig.cmake src/package/tanglefreeConfig.cmake
lib/cmake/tanglefree/tanglefreeConfigVersion.cmake src/package/tanglefreeConfigVersion.cmake
share/doc/tanglefree/examples/check.c examples/check.c
share/doc/tanglefree/examples/cloth.c examples/cloth.c
share/doc/tanglefree/examples/query.c examples/query.c
share/doc/tanglefree/examples/remesh.c examples/remesh.c
share/doc/tanglefree/examples/threads.c examples/threads.c
share/doc/tanglefree/examples/scene/scene.yaml examples/scene/scene.yaml
share/doc/tanglefree/examples/scene/table.obj examples/scene/table.obj
share/doc/tanglefree/examples/scene/cloth-0.obj examples/scene/cloth-0.obj
share/doc/tanglefree/examples/scene/cloth-1.obj examples/scene/cloth-1.obj
share/doc/tanglefree/examples/scene/cloth-2.obj examples/scene/cloth-2.obj
share/doc/tanglefree/examples/walk/walk.py examples/walk/walk.py
share/doc/tanglefree/examples/walk/walk.yaml examples/walk/walk.yaml
share/doc/tanglefree/examples/walk/judge.yaml examples/walk/judge.yaml
share/doc/tanglefree/examples/walk/waist.txt examples/walk/waist.txt
share/tanglefree/scenes/sphere.yaml $(BUILD)/scenes/sphere.yaml
share/tanglefree/scenes/stack.yaml $(BUILD)/scenes/stack.yaml
share/tanglefree/scenes/twist.yaml $(BUILD)/scenes/twist.yaml
share/tanglefree/scenes/knot.yaml $(BUILD)/scenes/knot.yaml
share/tanglefree/scenes/curtain.yaml $(BUILD)/scenes/curtain.yaml
share/tanglefree/scenes/flag.yaml $(BUILD)/scenes/flag.yaml
share/tanglefree/scenes/plane-chain.yaml $(BUILD)/scenes/plane-chain.yaml
share/tanglefree/scenes/spheres.yaml $(BUILD)/scenes/spheres.yaml
share/tanglefree/scenes/dumbbell.yaml $(BUILD)/scenes/dumbbell.yaml
share/tanglefree/scenes/enright.yaml $(BUILD)/scenes/enright.yaml
share/tanglefree/scenes/turbulence.yaml $(BUILD)/scenes/turbulence.yaml
share/tanglefree/scenes/star.yaml $(BUILD)/scenes/star.yaml
share/tanglefree/scenes/sheets.yaml $(BUILD)/scenes/sheets.yaml
share/man/man1/tanglefree.1 $(BUILD)/man/tanglefree.1
share/man/man1/tanglefree-query.1 $(BUILD)/man/tanglefree-query.1
share/man/man1/tanglefree-detect.1 $(BUILD)/man/tanglefree-detect.1
share/man/man1/tanglefree-check.1 $(BUILD)/man/tanglefree-check.1
share/man/man1/tanglefree-resolve.1 $(BUILD)/man/tanglefree-resolve.1
share/man/man1/tanglefree-remesh.1 $(BUILD)/man/tanglefree-remesh.1
share/man/man1/tanglefree-simulate.1 $(BUILD)/man/tanglefree-simulate.1
share/man/man1/tanglefree-weld.1 $(BUILD)/man/tanglefree-weld.1
share/man/man1/tanglefree-untangle.1 $(BUILD)/man/tanglefree-untangle.1
share/man/man5/tanglefree-formats.5 $(BUILD)/man/tanglefree-formats.5
endef
define installed_draw
bin/tanglefree-draw $(drawing_file)
share/man/man1/tanglefree-draw.1 $(draw_page)
endef

install_sh = DESTDIR='$(DESTDIR)' PREFIX='$(PREFIX)' VERSION=$(version) \
	sh src/package/install.sh

install uninstall: export FILES = $(installed)
install-draw: export FILES = $(installed_draw)
uninstall: export DRAW = $(installed_draw)

install: library program $(scenes) ## install to PREFIX=/usr/local, below DESTDIR=
	@printf '%s\n' "$$FILES" | $(install_sh) put
install-draw: drawing ## install tanglefree-draw
	@printf '%s\n' "$$FILES" | $(install_sh) put
uninstall: ## remove what install and install-draw installed
	@printf '%s\n' "$$FILES" "$$DRAW" | $(install_sh) remove
.PHONY: install install-draw uninstall

# The binary interface ---------------------------------------------------------

# What programs have been compiled for: a description of the library of the last
# release of this major version.
abi = src/package/abi
abi_record = $(abi)/tanglefree-$(firstword $(subst ., ,$(version))).abi
abi_present = $(BUILD)/abi/tanglefree.abi

$(abi_present): $(single_files) $(wildcard $(abi)/*.awk) $(abi)/describe.sh | \
		need-abi
	@echo 'write   $@' && mkdir -p $(@D)
	$(Q)cp $(single_files) $(@D) && CC='$(CC)' sh $(abi)/describe.sh $(@D)

##@ Package and install

abi-record: $(abi_present) ## record the binary interface, for a release
	@rm -f $(abi)/tanglefree-*.abi && cp $(abi_present) $(abi_record)
	@echo 'recorded $(abi_record)'

##@ Check

check-abi: library $(abi_present) ## check that programs of the last release still run
	@$(package_check)/abi.sh $(abi_record)
.PHONY: abi-record check-abi

# The checks -------------------------------------------------------------------

# The scripts do what users do: they see neither src/ nor its modules.
package_check = BUILD=$(abspath $(BUILD)) CC='$(CC)' VERSION=$(version) \
	MAKE='$(MAKE)' sh tests/package

##@ Check

check-install: library program need-install ## install to build/install, and test what is there
	@$(package_check)/tree.sh install
	@$(package_check)/use.sh
	@$(package_check)/pages.sh
	@$(package_check)/tree.sh uninstall
	@echo 'installed, used and removed'

check-single: library single need-single ## test that the single file answers the same
	@$(package_check)/paste.sh
	@$(package_check)/exports.sh
	@$(package_check)/single.sh
.PHONY: check-install check-single
