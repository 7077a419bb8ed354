// SPDX-License-Identifier: Apache-2.0
//
// What the first view shows: samples of one pattern, and their groups.

import type {Wellstrat} from "wellstrat";
import type {View} from "../address";
import type {Groups} from "./scatter";
import {strataDigits} from "./strata";

export const axes = ["x", "y", "z"] as const;
export type Points = Record<(typeof axes)[number], Float32Array>;

/** The coordinates of the view's samples, of a pattern that may be another than the view's. */
export function pointsOf(library: Wellstrat, view: View, pattern: number): Points {
    const {count, first, generator} = view;
    const all = library.samples(pattern, count, {first, dims: 3, generator});
    const column = (k: number) => Float32Array.from({length: count}, (_, i) => all[3 * i + k]!);
    return {x: column(0), y: column(1), z: column(2)};
}

/** Groups by the first binary digits of a coordinate, or of the sample's place in the sequence. */
export function groupsOf({color, digits, count}: View, points: Points): Groups {
    if (color === "one") return {of: new Uint8Array(count), count: 1};
    const groups = 2 ** digits;
    const places = 2 ** strataDigits(count);
    const of = Uint8Array.from({length: count}, (_, i) =>
        Math.floor(groups * (color === "order" ? i / places : points[color][i]!)),
    );
    return {of, count: groups};
}
