# SPDX-License-Identifier: Apache-2.0
"""Blue noise of a picture: the same samples for each pixel, and less noise to the eye.

Renders a smooth picture, each pixel an integral over the unit square, with few samples by `pmj`,
whose pixels are independent, and by `blue`, whose pixels know of each other. Prints the error before
and after a Gaussian filter, which stands for an eye at a distance or for a denoiser.
"""

import argparse

import numpy as np
from scipy.ndimage import gaussian_filter

import wellstrat


def picture(generator, size, samples):
    """The estimates of all pixels: of a light that becomes wider from left to right."""
    contexts = wellstrat.blue_contexts if generator == "blue" else wellstrat.camera_contexts
    width = np.linspace(1, 3, size)
    total = np.zeros((size, size))
    for sampleid in range(samples):
        xy = wellstrat.draw(contexts(size, size, sampleid=sampleid), generator=generator)
        total += np.exp(-width * (xy**2).sum(axis=-1))
    return total / samples


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--size", type=int, default=256, help="pixels of each side, default 256")
    parser.add_argument("--samples", type=int, default=4, help="of each pixel, default 4")
    parser.add_argument("--output", metavar="FILE.png", help="the two pictures' errors side by side")
    options = parser.parse_args()

    truth = picture("pmj", options.size, 1024).mean(axis=0)
    errors = {name: picture(name, options.size, options.samples) - truth for name in ("pmj", "blue")}
    print("RMSE         a pixel   after a filter of 2 pixels")
    for name, error in errors.items():
        filtered = gaussian_filter(error, 2, mode="wrap")
        print(f"{name:<10}{error.std():10.5f}   {filtered.std():10.5f}")
    if options.output:
        from PIL import Image
        gray = np.hstack([127.5 + 300 * error for error in errors.values()])
        Image.fromarray(gray.clip(0, 255).astype(np.uint8)).save(options.output)


if __name__ == "__main__":
    main()
