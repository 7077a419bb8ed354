# SPDX-License-Identifier: Apache-2.0
"""Two domains of a path, stratified together: a pixel that is out of focus under a square light.

A pixel's value is an integral over the lens and over the light, in four dimensions. Domains that are
derived one by one are each stratified; slots are stratified together as well. Prints the error of both
over many pixels.
"""

import argparse

import numpy as np

import wellstrat


def estimate(pixels, slots):
    """The value of each pixel from all of its samples: those along the last axis."""
    scrambles = [wellstrat.joint_scramble(k) for k in (0, 1)] if slots else [0x85A308D3, 0x91E4C05A]
    lens, light = (wellstrat.draw(wellstrat.new_domain(pixels, scramble), slot=k if slots else None)
                   for k, scramble in enumerate(scrambles))
    point = wellstrat.warp.square_to_disk_concentric(lens)  # what this part of the lens sees
    distance2 = ((point - 3 * light) ** 2).sum(axis=-1) + 1
    return (1 / distance2**2).mean(axis=-1)  # both cosines, over the squared distance


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--pixels", type=int, default=1000)
    options = parser.parse_args()

    def pixels(samples):
        patterns = wellstrat.camera_contexts(options.pixels, 1)["patternid"].T
        return wellstrat.contexts(patterns, range(samples))

    truth = estimate(pixels(4096), slots=True).mean()
    print("samples   domains     slots   ratio")
    for samples in (4, 16, 64, 256, 1024):
        apart, together = (np.sqrt(np.mean((estimate(pixels(samples), slots) - truth) ** 2))
                           for slots in (False, True))
        print(f"{samples:7}{apart:10.5f}{together:10.5f}{together / apart:8.2f}")


if __name__ == "__main__":
    main()
