// SPDX-License-Identifier: Apache-2.0

import type {View} from "../address";

/** The generators by their names in the library, and what they are. */
export const generators: readonly (readonly [View["generator"], string])[] = [
    ["pmj", "pmj, from tables"],
    ["long", "long, without end"],
    ["blue", "blue, over pixels"],
    ["random", "random, independent"],
];

/** Which strata are drawn: by the digits of their columns. */
export const strataChoices: readonly (readonly [View["strata"], string])[] = [
    ["square", "Square"],
    ["none", "None"],
    ...Array.from({length: 13}, (_, digits): readonly [View["strata"], string] => [
        String(digits) as View["strata"],
        digits === 0 ? "1 column" : `${2 ** digits} columns`,
    ]),
];
