// SPDX-License-Identifier: Apache-2.0
//
// What readers do on the page, in Chromium, from a file and without a network.

import type {Browser, Page} from "playwright-core";
import {afterAll, beforeAll, describe, expect, it} from "vitest";
import {launch, open} from "../chromium";
import {obstacles, overflow} from "../reader";

let browser: Browser;
beforeAll(async () => {
    browser = await launch();
});
afterAll(() => browser.close());

const caption = (page: Page, title: string) =>
    page.locator("figure", {has: page.getByRole("heading", {name: title, exact: true})});
const filled = async (page: Page, title: string) =>
    Number((await caption(page, title).locator("figcaption").textContent())!.split(" ")[0]);
const samples = (page: Page) => page.getByRole("spinbutton", {name: "Samples"});

/** The colors of a canvas, as many as there are different ones. */
const differentColors = (page: Page, title: string) =>
    caption(page, title)
        .locator("canvas")
        .evaluate((canvas: HTMLCanvasElement) => {
            const {width, height} = canvas;
            const {data} = canvas.getContext("2d")!.getImageData(0, 0, width, height);
            return new Set(new Uint32Array(data.buffer)).size;
        });

describe("points", () => {
    it("are as many as the slider says, by keys, buttons and numbers", async () => {
        const {page, faults} = await open(browser);
        expect(await filled(page, "x and y")).toBe(256);
        const slider = page.getByRole("slider");
        await slider.focus();
        await page.keyboard.press("PageUp");
        await expect.poll(() => filled(page, "x and z")).toBe(512);
        await page.keyboard.press("ArrowLeft");
        await expect.poll(() => samples(page).inputValue()).toBe("511");
        await page.keyboard.press("Home");
        await expect.poll(() => filled(page, "x and y")).toBe(1);
        await page.keyboard.press("End");
        await expect.poll(() => filled(page, "z and y")).toBeGreaterThan(2000);
        await page.getByRole("button", {name: "Half as many"}).click();
        await expect.poll(() => samples(page).inputValue()).toBe("2048");
        await samples(page).fill("64");
        await expect.poll(() => filled(page, "x and y")).toBe(64);
        await samples(page).fill("0");
        await page.getByText("A whole number from 1 to 4096.").waitFor();
        await samples(page).blur();
        await expect.poll(() => samples(page).inputValue()).toBe("64");
        expect(faults).toEqual([]);
        await page.context().close();
    });

    it("follow a dragged slider", async () => {
        const {page, faults} = await open(browser);
        const box = (await page.getByRole("slider").boundingBox())!;
        const y = box.y + box.height / 2;
        await page.mouse.move(box.x + 0.66 * box.width, y);
        await page.mouse.down();
        await page.mouse.move(box.x + box.width, y, {steps: 5});
        await page.mouse.up();
        await expect.poll(() => samples(page).inputValue()).toBe("4096");
        await expect.poll(() => page.url()).toMatch(/#count=4096$/);
        expect(faults).toEqual([]);
        await page.context().close();
    });

    it("leave strata empty if they are independent, in every shape", async () => {
        const {page} = await open(browser, "#generator=random");
        for (const columns of ["1 column", "2 columns", "256 columns"]) {
            await page.getByLabel("Strata").selectOption(columns);
            await page
                .getByText(`strata, ${columns.split(" ")[0]} × `)
                .first()
                .waitFor();
            expect(await filled(page, "x and y")).toBeLessThan(200);
        }
        await page.getByLabel("Generator").selectOption("pmj, from tables");
        await expect.poll(() => filled(page, "x and y")).toBe(256);
        await page.context().close();
    });

    it("are colored by first digits", async () => {
        const {page} = await open(browser, "#strata=none");
        const one = await differentColors(page, "x and y");
        await page.getByLabel("Colors", {exact: true}).selectOption("Digits of x");
        await page.getByLabel("First binary digits").selectOption("3");
        expect(await page.getByRole("list", {name: "First digits of x"}).textContent()).toBe(
            "000001010011100101110111",
        );
        await expect.poll(() => differentColors(page, "x and y")).toBeGreaterThan(one + 8);
        await page.context().close();
    });

    it("show their numbers when they are touched", async () => {
        const {page} = await open(browser, "#count=1", {
            hasTouch: true,
            viewport: {width: 380, height: 900},
        });
        const canvas = caption(page, "x and y").locator("canvas");
        const box = (await canvas.boundingBox())!;
        // Sample 0 of pattern 7 (docs/python.md), on a square with the margins of scatter.ts.
        const side = box.width - 58;
        await canvas.tap({position: {x: 48 + 0.4493 * side, y: 8 + (1 - 0.387) * side}});
        await page.getByText("Sample 0: x = 0.44925, y = 0.38698").waitFor();
        await page.context().close();
    });

    it("have a spectrum that becomes the mean of 32 patterns", async () => {
        const {page, faults} = await open(browser);
        await page.getByText("Mean of 32 patterns.").waitFor();
        expect(await differentColors(page, "Spectrum of x and y")).toBeGreaterThan(100);
        expect(faults).toEqual([]);
        await page.context().close();
    });
});

describe("domains", () => {
    it("have no crowded strata as slots", async () => {
        const {page, faults} = await open(browser);
        await page.getByRole("tab", {name: "Points"}).focus();
        await page.keyboard.press("ArrowRight");
        const text = () => caption(page, "x of A and x of B").locator("figcaption").textContent();
        await expect
            .poll(text)
            .toMatch(
                /^256 of 256 strata, 16 × 16, have a sample; the fullest has 1\. With plain domains, 1/,
            );
        await page.getByLabel("Domain A").selectOption("Plain, no slot");
        await page.getByLabel("Domain B").selectOption("Plain, no slot");
        await expect
            .poll(text)
            .toMatch(/^1\d\d of 256 strata, 16 × 16, have a sample; the fullest has \d\.$/);
        await page.getByLabel("Domain A").selectOption("Slot 4");
        await page.getByLabel("Domain B").selectOption("Slot 4");
        await page
            .getByText("A and B are the same domain here: a mistake in a renderer.")
            .waitFor();
        expect(faults).toEqual([]);
        await page.context().close();
    });
});

describe("the address", () => {
    it("keeps a view, and is copied", async () => {
        const {page, faults} = await open(browser, "", {
            permissions: ["clipboard-read", "clipboard-write"],
        });
        await page.getByLabel("Generator").selectOption("long, without end");
        await page.getByLabel("Pattern", {exact: true}).fill("4294967295");
        await expect.poll(() => page.url()).toMatch(/#generator=long&pattern=4294967295$/);
        const said = page.getByText("Copied", {exact: true}).waitFor(); // not for long
        await page.getByRole("button", {name: "Copy the link to this view"}).click();
        await said;
        expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(page.url());
        await page.reload();
        expect(await page.getByLabel("Generator").inputValue()).toBe("long");
        await page.evaluate(() => (location.hash = "#view=domains&a=3"));
        expect(await page.getByLabel("Domain A").inputValue()).toBe("3");
        expect(faults).toEqual([]);
        await page.context().close();
    });

    it("is followed from the first rendering on", async () => {
        const {page, faults} = await open(browser, "#count=16", {}, () => {
            const observer = new MutationObserver(() => {
                if (!document.querySelector("[role=tab]")) return;
                observer.disconnect();
                location.hash = "#view=domains&a=3";
            });
            observer.observe(document, {childList: true, subtree: true});
        });
        expect(await page.getByLabel("Domain A").inputValue()).toBe("3");
        expect(faults).toEqual([]);
        await page.context().close();
    });

    it("is followed when the view before is written over it", async () => {
        const {page} = await open(browser, "#count=16");
        await page.evaluate(() => {
            location.hash = "#view=domains&a=3";
            history.replaceState(null, "", "#count=16"); // as a late timer of the page does
        });
        expect(await page.getByLabel("Domain A").inputValue()).toBe("3");
        await expect.poll(() => page.url()).toMatch(/#view=domains&a=3$/);
        await page.context().close();
    });

    it("is complained of where it is wrong", async () => {
        const {page, faults} = await open(browser, "#count=5000&flavor=7&generator=long");
        expect(await page.getByRole("alert").allTextContents()).toEqual([
            "The address says count=5000; it takes a whole number from 1 to 4096. Shown is 256.",
            "The address has a setting “flavor”, which this page does not know.",
        ]);
        expect(await samples(page).inputValue()).toBe("256");
        await samples(page).fill("2");
        await expect.poll(() => page.getByRole("alert").count()).toBe(0);
        expect(faults).toEqual([]);
        await page.context().close();
    });
});

it("can be read by all at 380 pixels", async () => {
    const {page, faults} = await open(browser, "#color=x", {
        viewport: {width: 380, height: 800},
        colorScheme: "dark",
    });
    expect(await overflow(page)).toBe(0);
    expect(await obstacles(page)).toEqual([]);
    expect(faults).toEqual([]);
    await page.context().close();
});
