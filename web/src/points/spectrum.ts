// SPDX-License-Identifier: Apache-2.0
//
// The power spectrum of points in the unit square, P(k) = |sum of exp(-2 pi i k.x)|^2 / N: 1 on
// average for independent points, and for k = 0 it is N. Points are spread over a grid by bilinear
// weights, which are then divided out; the grid is 4 times as fine as the highest frequency needs, so
// that what is left of the error stays below 3 % of power 1 (Hockney and Eastwood 1988, chapter 5).

import FFT from "fft.js";

/** Power for frequencies [-reach, reach] in both directions, row by row from the lowest. */
export interface Spectrum {
    reach: number;
    power: Float32Array;
}

/** The highest frequency that is worth showing: twice that of a regular grid of `count` points. */
export function spectrumReach(count: number): number {
    return Math.max(16, 2 ** Math.ceil(Math.log2(2 * Math.sqrt(count))));
}

const transforms = new Map<number, FFT>();
function transformOf(size: number): FFT {
    const known = transforms.get(size);
    if (known) return known;
    const made = new FFT(size);
    transforms.set(size, made);
    return made;
}

/** The points on a torus of size times size cells, each shared by the four next to it. */
function spread(u: Float32Array, v: Float32Array, size: number): Float32Array {
    const grid = new Float32Array(size * size);
    const last = size - 1;
    for (let i = 0; i < u.length; ++i) {
        const x = u[i]! * size;
        const y = v[i]! * size;
        const column = Math.floor(x);
        const row = Math.floor(y);
        const right = x - column;
        const below = y - row;
        const next = (column + 1) & last;
        const here = row * size;
        const there = ((row + 1) & last) * size;
        grid[here + column]! += (1 - right) * (1 - below);
        grid[here + next]! += right * (1 - below);
        grid[there + column]! += (1 - right) * below;
        grid[there + next]! += right * below;
    }
    return grid;
}

/** What bilinear weights leave of the power at frequencies [0, reach]. */
function keptPower(reach: number, size: number): Float64Array {
    return Float64Array.from({length: reach + 1}, (_, k) => {
        const angle = (Math.PI * k) / size;
        return k === 0 ? 1 : (Math.sin(angle) / angle) ** 4;
    });
}

export function spectrumOf(u: Float32Array, v: Float32Array): Spectrum {
    const reach = spectrumReach(u.length);
    const size = 4 * reach;
    const fft = transformOf(size);
    const grid = spread(u, v, size);
    const row = new Array<number>(2 * size).fill(0);
    const columns = Array.from({length: reach + 1}, () => new Array<number>(2 * size).fill(0));
    for (let y = 0; y < size; ++y) {
        fft.realTransform(row, grid.subarray(y * size, (y + 1) * size));
        for (let k = 0; k <= reach; ++k) {
            columns[k]![2 * y] = row[2 * k]!;
            columns[k]![2 * y + 1] = row[2 * k + 1]!;
        }
    }
    const kept = keptPower(reach, size);
    const width = 2 * reach + 1;
    const power = new Float32Array(width * width);
    columns.forEach((column, kx) => {
        fft.transform(row, column);
        for (let ky = -reach; ky <= reach; ++ky) {
            const at = 2 * ((ky + size) % size);
            const square = row[at]! ** 2 + row[at + 1]! ** 2;
            const value = square / (u.length * kept[kx]! * kept[Math.abs(ky)]!);
            power[(ky + reach) * width + kx + reach] = value;
            power[(reach - ky) * width + reach - kx] = value;
        }
    });
    return {reach, power};
}

/** The mean power of frequencies whose length rounds to 1, 2, ..., reach. */
export function radialMean({reach, power}: Spectrum): Float64Array {
    const sums = new Float64Array(reach + 1);
    const counts = new Float64Array(reach + 1);
    for (let ky = -reach, at = 0; ky <= reach; ++ky) {
        for (let kx = -reach; kx <= reach; ++kx, ++at) {
            const radius = Math.round(Math.hypot(kx, ky));
            if (radius > reach) continue;
            sums[radius]! += power[at]!;
            counts[radius]! += 1;
        }
    }
    return sums.subarray(1).map((sum, i) => sum / counts[i + 1]!);
}
