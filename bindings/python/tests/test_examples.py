# SPDX-License-Identifier: Apache-2.0
"""The examples run, and show what they say."""

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


def test_all_have_help():
    for path in sorted(FOLDER.glob("*.py")):
        done = subprocess.run([sys.executable, path, "--help"], capture_output=True, text=True,
                              check=True)
        assert "usage:" in done.stdout
