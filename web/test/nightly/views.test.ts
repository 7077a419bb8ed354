// SPDX-License-Identifier: Apache-2.0
//
// Every view as readers of all kinds have it. Screenshots stay in build/page/screenshots.

import {fileURLToPath} from "node:url";
import type {Browser} from "playwright-core";
import {afterAll, beforeAll, describe, expect, it} from "vitest";
import {launch, open} from "../chromium";
import {obstacles, overflow} from "../reader";

const folder = fileURLToPath(new URL("../../../build/page/screenshots", import.meta.url));

let browser: Browser;
beforeAll(async () => {
    browser = await launch();
});
afterAll(() => browser.close());

describe.each(["points", "domains", "pictures"])("the view of %s", view => {
    describe.each(["light", "dark"] as const)("in %s colors", colorScheme => {
        it.each([380, 768, 1280])("fits into %i pixels", async width => {
            const hash = `#view=${view}&samples=4&color=y&by=wasm`;
            const {page, faults} = await open(browser, hash, {
                viewport: {width, height: 900},
                colorScheme,
                reducedMotion: "reduce",
            });
            const last = view === "pictures" ? /of 64 other samples/ : /Mean of 32 patterns|of B/;
            await page.getByText(last).first().waitFor();
            expect(await overflow(page)).toBe(0);
            expect(await obstacles(page)).toEqual([]);
            const drawn = await page.locator("canvas").evaluateAll(all =>
                all.map(each => {
                    const canvas = each as HTMLCanvasElement;
                    const {width: w, height: h} = canvas;
                    const {data} = canvas.getContext("2d")!.getImageData(0, 0, w, h);
                    return new Set(new Uint32Array(data.buffer)).size > 2;
                }),
            );
            expect(drawn).not.toContain(false);
            const path = `${folder}/${view}-${width}-${colorScheme}.png`;
            await page.screenshot({path, fullPage: true});
            expect(faults).toEqual([]);
            await page.context().close();
        });
    });
});

it("points turn as a cube, by keys and by dragging", async () => {
    const {page} = await open(browser);
    const cube = page.getByRole("img", {name: /points in the unit cube/});
    const look = () => cube.evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());
    const first = await look();
    await cube.focus();
    await page.keyboard.press("ArrowLeft");
    await expect.poll(look).not.toBe(first);
    await page.keyboard.press("ArrowRight");
    await expect.poll(look).toBe(first);
    await cube.hover();
    await page.mouse.down();
    await page.mouse.move(700, 700, {steps: 3});
    await page.mouse.up();
    await expect.poll(look).not.toBe(first);
    await page.context().close();
});
