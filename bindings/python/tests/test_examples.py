# SPDX-License-Identifier: Apache-2.0
"""The examples run, and show what they say."""

import json
import os
import pathlib
import subprocess
import sys

import pytest

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "examples" / "python"


def table(name, *options):
    """What an example prints, without the head: rows of a name and numbers."""
    done = subprocess.run([sys.executable, FOLDER / f"{name}.py", *map(str, options)],
                          capture_output=True, text=True, check=True)
    assert done.stderr == ""
    rows = [line.split() for line in done.stdout.splitlines()[1:]]
    return {first: [float(number) for number in numbers] for first, *numbers in rows}


def test_own_generator():
    rows = table("own_generator", "--seeds", 50, "--log-samples", 10)
    assert list(rows) == ["4", "16", "64", "256", "1024"]
    random, own, pmj, owen_sobol = rows["1024"]
    assert max(own, pmj, owen_sobol) < 0.25 * random


def test_blue_noise(tmp_path):
    pytest.importorskip("PIL")
    rows = table("blue_noise", "--size", 128, "--output", tmp_path / "errors.png")
    (pmj, pmj_filtered), (blue, blue_filtered) = rows["pmj"], rows["blue"]
    assert blue_filtered < 0.4 * pmj_filtered
    assert abs(blue / pmj - 1) < 0.1
    assert (tmp_path / "errors.png").read_bytes().startswith(b"\x89PNG")


def test_lens_and_light():
    rows = table("lens_and_light", "--pixels", 400)
    apart, together, ratio = rows["256"]
    assert together < 0.7 * apart
    assert abs(ratio - together / apart) < 0.01


def test_look_at_points(tmp_path):
    pytest.importorskip("matplotlib")
    subprocess.run([sys.executable, FOLDER / "look_at_points.py", "--output", tmp_path / "look.png"],
                   check=True)
    assert (tmp_path / "look.png").read_bytes().startswith(b"\x89PNG")


def test_notebook(tmp_path):
    """It is kept without results, and all of its cells run."""
    notebook = FOLDER / "your_points.ipynb"
    kept = [cell for cell in json.loads(notebook.read_text())["cells"] if cell["cell_type"] == "code"]
    assert not any(cell["outputs"] for cell in kept)

    pytest.importorskip("nbconvert")
    kernel = tmp_path / "kernels" / "python3"  # this interpreter, whatever others are installed
    kernel.mkdir(parents=True)
    (kernel / "kernel.json").write_text(json.dumps({
        "argv": [sys.executable, "-m", "ipykernel_launcher", "-f", "{connection_file}"],
        "display_name": "Python 3", "language": "python"}))
    subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", notebook,
                    "--output-dir", tmp_path], check=True, capture_output=True,
                   env={**os.environ, "JUPYTER_PATH": str(tmp_path)})
    cells = [cell for cell in json.loads((tmp_path / notebook.name).read_text())["cells"]
             if cell["cell_type"] == "code"]
    printed = "".join("".join(output.get("text", ())) for cell in cells for output in cell["outputs"])
    assert "pmj: t = 0" in printed
    pictures = sum("image/png" in output.get("data", ()) for cell in cells for output in cell["outputs"])
    assert pictures == 7


def test_all_have_help():
    for path in sorted(FOLDER.glob("*.py")):
        done = subprocess.run([sys.executable, path, "--help"], capture_output=True, text=True,
                              check=True)
        assert "usage:" in done.stdout
