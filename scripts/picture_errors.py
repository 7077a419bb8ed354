# SPDX-License-Identifier: Apache-2.0
"""The error of pictures by one generator over that of another, with its uncertainty: a part of
documents that say what generators are worth in the path tracer."""

import re

from measured_document import note, table

SCENES = ("cornell", "lens", "spherelight", "veach", "manylights")
DEPTHS = (0, 2, 5)
COUNTS = (1, 4, 16, 64, 256, 1024, 4096)
LINE = re.compile(r"^(\w+) +(\d+) +(\S+) +\S+ +(\S+) +\S+ +\S+ +(\S+) +(\S+)$", re.MULTILINE)


def errors(page):
    """What `compare --seeds` prints: (error, standard error) by generator, samples and kind, which
    is "plain" or "filtered"."""
    found = {}
    for generator, count, plain, filtered, plain_error, filtered_error in LINE.findall(page):
        found[generator, int(count), "plain"] = float(plain), float(plain_error)
        found[generator, int(count), "filtered"] = float(filtered), float(filtered_error)
    return found


def digits(value, error):
    """A value with its standard error in units of the last digit, such as "0.57(2)"."""
    return f"{value:.2f}({100 * error:.0f})"


def ratio(a, b):
    """a / b, of values with their standard errors."""
    quotient = a[0] / b[0]
    error = quotient * ((a[1] / a[0]) ** 2 + (b[1] / b[0]) ** 2) ** 0.5
    return digits(quotient, error)


def error_ratios(lab, generator, baseline="pmj", size="48x32", seeds=4, scenes=SCENES,
                 depths=DEPTHS, counts=COUNTS):
    """Runs the comparisons and returns their tables, as Markdown. Time goes with the pixels of
    `size` and with `seeds`. Few samples are cheap, and their errors come from few pixels, so they
    have eight times as many seeds."""
    rows = {"plain": [], "filtered": []}
    for scene in scenes:
        for depth in depths:
            measured = {}
            for some, their_seeds in (([n for n in counts if n <= 64], 8 * seeds),
                                      ([n for n in counts if n > 64], seeds)):
                measured |= errors(lab.run(
                    "wellstrat", "compare", scene, "--generators", f"{baseline},{generator}",
                    "--seeds", str(their_seeds), "--size", size, "--depth", str(depth), "--spp",
                    ",".join(map(str, some)), "-o", "page.html"))
            for kind, lines in rows.items():
                lines.append([f"`{scene}`", str(depth)]
                             + [ratio(measured[generator, n, kind], measured[baseline, n, kind])
                                for n in counts])
    head = ["scene", "depth"] + [f"{n} spp" for n in counts]
    return (table(head, rows["plain"])
            + note("The same after a Gaussian blur, as an eye at some distance or a denoiser sees it:")
            + "\n" + table(head, rows["filtered"]))
