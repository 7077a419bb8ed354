# SPDX-License-Identifier: Apache-2.0
"""Documents that say what was measured: runs the commands that they name and writes their tables and
pictures anew. All between <!-- measured: NAME --> and <!-- end --> is written here.

What scripts/docs-blue, docs-joint, docs-performance, docs-quality and docs-rendering share."""

import argparse
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs" / "images"


class Lab:
    """Runs commands in a folder of its own and remembers how to type them."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = pathlib.Path(folder)
        self.commands = []

    def run(self, name, *arguments):
        """What `wellstrat` or a script of the project prints."""
        self.commands.append(shlex.join([name, *arguments]))
        if name == "wellstrat" and not self.program.is_file():
            sys.exit(f"there is no program {self.program}; build first, or set BUILD_DIR")
        path = self.program if name == "wellstrat" else ROOT / name
        done = subprocess.run([path, *arguments], cwd=self.folder, stdout=subprocess.PIPE, text=True)
        if done.returncode != 0:
            sys.exit(f"failed: {self.commands[-1]}")
        return done.stdout


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def note(text):
    return "\n" + textwrap.fill(text, 100, break_long_words=False) + "\n"


def write(document, parts, lab_class, description, examples):
    """The command line of a script: writes the parts of docs/`document` that are asked for. `parts`
    are functions by name; each gets a `lab_class`, and returns what stands above its commands.
    Pictures that it leaves in its folder as PNG files, named like the document, go to the docs."""
    parser = argparse.ArgumentParser(description=description, epilog=examples,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", metavar="PART", nargs="*", help=f"{', '.join(parts)}; default: all")
    chosen = parser.parse_args().parts or list(parts)
    unknown = [part for part in chosen if part not in parts]
    if unknown:
        parser.error(f"no part is called '{unknown[0]}'; there are {', '.join(parts)}")
    program = (ROOT / os.environ.get("BUILD_DIR", "build/release") / "bin" / "wellstrat").resolve()

    path = ROOT / "docs" / document
    for part in chosen:
        result = measured(parts[part], lab_class, program, path.stem)
        block = re.compile(f"(<!-- measured: {part} -->\n).*?(<!-- end -->)", re.DOTALL)
        text, found = block.subn(lambda match: f"{match[1]}\n{result}\n{match[2]}", path.read_text())
        if found != 1:
            sys.exit(f"{path} has no single '<!-- measured: {part} -->'")
        path.write_text(text)
        print(f"{part}: done", flush=True)


def measured(part, lab_class, program, prefix):
    """The result of a part and, folded away, its commands, as Markdown; its pictures are copied."""
    with tempfile.TemporaryDirectory() as folder:
        lab = lab_class(program, folder)
        result = part(lab)
        commands = "".join(f"    {command}\n" for command in lab.commands)
        how = f"<details><summary>How it was measured</summary>\n\n{commands}\n</details>\n"
        for picture in sorted(lab.folder.glob(f"{prefix}-*.png")):
            shutil.copy(picture, IMAGES)
    return f"{result}\n{how}" if result else how
