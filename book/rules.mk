# The book: HTML in $(BUILD)/book/html, print in $(BUILD)/book/tanglefree.pdf.
# The chapters' text is here, a file a chapter; all that they show of the
# program, its output and its figures is taken from where it is made.  So is
# the reference, which Doxygen extracts from the comments of the public header.

BOOK := $(wildcard book/*.md book/*.c book/*.py book/*.bib book/chapters \
	book/_ext/*.py book/_print/* book/_theme/* book/_theme/static/* \
	figures/measured/*.csv src/package/manual/*.5) \
	$(shell find src -name '*.[ch]')
reference = $(BUILD)/reference/xml/index.xml
prints = $(figure_names:%=$(BUILD)/figures/%-light.pdf)
# Debian's own Python has Sphinx and Selenium.
python = /usr/bin/python3
weave = BUILD=$(abspath $(BUILD)) sphinx-build -q

##@ Start here

book: $(BUILD)/book/html/index.html ## build the book as web pages, in build/book/html
##@ Book and figures

pdf: $(BUILD)/book/tanglefree.pdf ## build the book as a PDF, in build/book
slides: $(BUILD)/slides/index.html ## make slides for lectures, in build/slides
.PHONY: book pdf slides

$(reference): $(public_header) $(threads_header) book/Doxyfile | need-book
	@echo 'extract $(@D)'
	$(Q)rm -rf $(BUILD)/reference && mkdir $(BUILD)/reference
	$(Q)BUILD=$(BUILD) doxygen book/Doxyfile

# All is read anew, so that the file of warnings has those of every page.
warnings = $(BUILD)/book/warnings.txt
$(BUILD)/book/html/index.html: $(BOOK) $(program_file) $(pictures) $(films) \
		$(reference) | need-book
	@echo 'weave   $(@D)'
	$(Q)rm -rf $(@D) && mkdir -p $(@D) && \
	    $(weave) -E -w $(warnings) -b html \
	    -d $(BUILD)/book/read book $(@D) && touch $@

$(BUILD)/figures/%-light.pdf: $(BUILD)/drawing/program
	$(call picture,light)

$(BUILD)/book/tanglefree.pdf: $(BOOK) $(program_file) $(prints) $(films) \
		$(reference) | need-book need-pdf
	@echo 'print   $@'
	$(Q)$(weave) -b latex -d $(BUILD)/book/read-latex book $(@D)/latex
	$(Q)cd $(@D)/latex && latexmk -g -xelatex -interaction=nonstopmode \
	    -halt-on-error tanglefree.tex >print.txt 2>&1 || \
	    { grep -A 5 '^!' tanglefree.log; false; }
	$(Q)cp $(@D)/latex/tanglefree.pdf $@

# A deck for each part of the book, from the chapters that its pages are made of.
$(BUILD)/slides/index.html: $(BUILD)/book/html/index.html | need-slides
	@echo 'weave   $(@D)'
	$(Q)$(weave) -b slides -d $(BUILD)/book/read book $(@D)
	@echo 'print   $(@D)'
	$(Q)BUILD=$(BUILD) sh book/print-slides.sh && touch $@

##@ Check

# Warnings are errors; then the pages are taken apart again, and what they show
# of src/ must be src/.
check-book: book check-readme ## check the book against code, figures and programs
	@cat $(warnings) && [ ! -s $(warnings) ]
	@$(python) tests/book/fragments_test.py
	@$(python) tests/book/weave_test.py
	@$(python) tests/book/pages_test.py $(BUILD)/book/html
	@$(python) tests/book/reference_test.py $(BUILD)/book/html \
	    $(public_header) $(threads_header)

check-slides: slides need-site ## check the slides in a browser
	@$(python) tests/site/slides.py $(BUILD)/slides

check-site: book need-site ## check the pages in a browser
	@$(python) tests/site/browse.py $(BUILD)/book/html
.PHONY: check-book check-slides check-site
