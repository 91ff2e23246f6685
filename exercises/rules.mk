# The exercises.  A student's files are in $(WORK), which no target removes.
WORK = work

##@ Start here

learn: ## work on the next exercise, or on N=1.2; WATCH=1 goes on

##@ Exercises

ready: ## build what learn and grade need
hint: ## show one more hint for the current exercise, or for N=1.2
list: ## list the exercises and your progress
reset: ## start exercise N=1.2 over, and keep your file as a backup
solution: ## show the solution of N=1.2; SURE=1 if not solved yet
##@ A course

grade: ## grade your files, or those in DIR=; only N='1 2.3'
grade-all: ## grade the folders and zip files in DIR=submissions
gradescope: ## make an autograder for Gradescope, of all or N='1 2.3'
handout: ## make an edition of the exercises without solutions

##@ Check

check-exercises: check-format-exercises ## check all exercises, or N=1.2, in all variants

trying = ready learn grade grade-all check-exercises
reading = hint list reset solution gradescope handout
.PHONY: $(trying) $(reading) check-format-exercises format-exercises

# The stubs do not use their parameters yet.
exercise_compile = $(CC) $(WARNINGS) -Wno-unused-parameter -Wfatal-errors \
	-O1 -g $(sanitizers) -std=c17 -ffp-contract=off -Isrc -Ifigures

# What the checks are made of, which answers are not linked to, and what both
# use: the library and the arithmetic of a figure.
harness = $(patsubst %,$(BUILD)/exercises/%.o,check judge confine) \
	$(BUILD)/support.a
exercise_library = $(BUILD)/drawing/kit/expansion.o $(library_file)

$(trying) $(reading): export WORK := $(WORK)
$(trying) $(reading): export BUILD := $(BUILD)
$(trying) $(reading): learn_py = COMPILE="$(exercise_compile)" \
	HARNESS="$(harness)" LINK="$(exercise_library) \
	$$(pkg-config --libs check 2>/dev/null) -lgmp -lm" \
	PYTHONDONTWRITEBYTECODE=1 python3
$(trying): need-exercises $(harness) $(exercise_library)
$(reading): need-reading

$(filter-out ready check-exercises,$(trying)) $(reading):
	@$(learn_py) exercises/learn.py $@ --number='$(N)' --dir='$(DIR)' \
	    --weights='$(WEIGHTS)' --watch='$(WATCH)' --sure='$(SURE)'

check-exercises:
	@$(learn_py) exercises/learn.py check --number='$(N)'
	@$(learn_py) tests/exercises/rows_test.py
	@$(learn_py) tests/exercises/learn_test.py
	@$(learn_py) tests/exercises/forgery_test.py
	@$(learn_py) tests/exercises/course_test.py

$(BUILD)/exercises/%.o: exercises/%.c $(wildcard exercises/*.h) | need-exercises
	@echo 'compile $<' && mkdir -p $(@D)
	$(Q)$(exercise_compile) -Itests $$(pkg-config --cflags check) -c $< -o $@

exercise_code = $(wildcard exercises/*.[ch])
check-format: check-format-exercises
check-format-exercises: need-format
	@clang-format --dry-run -Werror $(exercise_code)
format: format-exercises
format-exercises: need-format
	@clang-format -i $(exercise_code)
