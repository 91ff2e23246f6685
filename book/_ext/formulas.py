r"""ASCII as formulas: `0 <= t <= 1` of a comment is $0 \le t \le 1$ in print.

    formulas.from_ascii("the edge e0 e1 at t = 0, below 2^(word - 1)")

A formula is a letter, a power, or a chain of operators with blanks around them;
names of the program become code.
"""
import re

NUMBER = r"\d+(?:\.\d+)?"
POWER = rf"{NUMBER}\^(?:-?\w+|\([^)]*\))"
CODE = r"[a-z]\w*\[[^]]*\]|\b(?:tf|TF)_\w+|\b[a-z]\w*_\w+"
OPERATOR = r"(?:[<>]=?|[-=+*/]|x(?= n\b))"
TERM = (rf"(?:{NUMBER} [a-z] (?=\())?[(|]*-?(?:{POWER}|{NUMBER}(?: [b-z]\b)?"
        r"|[A-Za-z]\w*'?)[)|]*")
CHAIN = rf"{TERM}(?: {OPERATOR} {TERM})+"
# The letter a is an article before most words.
LETTER = (r"(?<![\w'.-])(?:[b-zB-HJ-Z]\d?'?|(?<=than )a|a(?=[,;:)]|\.\s|\.$"
          r"|\s(?:to|and|or)\b)|[ace]\d'?)(?![\w'])")
FOUND = re.compile(
    rf"(?P<kept>`[^`]*`|\$[^$]*\$)|(?P<code>(?:{CODE})(?: [-+] "
    rf"(?:{CODE}|\.\.\.))*)|(?P<chain>(?<![\w`]){CHAIN})"
    rf"|(?P<power>(?<!\w)[a-z]\d [a-z]\d(?![\w'])|\|\w\|(?!\w)"
    rf"|(?<!\w){POWER}|(?<![\w)])-{NUMBER})"
    rf"|(?P<letter>{LETTER})")


def tex(text):
    """A formula as LaTeX."""
    text = re.sub(r"\^\(([^)]*)\)|\^(-?\w+)",
                  lambda e: "^{%s}" % (e[1] or e[2]), text)
    text = re.sub(r"\b([A-Za-z])(\d)\b", r"\1_\2", text)
    text = re.sub(r"(?<![\\\w])[A-Za-z]{2,}", r"\\mathtt{\g<0>}", text)
    for written, meant in (("<=", r"\\le"), (">=", r"\\ge"), (r"\*", r"\\cdot"),
                           (r"\bn x n\b", r"n \\times n")):
        text = re.sub(written, meant, text)
    return f"${text}$"


def balanced(text):
    """A formula without brackets that open or close in the text around it, and
    these."""
    opened = closed = ""
    while text[0] == "(" and text.count("(") > text.count(")"):
        opened, text = opened + text[0], text[1:]
    while text[-1] == ")" and text.count(")") > text.count("("):
        closed, text = closed + text[-1], text[:-1]
    return opened, text, closed


def replaced(found):
    if found["kept"]:
        return found[0]
    if found["code"]:
        return f"`{found[0]}`"
    opened, text, closed = balanced(" ".join(found[0].split()))
    return opened + tex(text) + closed


def from_ascii(text):
    """A paragraph with its formulas set; what is indented is code already."""
    if text.startswith("    "):
        return text
    return FOUND.sub(replaced, " ".join(text.split()))
