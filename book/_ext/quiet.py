"""Colours of code in print; the pages' own are in _theme/static/book.css."""
from pygments.style import Style
from pygments.token import (Comment, Generic, Keyword, Literal, Name, Number,
                            String)


class Quiet(Style):
    styles = {
        Comment: "#6a6f78", Comment.Preproc: "#7a4b8c",
        Keyword: "#1d5c8f", Keyword.Type: "#1d5c8f",
        Name.Function: "#20242a", String: "#8a5a14", Number: "#8a5a14",
        Literal: "#8a5a14", Generic.Prompt: "#6a6f78",
        Generic.Output: "#4a4f57",
    }
