// SPDX-License-Identifier: Apache-2.0
//
// Pictures of size times size pixels of four numbers each, as renderers give them.

/** Red, green and blue in 8 bits by IEC 61966-2-1 (sRGB), of sums over `count` samples. */
export function encode(sums: Float32Array, count: number): Uint8ClampedArray<ArrayBuffer> {
    const pixels = new Uint8ClampedArray(sums.length);
    for (let i = 0; i < sums.length; ++i) {
        const linear = Math.min(Math.max(sums[i]! / count, 0), 1);
        const curve = linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
        pixels[i] = i % 4 === 3 ? 255 : 255 * curve;
    }
    return pixels;
}

/** What a Gaussian of `sigma` pixels has within 3 sigma: weights for -3 sigma to 3 sigma. */
function gaussian(sigma: number): Float64Array {
    const reach = 3 * sigma;
    const weights = Float64Array.from({length: 2 * reach + 1}, (_, i) =>
        Math.exp(-((i - reach) ** 2) / (2 * sigma * sigma)),
    );
    const sum = weights.reduce((a, b) => a + b);
    return weights.map(weight => weight / sum);
}

/** Filtered along rows, and transposed. Pixels beside the picture are those of its border. */
function filterRows(picture: Float32Array, size: number, weights: Float64Array): Float32Array {
    const result = new Float32Array(picture.length);
    const reach = (weights.length - 1) / 2;
    for (let y = 0; y < size; ++y) {
        for (let x = 0; x < size; ++x) {
            let red = 0;
            let green = 0;
            let blue = 0;
            for (let i = 0; i < weights.length; ++i) {
                const other = Math.min(Math.max(x + i - reach, 0), size - 1);
                const at = 4 * (y * size + other);
                const weight = weights[i]!;
                red += weight * picture[at]!;
                green += weight * picture[at + 1]!;
                blue += weight * picture[at + 2]!;
            }
            const to = 4 * (x * size + y);
            result[to] = red;
            result[to + 1] = green;
            result[to + 2] = blue;
        }
    }
    return result;
}

/** The picture after a Gaussian of `sigma` pixels, a whole number. */
export function filtered(picture: Float32Array, size: number, sigma: number): Float32Array {
    const weights = gaussian(sigma);
    return filterRows(filterRows(picture, size, weights), size, weights);
}

/**
 * The root of the mean square difference of picture / count and reference / referenceCount, over the
 * three colors of all pixels but those `border` pixels from the edge.
 */
export function rootMeanSquare(
    picture: Float32Array,
    count: number,
    reference: Float32Array,
    referenceCount: number,
    size: number,
    border: number,
): number {
    let sum = 0;
    for (let y = border; y < size - border; ++y) {
        for (let x = border; x < size - border; ++x) {
            const at = 4 * (y * size + x);
            for (let c = at; c < at + 3; ++c) {
                sum += (picture[c]! / count - reference[c]! / referenceCount) ** 2;
            }
        }
    }
    return Math.sqrt(sum / (3 * (size - 2 * border) ** 2));
}
