// SPDX-License-Identifier: Apache-2.0

import {beforeAll, describe, expect, it} from "vitest";
import type {Wellstrat} from "wellstrat";
import {initialView} from "../../src/address";
import {domainPoints} from "../../src/domains/domains";
import {loadLibrary} from "../../src/library";
import {groupsOf, pointsOf} from "../../src/points/points";
import {radialMean, spectrumOf, spectrumReach} from "../../src/points/spectrum";
import {countInStrata, filledStrata, fullestStratum, strataShape} from "../../src/points/strata";

let library: Wellstrat;
beforeAll(async () => {
    ({library} = await loadLibrary());
});

function columns(generator: "pmj" | "random", count: number, pattern = 7) {
    const xy = library.samples(pattern, count, {generator});
    return [0, 1].map(k => xy.filter((_, i) => i % 2 === k)) as [Float32Array, Float32Array];
}

describe("points", () => {
    it("are the samples of the generator, from the first one on", () => {
        for (const generator of ["pmj", "long", "blue", "random"] as const) {
            const view = {...initialView, generator, first: 100, count: 50};
            const {x, y, z} = pointsOf(library, view, 9);
            const contexts = Uint32Array.from({length: 100}, (_, i) =>
                i % 2 === 0 ? 9 : 100 + (i >> 1),
            );
            const wanted = library.draw(contexts, {generator, dims: 3});
            expect([...x].flatMap((value, i) => [value, y[i]!, z[i]!])).toEqual([...wanted]);
        }
    });

    it("are grouped by the first digits of a coordinate, or of their places", () => {
        const view = {...initialView, count: 6, digits: 1};
        const points = {
            ...pointsOf(library, view, 7),
            x: Float32Array.of(0, 0.4, 0.5, 0.9, 0, 0.99),
        };
        expect([...groupsOf({...view, color: "x"}, points).of]).toEqual([0, 0, 1, 1, 0, 1]);
        expect([...groupsOf({...view, color: "order"}, points).of]).toEqual([0, 0, 0, 0, 1, 1]);
        expect(groupsOf(view, points).count).toBe(1);
    });
});

describe("strata", () => {
    it("are as many as samples, or the next power of two", () => {
        expect(strataShape(1, "square")).toEqual({columns: 1, rows: 1});
        expect(strataShape(256, "square")).toEqual({columns: 16, rows: 16});
        expect(strataShape(128, "square")).toEqual({columns: 16, rows: 8});
        expect(strataShape(100, 0)).toEqual({columns: 1, rows: 128});
        expect(strataShape(8, 12)).toEqual({columns: 8, rows: 1});
    });

    it("count points by their places", () => {
        const u = Float32Array.of(0, 0.49, 0.5, 0.99);
        const v = Float32Array.of(0, 0.1, 0.1, 0.9);
        const counts = countInStrata(u, v, {columns: 2, rows: 2});
        expect([...counts]).toEqual([2, 1, 0, 1]);
        expect(filledStrata(counts)).toBe(3);
        expect(fullestStratum(counts)).toBe(2);
    });

    it("are all filled by the library, in each shape, and not by independent samples", () => {
        for (let digits = 0; digits <= 8; ++digits) {
            const shape = strataShape(256, digits);
            expect(filledStrata(countInStrata(...columns("pmj", 256), shape))).toBe(256);
            expect(filledStrata(countInStrata(...columns("random", 256), shape))).toBeLessThan(190);
        }
    });
});

describe("a spectrum", () => {
    it("is that of the definition, but for an error of 3 % of power 1", () => {
        const [x, y] = columns("random", 100);
        const {reach, power} = spectrumOf(x, y);
        expect(reach).toBe(32);
        const frequencies = [
            [1, 0],
            [0, -3],
            [5, 7],
            [-20, 11],
            [32, 32],
            [-32, 31],
        ] as const;
        let error = 0;
        for (const [kx, ky] of frequencies) {
            let re = 0;
            let im = 0;
            for (let i = 0; i < 100; ++i) {
                const angle = 2 * Math.PI * (kx * x[i]! + ky * y[i]!);
                re += Math.cos(angle);
                im += Math.sin(angle);
            }
            const at = (ky + reach) * (2 * reach + 1) + kx + reach;
            error += (Math.sqrt(power[at]!) - Math.hypot(re, im) / 10) ** 2;
        }
        expect(error / frequencies.length).toBeLessThan(0.03);
    });

    it("has N at frequency 0, and as much reach as a grid of the points needs", () => {
        const {reach, power} = spectrumOf(...columns("pmj", 256));
        expect(power[(power.length - 1) / 2]).toBeCloseTo(256, 3);
        expect(reach).toBe(32);
        expect([1, 16, 64, 65, 1024, 4096].map(spectrumReach)).toEqual([16, 16, 16, 32, 64, 128]);
    });

    it("has little power at low frequencies if the points are stratified", () => {
        const mean = (generator: "pmj" | "random") =>
            [...Array(16).keys()].reduce((sum, pattern) => {
                const radial = radialMean(spectrumOf(...columns(generator, 256, pattern)));
                return sum + (radial[0]! + radial[1]! + radial[2]!) / (3 * 16);
            }, 0);
        expect(mean("pmj")).toBeLessThan(0.05);
        expect(mean("random")).toBeGreaterThan(0.7);
    });
});

describe("two domains", () => {
    const shape = strataShape(256, "square");
    const fullest = (slotted: boolean, part = {}) => {
        const view = {...initialView, ...part};
        const [a, b] = (["a", "b"] as const).map(each =>
            domainPoints(library, view, each, slotted),
        );
        return Math.max(
            ...(["x", "y"] as const).flatMap(u =>
                (["x", "y"] as const).map(v => fullestStratum(countInStrata(a![u], b![v], shape))),
            ),
        );
    };

    it("are stratified together as slots, and not as plain domains", () => {
        for (const generator of ["pmj", "long", "blue"] as const) {
            expect(fullest(true, {generator})).toBeLessThanOrEqual(4);
        }
        expect(fullest(false)).toBeGreaterThan(4);
        expect(fullest(true, {a: "none", b: "none"})).toBeGreaterThan(4);
    });

    it("are one if they have one slot, and never without", () => {
        const points = (part: object) =>
            (["a", "b"] as const).map(each =>
                domainPoints(library, {...initialView, ...part}, each, true),
            );
        const [a, b] = points({a: "3", b: "3"});
        expect(a).toEqual(b);
        const [c, d] = points({a: "none", b: "none"});
        expect(c).not.toEqual(d);
    });
});
