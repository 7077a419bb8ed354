# SPDX-License-Identifier: Apache-2.0
"""The sessions in the documents give what they show."""

import doctest
import pathlib
import re

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("name", ("README.md", "bindings/python/README.md", "docs/python.md"))
def test_sessions(name):
    """All blocks of a document are one session."""
    text = (ROOT / name).read_text()
    blocks = [match for match in BLOCK.finditer(text) if ">>>" in match[1]]
    assert blocks
    parser, runner, names, said = doctest.DocTestParser(), doctest.DocTestRunner(), {}, []
    for block in blocks:
        line = text.count("\n", 0, block.start()) + 1
        test = parser.get_doctest(block[1], names, name, name, line)
        test.globs = names
        runner.run(test, out=said.append, clear_globs=False)
    assert runner.failures == 0, "".join(said)
