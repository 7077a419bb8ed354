// SPDX-License-Identifier: Apache-2.0
//
// Strata of the unit square: equal rectangles, as many as there are samples, or the next power of two.

/** columns times rows rectangles; both are powers of two. */
export interface Shape {
    columns: number;
    rows: number;
}

/** m of the 2^m strata for `count` samples, 1 or more. */
export function strataDigits(count: number): number {
    return Math.ceil(Math.log2(count));
}

/** The shape with 2^columnDigits columns, at most as many as there are strata; or the squarest. */
export function strataShape(count: number, columnDigits: number | "square"): Shape {
    const digits = strataDigits(count);
    const across =
        columnDigits === "square" ? Math.ceil(digits / 2) : Math.min(columnDigits, digits);
    return {columns: 2 ** across, rows: 2 ** (digits - across)};
}

/** The number of samples in each stratum, row by row from v = 0. */
export function countInStrata(
    u: Float32Array,
    v: Float32Array,
    {columns, rows}: Shape,
): Uint16Array {
    const counts = new Uint16Array(columns * rows);
    for (let i = 0; i < u.length; ++i) {
        ++counts[Math.floor(v[i]! * rows) * columns + Math.floor(u[i]! * columns)]!;
    }
    return counts;
}

/** The most samples that a stratum has. */
export function fullestStratum(counts: Uint16Array): number {
    return counts.reduce((most, count) => Math.max(most, count), 0);
}

/** How many strata have a sample. */
export function filledStrata(counts: Uint16Array): number {
    return counts.reduce((filled, count) => filled + Math.min(count, 1), 0);
}
