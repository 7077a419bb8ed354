// SPDX-License-Identifier: Apache-2.0
//
// The samples of two domains of one pixel.

import type {Wellstrat} from "wellstrat";
import type {View} from "../address";

/** x and y of the samples of a domain. */
export interface DomainPoints {
    x: Float32Array;
    y: Float32Array;
}

// Any two different constants do for domains without a slot.
const plainScrambles = {a: 0x6b8f21d3, b: 0x91e4c05a};

/** Whether the two domains are one and the same. */
export function areOne({a, b}: View): boolean {
    return a === b && a !== "none";
}

/** Samples of domain "a" or "b" of the view; `slotted` says whether slots are drawn as such. */
export function domainPoints(
    library: Wellstrat,
    view: View,
    which: "a" | "b",
    slotted: boolean,
): DomainPoints {
    const {generator, pattern, first, count} = view;
    const pixel = Uint32Array.from({length: 2 * count}, (_, i) =>
        i % 2 === 0 ? pattern : first + (i >> 1),
    );
    const slot = view[which] === "none" ? undefined : Number(view[which]);
    const scramble = slot === undefined ? plainScrambles[which] : library.jointScramble(slot);
    const domain = library.newDomain(pixel, scramble, {generator});
    const bySlot = slotted && slot !== undefined && generator !== "random" ? {slot} : {};
    const xi = library.draw(domain, {generator, dims: 2, ...bySlot});
    const column = (k: number) => Float32Array.from({length: count}, (_, i) => xi[2 * i + k]!);
    return {x: column(0), y: column(1)};
}
