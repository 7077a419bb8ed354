// SPDX-License-Identifier: Apache-2.0
//
// Debian's Chromium with the built page, opened as a file and cut off from any network.

import {existsSync} from "node:fs";
import {chromium, type Browser, type BrowserContextOptions, type Page} from "playwright-core";

export const pageAddress = new URL("../../build/page/index.html", import.meta.url).href;

const program = ["/usr/bin/chromium", "/usr/bin/chromium-browser"].find(existsSync);

/** Graphics devices on the processor, by Chromium's SwiftShader. */
export const devices = {
    none: ["--disable-3d-apis", "--disable-features=WebGPUService", "--disable-gpu"],
    webgl2: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
    webgpu: [
        "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
        "--enable-unsafe-webgpu",
        "--use-webgpu-adapter=swiftshader",
    ],
};

export function launch(flags: string[] = devices.webgl2): Promise<Browser> {
    if (!program) throw new Error("there is no Chromium; run: scripts/setup test");
    return chromium.launch({
        executablePath: program,
        args: ["--no-sandbox", "--disable-dev-shm-usage", ...flags],
    });
}

/** An open page, and what went wrong on it since: console errors, exceptions and requests. */
export interface Opened {
    page: Page;
    faults: string[];
}

/** Opens the page in a context of its own. `prepare` runs in it before the page's own scripts. */
export async function open(
    browser: Browser,
    hash = "",
    options: BrowserContextOptions = {},
    prepare?: () => void,
): Promise<Opened> {
    const context = await browser.newContext({offline: true, ...options});
    context.setDefaultTimeout(120_000); // for machines that do much else
    const page = await context.newPage();
    const faults: string[] = [];
    page.on("console", message => {
        if (["error", "warning"].includes(message.type())) faults.push(message.text());
    });
    page.on("pageerror", error => faults.push(error.message));
    page.on("request", request => {
        const url = request.url();
        if (!/^(file|data|blob):/.test(url)) faults.push(`asks for ${url}`);
    });
    if (prepare) await page.addInitScript(prepare);
    await page.goto(pageAddress + hash);
    await page.getByRole("tab").first().waitFor();
    return {page, faults};
}
