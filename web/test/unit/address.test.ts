// SPDX-License-Identifier: Apache-2.0

import {describe, expect, it} from "vitest";
import {initialView, readAddress, writeAddress} from "../../src/address";

describe("an address", () => {
    it("is empty for the first view", () => {
        expect(writeAddress(initialView)).toBe("");
        expect(readAddress("")).toEqual({view: initialView, complaints: []});
    });

    it("gives the view that wrote it", () => {
        const view = {
            ...initialView,
            view: "domains" as const,
            generator: "blue" as const,
            pattern: 2 ** 32 - 1,
            count: 4096,
            a: "none",
            b: "15",
        };
        const address = writeAddress(view);
        expect(address).toBe(
            "view=domains&generator=blue&pattern=4294967295&count=4096&a=none&b=15",
        );
        expect(readAddress(`#${address}`)).toEqual({view, complaints: []});
    });

    it.each(["0", "4097", "-1", "1.5", "abc", "", "1e3", "99999999999"])(
        "says that %j is no count, and shows the default",
        text => {
            expect(readAddress(`#count=${text}&pattern=3`)).toEqual({
                view: {...initialView, pattern: 3},
                complaints: [
                    `The address says count=${text}; it takes a whole number from 1 to 4096. Shown is 256.`,
                ],
            });
        },
    );

    it("says which choices there are", () => {
        expect(readAddress("#generator=PMJ&a=16").complaints).toEqual([
            "The address says generator=PMJ; it takes one of pmj, long, blue, random. Shown is pmj.",
            "The address says a=16; it takes none or a slot from 0 to 15. Shown is 0.",
        ]);
    });

    it("says which settings it does not know", () => {
        for (const name of ["speed", "constructor", "__proto__", "%E0%A4%A"]) {
            const {view, complaints} = readAddress(`#${name}=1`);
            expect(view).toEqual(initialView);
            expect(complaints).toHaveLength(1);
            expect(complaints[0]).toMatch(/which this page does not know\.$/);
        }
    });
});
