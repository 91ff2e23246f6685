# The figures: figures/renderer draws, figures/draw is the program, and each part
# of the book has a folder, with a file for each figure: plane/edge_sweep.c
# defines the figure edge-sweep.  What several figures share is in figures/kit.
#
# Experiments do without something that the library always does, to see what it
# is needed for: for the tests and the drawing program, the linker puts what
# figures/experiments calls __wrap_NAME in the place of the library's NAME, here
# __real_NAME.  The library itself has no switch.

# A file of the renderer uses only those before it; context_* are two ways to
# the same, of which a build has one.
RENDERER := status list box theme camera scene sheets mesh shaders context_egl \
	context_osmesa gl render markup letters page panel marks parts placement labels \
	axes picture output plot figure
RENDERER := $(RENDERER:%=figures/renderer/%.c)
DRAW := $(wildcard figures/draw/*.c)
FIGURES := $(shell grep -l '^const fig_figure fig_' figures/*/*.c)
figure_ids := $(sort $(basename $(notdir $(FIGURES))))

drawing_file = $(BUILD)/tanglefree-draw
figure_names = $(subst _,-,$(figure_ids))
THEMES = light dark
pictures = $(foreach theme,$(THEMES),\
	$(figure_names:%=$(BUILD)/figures/%-$(theme).png))

