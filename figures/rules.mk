# The figures: figures/stage is the renderer, figures/draw the program, and a
# figure is a file here, edge_sweep.c the one named edge-sweep.

STAGE := $(wildcard figures/stage/*.c)
DRAW := $(wildcard figures/draw/*.c)
FIGURES := $(filter-out figures/figures.c figures/measured.c \
	figures/worlds.c,\
	$(wildcard figures/*.c))

drawing = $(BUILD)/tanglefree-draw
names = $(subst _,-,$(FIGURES:figures/%.c=%))
pictures = $(foreach theme,light dark,\
	$(names:%=$(BUILD)/figures/%-$(theme).png))

drawing: $(drawing) ## build the program that draws, tanglefree-draw
figures: ## draw all figures, light and dark, in build/figures
	@$(MAKE) $(parallel) draw-figures
draw-figures: $(pictures)
	@:
.PHONY: drawing figures draw-figures

# As for the program, the archives are all that tests need besides.
drawn = $(patsubst figures/%.c,$(BUILD)/drawing/%.o,$(1))
archives = $(addprefix $(BUILD)/,draw.a figures.a stage.a program.a) $(library)

$(BUILD)/stage.a: $(call drawn,$(STAGE))
$(BUILD)/draw.a: $(call drawn,$(filter-out %/main.c,$(DRAW)))
$(BUILD)/figures.a: $(call drawn,$(wildcard figures/*.c)) \
	$(BUILD)/bench/bench/expansion.o

$(drawing): $(BUILD)/drawing/draw/main.o $(archives)
	@echo 'link    $@'
	$(Q)$(LINK) $^ @$(BUILD)/stage.libraries -lm -o $@

$(BUILD)/drawing/%.o: figures/%.c $(BUILD)/flags $(BUILD)/stage.flags \
		$(BUILD)/stage.libraries
	@echo 'compile $<' && mkdir -p $(@D)
	$(Q)$(COMPILE) -I$(SRC) -Ifigures @$(BUILD)/stage.flags -MMD -MP \
	    -c $< -o $@

# What `make measure` writes.
measured = build/measured/tables.h
$(BUILD)/drawing/measured.o: $(measured)
$(BUILD)/drawing/measured.o: COMPILE += -I$(dir $(measured))

# Where Mesa has given up OSMesa, the stage draws by EGL.
packaged = gl=osmesa; pkg-config --exists osmesa || gl=egl; \
	pkg-config $(1) $$gl pangocairo cairo fontconfig libpng

$(BUILD)/stage.flags: | need-figures $(BUILD)
	@{ pkg-config --exists osmesa || echo -DTF_STAGE_EGL; \
	    $(call packaged,--cflags-only-I); } >$@
$(BUILD)/stage.libraries: | need-figures $(BUILD)
	@{ $(call packaged,--libs); } >$@

# One figure is of what the library is timed against.
$(BUILD)/drawing/expansion_terms.o: COMPILE += -Itests

# A program that was built anew and is the same draws nothing anew.
$(BUILD)/drawing/program: $(drawing)
	@cmp -s $< $@ || cp $< $@

picture = @echo 'draw    $@' && mkdir -p $(@D) && \
	$< figure $* --theme $(1) --output $@ >/dev/null
$(BUILD)/figures/%-light.png: $(BUILD)/drawing/program
	$(call picture,light)
$(BUILD)/figures/%-dark.png: $(BUILD)/drawing/program
	$(call picture,dark)

# The tests of all this.
FIGURE_TESTS := $(wildcard $(addprefix tests/,stage/*.c draw/*.c figures/*.c))
figure_tests = $(FIGURE_TESTS:%.c=$(BUILD)/%)

$(figure_tests:=.o): $(BUILD)/stage.flags
$(figure_tests:=.o): USES = -Ifigures @$(BUILD)/stage.flags
$(figure_tests): $(BUILD)/%: $(BUILD)/%.o $(BUILD)/support.a $(archives)
	@echo 'link    $@'
	$(Q)$(LINK) $^ @$(BUILD)/stage.libraries $$(pkg-config --libs check) \
	    -lgmp -lm -o $@
