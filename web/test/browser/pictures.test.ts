// SPDX-License-Identifier: Apache-2.0
//
// Pictures in Chromium, on devices that its SwiftShader has, and what the page says where one is missing.

import type {Browser} from "playwright-core";
import {afterAll, beforeAll, describe, expect, it} from "vitest";
import type {Wellstrat} from "wellstrat";
import {loadLibrary} from "../../src/library";
import {compared} from "../../src/pictures/progress";
import {devices, launch, open, pageAddress} from "../chromium";
import {differenceFromProcessor, done, notice} from "../pictures";

let library: Wellstrat;
let browser: Browser;
beforeAll(async () => {
    ({library} = await loadLibrary());
    browser = await launch(devices.webgpu);
});
afterAll(() => browser.close());

describe.each([
    ["webgpu", "WebGPU"],
    ["webgl2", "WebGL2"],
])("pictures by %s", (by, name) => {
    it("are those of the processor", async () => {
        const {page, faults} = await open(browser, `#view=pictures&scene=both&samples=1&by=${by}`);
        await done(page, name);
        for (const source of compared) {
            expect(await differenceFromProcessor(page, library, "both", source, 1)).toBeLessThan(
                0.002,
            );
        }
        await page.getByRole("rowheader", {name: "filtered"}).waitFor();
        expect(faults).toEqual([]);
        await page.context().close();
    });
});

describe("without", () => {
    it("a graphics device, WebAssembly renders", async () => {
        const {page, faults} = await open(browser, "#view=pictures&samples=1");
        await done(page, "WebAssembly");
        expect(await notice(page)).toBe(
            "This browser has no graphics device for WebGPU. " +
                "This browser has no graphics device for WebGL2. WebAssembly does it.",
        );
        expect(faults).toEqual([]);
        await page.context().close();
    });

    it("workers, the page renders by itself", async () => {
        const {page, faults} = await open(browser, "#view=pictures&samples=1&by=wasm", {}, () => {
            window.Worker = class {
                constructor() {
                    throw new DOMException("blocked", "SecurityError");
                }
            } as unknown as typeof Worker;
        });
        await done(page, "WebAssembly, without a worker");
        expect(await notice(page)).toMatch(/^This browser lets the page have no worker\./);
        expect(faults).toEqual([]);
        await page.context().close();
    });

    it("SIMD, the samples are the same", async () => {
        const {page} = await open(browser, "#view=pictures&samples=1&by=wasm", {}, () => {
            WebAssembly.validate = () => false;
        });
        await page.getByText("without SIMD, which this browser has not").waitFor();
        await page.context().close();
    });

    it("WebAssembly, the page says so", async () => {
        const context = await browser.newContext();
        const page = await context.newPage();
        await page.addInitScript(() => {
            Reflect.deleteProperty(window, "WebAssembly");
        });
        await page.goto(pageAddress);
        await page.getByText(/^The samples cannot be computed here: /).waitFor();
        await context.close();
    });
});

describe("a device that is lost", () => {
    it("of WebGPU gives way to WebGL2", async () => {
        const {page} = await open(browser, "#view=pictures&samples=64&by=webgpu", {}, () => {
            let device: GPUDevice;
            const request = GPUAdapter.prototype.requestDevice;
            GPUAdapter.prototype.requestDevice = async function (...rest) {
                return (device = await request.apply(this, rest));
            };
            let renderings = 0;
            const map = GPUBuffer.prototype.mapAsync;
            GPUBuffer.prototype.mapAsync = function (...rest) {
                if (++renderings === 3) device.destroy();
                return map.apply(this, rest);
            };
        });
        await page.getByText("WebGPU lost its device. WebGL2 does it.").waitFor();
        await page.context().close();
    });
});
