# The exercises.  A student's files are in $(WORK), which no target removes.
WORK = work

learn: ## work on the next exercise, or on N=1.2
hint: ## show one more hint for the current exercise, or for N=1.2
list: ## list the exercises and your progress
reset: ## start exercise N=1.2 over; your file is kept as a backup
solution: ## show the solution of N=1.2; SURE=1 if not solved yet
grade: ## grade your files, or those in DIR=; only chapter N=1 or exercise N=1.2
check-exercises: check-format-exercises ## check all variants of all exercises

exercise_commands = learn hint list reset solution grade
exercise_targets = $(exercise_commands) check-exercises
.PHONY: $(exercise_targets) check-format-exercises format-exercises
.PHONY: test-exercises

# The stubs do not use their parameters yet.
exercise_compile = $(CC) $(WARNINGS) -Wno-unused-parameter -Wfatal-errors \
	-O1 -g $(sanitizers) -std=c17 -ffp-contract=off -Isrc -Itests -Ifigures \
	$$(pkg-config --cflags check)
exercise_archives = $(BUILD)/exercises/check.o $(BUILD)/support.a \
	$(library_file)

$(exercise_targets): need-exercises
learn grade check-exercises: $(exercise_archives)
$(exercise_targets): export WORK := $(WORK)
$(exercise_targets): export BUILD := $(BUILD)
$(exercise_targets): learn_py = COMPILE="$(exercise_compile)" \
	LINK="$(exercise_archives) $$(pkg-config --libs check) -lgmp -lm" \
	PYTHONDONTWRITEBYTECODE=1 python3

$(exercise_commands):
	@$(learn_py) exercises/learn.py $@ --number='$(N)' --dir='$(DIR)' \
	    --sure='$(SURE)'

check-exercises:
	@$(learn_py) exercises/learn.py check
	@$(learn_py) tests/exercises/learn_test.py

$(BUILD)/exercises/check.o: exercises/check.c exercises/check.h | need-exercises
	@echo 'compile $<' && mkdir -p $(@D)
	$(Q)$(exercise_compile) -c $< -o $@

exercise_code = $(wildcard exercises/*.[ch])
check-format: check-format-exercises
check-format-exercises: need-format
	@clang-format --dry-run -Werror $(exercise_code)
format: format-exercises
format-exercises: need-format
	@clang-format -i $(exercise_code)
