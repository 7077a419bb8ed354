// SPDX-License-Identifier: Apache-2.0
//
// All pictures, by all ways to render, and more of what the page says where one is missing.

import type {Browser} from "playwright-core";
import {afterAll, beforeAll, describe, expect, it} from "vitest";
import type {Wellstrat} from "wellstrat";
import {loadLibrary} from "../../src/library";
import {compared} from "../../src/pictures/progress";
import {scenes} from "../../src/pictures/scene";
import {devices, launch, open} from "../chromium";
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
    ["wasm", "WebAssembly"],
])("pictures by %s", (by, name) => {
    it.each(Object.keys(scenes) as (keyof typeof scenes)[])(
        "of %s are those of the processor",
        async scene => {
            const hash = `#view=pictures&scene=${scene}&samples=4&by=${by}`;
            const {page, faults} = await open(browser, hash);
            await done(page, name, 4);
            for (const source of compared) {
                const different = differenceFromProcessor(page, library, scene, source, 4);
                expect(await different).toBeLessThan(0.002);
            }
            expect(faults).toEqual([]);
            await page.context().close();
        },
    );
});

describe("where a device fails", () => {
    it("for want of memory for tables, long samples take their place", async () => {
        const {page, faults} = await open(browser, "#count=64&strata=0", {}, () => {
            WebAssembly.Memory.prototype.grow = () => {
                throw new RangeError("no memory");
            };
        });
        await page
            .getByText("The tables do not fit into memory. For pmj there are samples of long.")
            .waitFor();
        await page.getByText("64 of 64 strata, 1 × 64, have a sample.").first().waitFor();
        await page.getByRole("tab", {name: "Pictures"}).click();
        await page.getByLabel("Rendered by").selectOption("WebGPU");
        await page.getByText("The tables for shaders do not fit into memory.").first().waitFor();
        expect(faults).toEqual([]);
        await page.context().close();
    });

    it("for want of room for the tables, the next way does", async () => {
        const {page} = await open(browser, "#view=pictures&samples=1&by=webgpu", {}, () => {
            Object.defineProperty(GPUSupportedLimits.prototype, "maxStorageBufferBindingSize", {
                value: 2 ** 20,
            });
        });
        await done(page, "WebGL2");
        expect(await notice(page)).toBe(
            "The tables do not fit into a buffer of this WebGPU device. WebGL2 does it.",
        );
        await page.context().close();
    });

    it("for want of WebGPU and WebGL2, WebAssembly renders", async () => {
        const {page, faults} = await open(browser, "#view=pictures&samples=1&by=webgpu", {}, () => {
            Object.defineProperty(navigator, "gpu", {value: undefined});
            HTMLCanvasElement.prototype.getContext = new Proxy(
                HTMLCanvasElement.prototype.getContext,
                {
                    apply: (get, canvas, [kind, ...rest]) =>
                        kind === "webgl2" ? null : Reflect.apply(get, canvas, [kind, ...rest]),
                },
            );
        });
        await done(page, "WebAssembly");
        expect(await notice(page)).toBe(
            "This browser has no WebGPU here. This browser has no WebGL2 here. WebAssembly does it.",
        );
        expect(faults).toEqual([]);
        await page.context().close();
    });

    it("that of WebGL2 gives way to WebAssembly", async () => {
        const {page} = await open(browser, "#view=pictures&samples=64&by=webgl2", {}, () => {
            let renderings = 0;
            const {readPixels} = WebGL2RenderingContext.prototype;
            WebGL2RenderingContext.prototype.readPixels = function (...rest: unknown[]) {
                if (++renderings === 3) this.getExtension("WEBGL_lose_context")!.loseContext();
                Reflect.apply(readPixels, this, rest);
            };
        });
        await page.getByText("WebGL2 lost its device. WebAssembly does it.").waitFor();
        await done(page, "WebAssembly", 64);
        await page.context().close();
    });
});
