// SPDX-License-Identifier: Apache-2.0

declare module "fft.js" {
    /** Discrete Fourier transforms of `size` complex numbers, a power of two, as (re, im) pairs. */
    export default class FFT {
        constructor(size: number);
        /** The transform of real numbers: frequencies [0, size / 2]. */
        realTransform(out: number[], data: ArrayLike<number>): void;
        transform(out: number[], data: ArrayLike<number>): void;
    }
}
