// SPDX-License-Identifier: Apache-2.0

import {beforeAll, describe, expect, it} from "vitest";
import type {Wellstrat} from "wellstrat";
import {loadLibrary} from "../../src/library";
import {encode, filtered, rootMeanSquare} from "../../src/pictures/film";
import {renderOnProcessor} from "../../src/pictures/processor";
import {compared, pictureSize, renderPictures, stops} from "../../src/pictures/progress";
import type {Progress} from "../../src/pictures/progress";
import type {Renderer, Request} from "../../src/pictures/renderer";
import {scenes} from "../../src/pictures/scene";

let library: Wellstrat;
beforeAll(async () => {
    ({library} = await loadLibrary());
});

const request = (part: Partial<Request> = {}): Request => ({
    scene: scenes.shadow,
    size: 32,
    source: "joint",
    first: 0,
    count: 4,
    seed: 1,
    ...part,
});
const render = (part?: Partial<Request>) => renderOnProcessor(library, request(part));

describe("pictures on the processor", () => {
    it("are sums of their samples", () => {
        const [first, second, all] = [{count: 1}, {first: 1, count: 3}, {}].map(render);
        const sum = first!.map((value, i) => value + second![i]!);
        expect(rootMeanSquare(sum, 1, all!, 1, 32, 0)).toBeLessThan(1e-6);
    });

    it("differ by source and seed, and by nothing else", () => {
        const of = (part: Partial<Request>) => render(part).join();
        const all = [...compared, "long" as const].map(source => of({source}));
        expect(new Set([...all, of({seed: 2}), of({scene: scenes.lens})]).size).toBe(7);
        expect(of({source: "joint"})).toBe(all[2]);
    });

    it("have less error by stratified samples, and after a filter by blue ones", () => {
        const size = 64;
        const truth = render({size, source: "long", count: 256, seed: 9});
        const smooth = filtered(truth, size, 2);
        const pictures = (count: number) => compared.map(source => render({size, source, count}));
        const raw = pictures(16).map(each => rootMeanSquare(each, 16, truth, 256, size, 0));
        expect(raw[1]! / raw[0]!).toBeLessThan(0.6);
        expect(raw[2]! / raw[0]!).toBeLessThan(0.6);
        expect(raw[3]! / raw[0]!).toBeLessThan(0.6);
        const soft = pictures(1).map(each =>
            rootMeanSquare(filtered(each, size, 2), 1, smooth, 256, size, 6),
        );
        expect(soft[3]! / soft[1]!).toBeLessThan(0.7);
    });
});

describe("a film", () => {
    it("is encoded as sRGB, opaque", () => {
        expect([...encode(Float32Array.of(0, 1, 2, 9, 0.428, -1, 0.004, 0), 2)]).toEqual([
            0, 188, 255, 255, 127, 0, 7, 255,
        ]);
    });

    it("keeps constants and sums under the filter, and is spread by it", () => {
        const constant = new Float32Array(4 * 20 * 20).fill(0.5);
        const error = rootMeanSquare(filtered(constant, 20, 2), 1, constant, 1, 20, 0);
        expect(error).toBeLessThan(1e-6);

        const point = new Float32Array(4 * 20 * 20);
        point[4 * (10 * 20 + 9)] = 1;
        const spread = filtered(point, 20, 1);
        const at = (x: number, y: number) => spread[4 * (y * 20 + x)]!;
        expect(at(9, 10)).toBeCloseTo(1 / (2 * Math.PI), 2);
        expect(at(8, 10)).toBeCloseTo(at(9, 10) * Math.exp(-0.5), 5);
        expect(at(9, 8)).toBeCloseTo(at(9, 10) * Math.exp(-2), 5);
        expect(spread.reduce((a, b) => a + b)).toBeCloseTo(1, 5);
    });

    it("has the error of its mean, without its border", () => {
        const picture = new Float32Array(4 * 4 * 4).fill(2);
        const reference = new Float32Array(4 * 4 * 4).fill(9);
        picture[4 * 5] = 8;
        expect(rootMeanSquare(picture, 2, reference, 9, 4, 1)).toBeCloseTo(Math.sqrt(9 / 12), 6);
        expect(rootMeanSquare(picture, 2, reference, 9, 4, 0)).toBeCloseTo(Math.sqrt(9 / 48), 6);
    });
});

describe("progress", () => {
    it("stops at 1, then a quarter later each time, then at the end", () => {
        expect(stops(1)).toEqual([1]);
        expect(stops(10)).toEqual([1, 2, 3, 4, 5, 7, 9, 10]);
        expect(stops(64).at(-1)).toBe(64);
    });

    /** Gives each pixel as many as there are samples, and more by white. */
    const counting: Renderer = {
        name: "counting",
        close() {},
        render: async ({size, count, source}) =>
            new Float32Array(4 * size * size).fill(source === "white" ? 3 * count : count),
    };

    async function run(signal: AbortSignal, onProgress: (progress: Progress) => void) {
        const job = {scene: new Float32Array(1), samples: 10, seed: 1, sigma: 2};
        await renderPictures(counting, job, onProgress, signal);
    }

    it("adds each sample once, and ends with a larger reference", async () => {
        const all: Progress[] = [];
        await run(new AbortController().signal, progress => all.push(progress));
        const last = all.at(-1)!;
        expect(last.reference).toBe(160);
        expect(last.film.samples).toBe(10);
        expect(last.film.raw.map(each => each[0])).toEqual([30, 10, 10, 10]);
        expect(last.film.raw[0]).toHaveLength(4 * pictureSize ** 2);
        expect(last.errors.map(each => each.samples)).toEqual(stops(10));
        for (const {raw, filtered: smooth} of last.errors) {
            expect(raw[0]).toBeCloseTo(2, 5);
            expect(smooth[0]).toBeCloseTo(2, 5);
            expect(raw.slice(1)).toEqual([0, 0, 0]);
        }
    });

    it("says nothing once it is aborted", async () => {
        const stop = new AbortController();
        let reports = 0;
        await run(stop.signal, () => {
            ++reports;
            stop.abort();
        });
        expect(reports).toBe(1);
    });
});
