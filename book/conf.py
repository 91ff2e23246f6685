"""The settings of the book; book/_ext has its own directives and roles."""
import os
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent / "_ext"))
import mathml

# Everything that is built is in one folder.
built = Path(os.environ.get("BUILD", "build")).resolve()

project = "Tanglefree"
html_title = "Tanglefree"
author = "The Tanglefree authors"
copyright = "the Tanglefree authors"
version = release = ""
language = "en"
root_doc = "index"
templates_path = []
exclude_patterns = ["_*", "chapters"]
nitpicky = True
# Names of the library have an entry in the reference; others need none.
nitpick_ignore_regex = [("c:.*", "(?!tf_|TF_).*")]

extensions = ["myst_parser", "sphinxcontrib.bibtex", "mathml", "places",
              "manifest", "weave", "sessions", "drawings", "measured", "blocks",
              "pages", "reference", "manual", "slides"]

myst_enable_extensions = ["dollarmath", "amsmath", "colon_fence", "deflist",
                          "smartquotes"]
myst_footnote_transition = False
myst_dmath_double_inline = True
suppress_warnings = ["myst.header"]

bibtex_bibfiles = ["references.bib"]
bibtex_reference_style = "label"

breathe_projects = {"tanglefree": str(built / "reference/xml")}
breathe_default_project = "tanglefree"
breathe_domain_by_extension = {"h": "c"}
breathe_show_include = False
toc_object_entries = False

numfig = True
numfig_secnum_depth = 1
math_breathe_domain_by_extension = {"h": "c"}
breathe_show_include = False
toc_object_entries = False

numfig = True
numfig_format = {
    "figure": "Figure\u00a0%s", "table": "Table\u00a0%s",
    "code-block": "Listing\u00a0%s", "section": "Section\u00a0%s",
    **{kind: kind.capitalize() + "\u00a0%s" for kind in (
        "theorem", "lemma", "corollary", "proposition", "definition",
        "algorithm", "example", "remark", "problem")}}


def setup(app):
    app.built = built


html_theme = "_theme"
html_theme_path = ["."]
html_show_search_summary = False
html_copy_source = False
html_secnumber_suffix = "\u2002"
html_permalinks = False
html_domain_indices = False
pygments_style = "quiet.Quiet"


def font(pattern):
    """The file of an installed font."""
    return subprocess.run(["fc-match", "-f", "%{file}", pattern], check=True,
                          capture_output=True, text=True).stdout


html_static_path = [font(pattern) for pattern in (
    "TeXGyrePagella:regular", "TeXGyrePagella:italic:regular",
    "TeXGyrePagella:bold", "TeXGyrePagella:italic:bold",
    "TeXGyrePagellaMath", "Inconsolata")]

latex_engine = "xelatex"
latex_documents = [("index", "tanglefree.tex", "Tanglefree", author, "manual",
                    True)]
latex_docclass = {"manual": "book"}
latex_show_pagerefs = False
latex_use_xindy = False
latex_table_style = ["booktabs"]
latex_additional_files = ["_print/tanglefree.sty",
                          str(built / "figures/cover-light.pdf")]
latex_elements = {
    "pointsize": "10pt", "extraclassoptions": "oneside,openany",
    "passoptionstopackages": r"\PassOptionsToClass{oneside}{book}",
    "fontpkg": r"\usepackage{unicode-math}",
    "fncychap": "", "fvset": r"\fvset{xleftmargin=3mm}", "figure_align": "htbp",
    "maketitle": r"\tftitle",
    "tableofcontents": r"{\hypersetup{linkcolor=ink}\tableofcontents}"
    r"\clearpage",
    "sphinxsetup": "VerbatimColor={RGB}{255,255,255},"
    "VerbatimBorderColor={RGB}{208,204,192},pre_border-width=0pt,"
    "pre_border-left-width=0.8pt,pre_padding=1pt,pre_padding-left=-0.8pt,"
    "verbatimhintsturnover=false,"
    "InnerLinkColor={RGB}{26,92,148},OuterLinkColor={RGB}{26,92,148},"
    "TitleColor={RGB}{32,36,42}",
    "preamble": r"\usepackage{tanglefree}" "\n" + mathml.preamble()}
