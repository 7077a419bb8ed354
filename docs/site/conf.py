# SPDX-License-Identifier: Apache-2.0
"""Sphinx's settings of the site, which scripts/docs builds from copies of the documents."""

import os

from pygments.lexers import CLexer, CppLexer, RustLexer

project = "wellstrat"
author = copyright = "The wellstrat authors"
release = version = os.environ["WELLSTRAT_VERSION"]

extensions = ["breathe", "myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
root_doc = "index"

myst_heading_anchors = 4
breathe_projects = {"wellstrat": os.environ["WELLSTRAT_DOXYGEN_XML"]}
breathe_default_project = "wellstrat"
breathe_default_members = ("members",)
breathe_show_include = False
breathe_domain_by_extension = {"h": "cpp"}
breathe_domain_by_file_pattern = {"*/c.h": "c"}
# `typedef struct name {...} name;` declares a name twice, as one does in C.
suppress_warnings = ["duplicate_declaration.c"]

autodoc_member_order = "groupwise"
autodoc_typehints = "none"  # the docstrings have the types

html_theme = "furo"
html_title = f"wellstrat {release}"
html_copy_source = False


def setup(app):
    """Shading languages that Pygments does not know look like those that it does."""
    for name, lexer in (("metal", CppLexer), ("opencl", CLexer), ("wgsl", RustLexer)):
        app.add_lexer(name, lexer)
