"""Where the fragments and exercises of the book are shown.

    {frag}`Title`   a link to the fragment of that title, with its number
    {ex}`03-1`      "Exercise 3.1", a link
"""
import functools

from docutils import nodes
from sphinx.domains import Domain
from sphinx.domains.std import StandardDomain
from sphinx.roles import XRefRole
from sphinx.util import logging
from sphinx.util.nodes import make_refnode

logger = logging.getLogger(__name__)


class PlaceRole(XRefRole):
    def process_link(self, env, refnode, has_explicit_title, title, target):
        refnode["refdomain"] = "book"
        refnode["reftype"] = self.reftype
        return title, " ".join(target.split())


class FragmentRole(PlaceRole):
    reftype = "frag"


class ExerciseRole(PlaceRole):
    reftype = "ex"


class BookDomain(Domain):
    """Places by kind and key: a list of (page, anchor, name), one normally."""
    name, label = "book", "Book"
    initial_data = {"places": {}}

    def note(self, kind, key, anchor, name):
        self.data["places"].setdefault((kind, key), []).append(
            (self.env.docname, anchor, name))

    def places(self, kind, key):
        return self.data["places"].get((kind, key), [])

    def keys(self, kind):
        return [key for of_kind, key in self.data["places"] if of_kind == kind]

    def clear_doc(self, docname):
        places = self.data["places"]
        for key in list(places):
            places[key] = [p for p in places[key] if p[0] != docname]
            if not places[key]:
                del places[key]

    def resolve_xref(self, env, fromdocname, builder, typ, target, node,
                     contnode):
        for docname, anchor, name in self.places(typ, target):
            words = nodes.inline("", name, classes=[typ])
            return make_refnode(builder, fromdocname, docname, anchor, words)
        return None

    def resolve_any_xref(self, *args):
        return []


# Numbers ----------------------------------------------------------------------

class Pages:
    """The environment, but pages stay in memory once they are read."""

    def __init__(self, env):
        self.env = env
        self.get_doctree = functools.cache(env.get_doctree)

    def __getattr__(self, name):
        return getattr(self.env, name)


class Standard(StandardDomain):
    """Sphinx's own would read a page for every {numref} to it, and would not
    mind if that has no number."""

    @functools.cached_property
    def pages(self):
        return Pages(self.env)

    def resolve_xref(self, env, page, builder, kind, target, node, words):
        link = super().resolve_xref(self.pages, page, builder, kind, target,
                                    node, words)
        if kind == "numref" and link is words:
            logger.warning("'%s' has no number", target, location=node)
        return link


def of(env):
    return env.get_domain(BookDomain.name)


def setup(app):
    app.add_domain(BookDomain)
    app.add_domain(Standard, override=True)
    app.add_role("frag", FragmentRole(warn_dangling=True))
    app.add_role("ex", ExerciseRole(warn_dangling=True))
    return {"version": "1", "parallel_read_safe": False}
