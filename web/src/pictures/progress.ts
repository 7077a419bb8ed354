// SPDX-License-Identifier: Apache-2.0
//
// Pictures of one scene by several sources that get more and more samples, and their errors against a
// reference that gets more samples as well.

import {filtered, rootMeanSquare} from "./film";
import type {Renderer, Source} from "./renderer";

/** Those that are compared, in their order on the page. */
export const compared = ["white", "pmj", "joint", "blue"] as const satisfies readonly Source[];

export const pictureSize = 128;

/** Pictures by all that are compared: sums over so many samples of each pixel. */
export interface Film {
    samples: number;
    raw: Float32Array[];
    filtered: Float32Array[];
}

/** Root mean square errors at one number of samples, in the order of `compared`. */
export interface Errors {
    samples: number;
    raw: number[];
    filtered: number[];
}

export interface Job {
    scene: Float32Array;
    samples: number;
    seed: number;
    /** Of the filter, in pixels. */
    sigma: number;
}

export interface Progress {
    film: Film;
    /** Of all films so far, against a reference of so many samples of each pixel. */
    errors: Errors[];
    reference: number;
}

/** The samples after which errors are taken: each a quarter more than before, up to the last. */
export function stops(samples: number): number[] {
    const result: number[] = [];
    for (let n = 1; n < samples; n += Math.ceil(n / 4)) result.push(n);
    return [...result, samples];
}

/** Of each pixel of the reference, once so many pictures' samples are there. */
const referenceOnTheWay = (samples: number): number => Math.max(4 * samples, 8);
/** Its error is then an eighth of the pictures', where it falls as N^-0.75; of many, a third. */
const referenceAtTheEnd = (samples: number): number => Math.min(Math.max(16 * samples, 64), 4096);

// Of no picture: another seed, and a source that is not compared.
const referenceSeed = 0x5eed0000;
const referenceSource = "long";

/** Sums of each scene, which grow. */
const references = new WeakMap<Float32Array, {sums: Float32Array; samples: number}>();

const blank = () => new Float32Array(4 * pictureSize ** 2);
const pause = () => new Promise(resolve => setTimeout(resolve));

/** Renders until all is done or `signal` aborts. Throws a DeviceLost. */
export async function renderPictures(
    renderer: Renderer,
    job: Job,
    onProgress: (progress: Progress) => void,
    signal: AbortSignal,
): Promise<void> {
    const size = pictureSize;
    let atOnce = 1; // samples, such that the page is kept waiting for about 40 ms

    /** Adds samples [first, end) to `sums`; gives the first that is missing. */
    async function add(
        sums: Float32Array,
        source: Source,
        seed: number,
        first: number,
        end: number,
    ): Promise<number> {
        while (first < end && !signal.aborted) {
            const count = Math.min(atOnce, end - first);
            const start = performance.now();
            const more = await renderer.render({
                scene: job.scene,
                size,
                source,
                first,
                count,
                seed,
            });
            const took = performance.now() - start;
            for (let i = 0; i < sums.length; ++i) sums[i]! += more[i]!;
            first += count;
            if (took < 20 && count === atOnce) atOnce = Math.min(2 * atOnce, 256);
            if (took > 60) atOnce = Math.max(atOnce >> 1, 1);
            await pause();
        }
        return first;
    }

    const truth = references.get(job.scene) ?? {sums: blank(), samples: 0};
    references.set(job.scene, truth);
    async function refine(samples: number): Promise<void> {
        const {sums} = truth;
        truth.samples = await add(sums, referenceSource, referenceSeed, truth.samples, samples);
    }

    const films: Film[] = [];
    function report(): void {
        if (signal.aborted) return;
        const {sums, samples} = truth;
        const smooth = filtered(sums, size, job.sigma);
        const border = 3 * job.sigma;
        const errors = films.map(film => ({
            samples: film.samples,
            raw: film.raw.map(each => rootMeanSquare(each, film.samples, sums, samples, size, 0)),
            filtered: film.filtered.map(each =>
                rootMeanSquare(each, film.samples, smooth, samples, size, border),
            ),
        }));
        onProgress({film: films.at(-1)!, errors, reference: samples});
    }

    const sums = compared.map(blank);
    for (const stop of stops(job.samples)) {
        for (const [i, source] of compared.entries()) {
            await add(sums[i]!, source, job.seed, films.at(-1)?.samples ?? 0, stop);
        }
        await refine(referenceOnTheWay(stop));
        if (signal.aborted) return;
        films.push({
            samples: stop,
            raw: sums.map(each => each.slice()),
            filtered: sums.map(each => filtered(each, size, job.sigma)),
        });
        report();
        await pause();
    }
    const end = referenceAtTheEnd(job.samples);
    while (truth.samples < end && !signal.aborted) {
        await refine(Math.min(2 * truth.samples, end));
        report();
    }
}
