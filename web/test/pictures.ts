// SPDX-License-Identifier: Apache-2.0

import type {Page} from "playwright-core";
import type {Wellstrat} from "wellstrat";
import {encode} from "../src/pictures/film";
import {renderOnProcessor} from "../src/pictures/processor";
import {pictureSize} from "../src/pictures/progress";
import type {Source} from "../src/pictures/renderer";
import {scenes} from "../src/pictures/scene";

/** Waits until the pictures have all their samples, and are drawn, a frame later. */
export async function done(page: Page, by: string, samples = 1): Promise<void> {
    await page
        .getByText(`${samples} of ${samples} samples of each pixel, rendered by ${by}.`)
        .waitFor({timeout: 180_000});
    await page.evaluate(
        () => new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve))),
    );
}

/** What the page says is missing. */
export const notice = (page: Page) => page.locator(".notice").textContent();

/** The pixels of a picture on the page, as they are before they are enlarged. */
function shownPixels(page: Page, source: Source): Promise<number[]> {
    return page
        .getByRole("img", {name: `${source}, as rendered`})
        .evaluate((canvas: HTMLCanvasElement, size: number) => {
            const {width, height} = canvas;
            const {data} = canvas.getContext("2d")!.getImageData(0, 0, width, height);
            const result: number[] = [];
            for (let y = 0; y < size; ++y) {
                for (let x = 0; x < size; ++x) {
                    const [column, row] = [((x + 0.5) * width) / size, ((y + 0.5) * height) / size];
                    const at = 4 * (Math.floor(row) * width + Math.floor(column));
                    result.push(...data.slice(at, at + 4));
                }
            }
            return result;
        }, pictureSize);
}

/**
 * The part of pixels on which a picture on the page, of seed 1, differs from the one that Node.js
 * renders. Some do, where rounding lets a ray just miss an edge.
 */
export async function differenceFromProcessor(
    page: Page,
    library: Wellstrat,
    scene: keyof typeof scenes,
    source: Source,
    samples: number,
): Promise<number> {
    const shown = await shownPixels(page, source);
    const request = {scene: scenes[scene], size: pictureSize, source, first: 0, seed: 1};
    const wanted = encode(renderOnProcessor(library, {...request, count: samples}), samples);
    let different = 0;
    for (let at = 0; at < wanted.length; at += 4) {
        const far = [0, 1, 2, 3].some(k => Math.abs(shown[at + k]! - wanted[at + k]!) > 2);
        if (far) ++different;
    }
    return different / pictureSize ** 2;
}