# Figures that move, and their films as sheets.
moving := $(basename $(notdir \
	$(shell grep -l '^    \.moves = true' figures/*/*.c)))
films = $(foreach theme,light dark,\
	$(patsubst %,$(BUILD)/films/%-$(theme).png,$(subst _,-,$(moving))))

##@ Book and figures

drawing: $(drawing_file) ## build the drawing program, tanglefree-draw
figures: ## draw all figures and films, light and dark
	@$(MAKE) $(parallel) draw-figures
# Films come first: they take long, and a short task had better be the last.
draw-figures: $(films) $(pictures)
	@:
.PHONY: drawing figures draw-figures

# $(call drawing_objects,FILES): of .c files below figures/.
drawing_objects = $(patsubst figures/%.c,$(BUILD)/drawing/%.o,$(1))

EXPERIMENTS := $(call compiling,$(wildcard figures/experiments/*.c))
wrapped := $(shell sed -n 's/^.*__wrap_\(tf_[a-z_0-9]*\).*/-Wl,--wrap=\1/p' \
	$(EXPERIMENTS) /dev/null)
$(BUILD)/experiments.a: $(call drawing_objects,$(EXPERIMENTS))

# The library with its experiments: both refer to each other.
experimental_library = $(BUILD)/experiments.a $(library_file)
link_experiments = $(LINK) $(wrapped) \
	-Wl,--start-group $(filter %.o %.a,$^) -Wl,--end-group

# Tests link these archives, which hold everything but main.
figure_archives = $(addprefix $(BUILD)/,draw.a figures.a renderer.a program.a) \
	$(experimental_library)

$(BUILD)/renderer.a: $(call drawing_objects,$(RENDERER)) figures/rules.mk
$(BUILD)/draw.a: $(call drawing_objects,$(filter-out %/main.c,$(DRAW)))
$(BUILD)/figures.a: $(call drawing_objects,$(FIGURES) $(wildcard figures/kit/*.c))

# @file, here and below: gcc reads options from that file.
$(drawing_file): $(BUILD)/drawing/draw/main.o $(figure_archives)
	@echo 'link    $@'
	$(Q)$(link_experiments) @$(BUILD)/renderer.libraries $(SPARSE) $(YAML) $(ZLIB) -lm -o $@

# What figures include that is made.  Each is written anew only if it changes.
generated = $(addprefix $(BUILD)/drawing/,names.h includes.h measured_rows.h)
unless_same = cmp -s $@.new $@ || cp $@.new $@

# All figures, a line FIG_NAME(edge_sweep) each.
$(BUILD)/drawing/names.h: FORCE
	@mkdir -p $(@D) && printf 'FIG_NAME(%s)\n' $(figure_ids) >$@.new
	@$(unless_same)

# The layers of src/ and all its includes, an initializer of two strings each.
# The folders of which the program alone is made are one layer with it.
of_program = (files|formats|writers|scenes|simulate)
$(BUILD)/drawing/includes.h: src/layers.awk $(wildcard src/*/*.[ch])
	@mkdir -p $(@D) && awk -f $< $(sort $(filter-out $<,$^)) >$@.table
	@sed -E '/^$(of_program) *$$/d; s,(^| )$(of_program)/,\1program/,g' \
	    $@.table | awk '{ print "{\"" $$1 "\", \"" $$2 "\"}," }' >$@.new
	@$(unless_same)

# The lines "name,value,unit" of what was measured, as initializers; those of
# methods.csv are named "methods ...", and so on, but for those of library.csv.
$(BUILD)/drawing/measured_rows.h: $(wildcard figures/measured/*.csv)
	@mkdir -p $(@D) && for file in $(^:figures/measured/%.csv=%); do \
	    sed -n "s/^\([^#].*\),\([-0-9.]*\),.*$$/{\"$$file \1\", \2},/p" \
	    figures/measured/$$file.csv; done | sed 's/"library /"/' >$@.new
	@$(unless_same)

drawing_flags = -I$(SRC) -Ifigures -I$(BUILD)/drawing \
	@$(BUILD)/renderer.flags
$(BUILD)/drawing/%.o: figures/%.c $(BUILD)/flags $(BUILD)/renderer.flags \
		$(BUILD)/renderer.libraries | $(generated)
	@echo 'compile $<' && mkdir -p $(@D)
	$(Q)$(COMPILE) $(drawing_flags) -MMD -MP -c $< -o $@

# These draw nothing, and need no library of figures.
$(addprefix $(BUILD)/drawing/kit/,expansion.o tangles.o meshes.o) \
		$(call drawing_objects,$(EXPERIMENTS)): \
		$(BUILD)/drawing/%.o: figures/%.c $(BUILD)/flags | need-build
	@echo 'compile $<' && mkdir -p $(@D)
	$(Q)$(COMPILE) -I$(SRC) -Ifigures -MMD -MP -c $< -o $@

# The two files of options, for compiling and for linking, are made here.  Where
# Mesa has given up OSMesa, the renderer draws by EGL.
packaged = gl=osmesa; pkg-config --exists osmesa || gl=egl; \
	pkg-config $(1) $$gl pangocairo cairo fontconfig libpng

$(BUILD)/renderer.flags: | need-figures $(BUILD)
	@{ pkg-config --exists osmesa || echo -DFIG_EGL; \
	    $(call packaged,--cflags-only-I); } >$@
$(BUILD)/renderer.libraries: | need-figures $(BUILD)
	@{ $(call packaged,--libs); } >$@

# A program that was built anew and is the same draws nothing anew.
$(BUILD)/drawing/program: $(drawing_file)
	@cmp -s $< $@ || cp $< $@

picture = @echo 'draw    $@' && mkdir -p $(@D) && \
	$< figure $* --theme $(1) --output $@ >/dev/null
$(BUILD)/figures/%-light.png: $(BUILD)/drawing/program
	$(call picture,light)
$(BUILD)/figures/%-dark.png: $(BUILD)/drawing/program
	$(call picture,dark)

# The films of the book, in at most 256 colors, which divides their bytes by
# two or three.
film = @echo 'film    $@' && mkdir -p $(@D) && $< figure $* --theme $(1) \
	--frames 49 --animate $(@D)/full-$(@F) >/dev/null && \
	OMP_NUM_THREADS=1 pngquant --nofs --force --output $@ 256 \
	$(@D)/full-$(@F) && rm $(@D)/full-$(@F)
$(BUILD)/films/%-light.png: $(BUILD)/drawing/program
	$(call film,light)
$(BUILD)/films/%-dark.png: $(BUILD)/drawing/program
	$(call film,dark)

# The pictures in README.md, kept in figures/readme: the cover, the query that
# its first command makes, and films, which take minutes and are not checked.
first_query := $(shell sed -n "s/.*printf '%s.n' \(.*\) | .*/\1/p" README.md)
README = $(foreach theme,light dark,cover-$(theme).png query-$(theme).png)

$(BUILD)/readme/cover-%.png: $(BUILD)/drawing/program
	@echo 'draw    $@' && mkdir -p $(@D)
	$(Q)$< figure cover --theme $* --size 640x567 -o $@ >/dev/null
$(BUILD)/readme/query-%.png: $(BUILD)/drawing/program README.md
	@echo 'draw    $@' && mkdir -p $(@D)
	$(Q)printf '%s\n' $(first_query) | $< query /dev/stdin:0 \
	    --kind point-edge --theme $* --size 800x450 -o $@ >/dev/null

# The scenes of the films, with their options: finer than by default, which takes
# seconds to a minute each.
scene_sphere = sphere --size 64
scene_stack = stack --size 32
scene_twist = twist --size 16
scene_knot = knot --size 8
scene_curtain = curtain --size 56
scene_flag = flag --size 40
scene_plane-chain = plane-chain
scene_enright = enright --edge 0.0113
$(BUILD)/scenes/%/steps.csv: $(program_file)
	@echo 'simulate $(@D)' && mkdir -p $(BUILD)/scenes && rm -rf $(@D)
	$(Q)$< simulate $(scene_$*) -o $(@D) >/dev/null
scene_film = @echo 'film    $@' && mkdir -p $(@D) && $< film \
	$(BUILD)/scenes/$* --theme $1 --size 640x400 --every 3 --fps 25 -o $@ >/dev/null
$(BUILD)/readme/%-light.webp: $(BUILD)/drawing/program $(BUILD)/scenes/%/steps.csv
	$(call scene_film,light)
$(BUILD)/readme/%-dark.webp: $(BUILD)/drawing/program $(BUILD)/scenes/%/steps.csv
	$(call scene_film,dark)

# Films of the scenes of cloth for download, which take minutes each.
CLOTH = sphere stack twist knot curtain flag plane-chain
download = $(foreach theme,light dark,\
	$(patsubst %,$(BUILD)/download/%-$(theme).mp4,$(CLOTH)))
download_film = @echo 'film    $@' && mkdir -p $(@D) && $< film \
	$(BUILD)/scenes/$* --theme $1 --size 1920x1080 --every 3 --fps 25 -o $@ >/dev/null
$(BUILD)/download/%-light.mp4: $(BUILD)/drawing/program $(BUILD)/scenes/%/steps.csv
	$(call download_film,light)
$(BUILD)/download/%-dark.mp4: $(BUILD)/drawing/program $(BUILD)/scenes/%/steps.csv
	$(call download_film,dark)
films: $(download) ## film the scenes of cloth, 1920 by 1080, for download
.PHONY: films

README_FILMS = $(foreach scene,stack enright,$(scene)-light.webp $(scene)-dark.webp)
readme_pictures = $(addprefix $(BUILD)/readme/,$(README) $(README_FILMS))
draw-readme: $(readme_pictures) ## draw the pictures of README.md anew
	@mkdir -p figures/readme && cp $^ figures/readme

##@ Check

check-readme: need-book $(README:%=$(BUILD)/readme/%) ## check the pictures of README.md
	@python3 tests/figures/same_pictures.py $(BUILD)/readme figures/readme
.PHONY: draw-readme check-readme

check-renderer: $(call drawing_objects,$(RENDERER)) ## check the order of the renderer's files
	@nm -P -A $^ | awk -f figures/renderer/order.awk
.PHONY: check-renderer
