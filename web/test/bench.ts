// SPDX-License-Identifier: Apache-2.0
//
// How soon the page can be used, and how smoothly its slider is dragged, in Chromium without a graphics
// device on two cores: `scripts/bench --page`.

import {cpus} from "node:os";
import {devices, launch, open} from "./chromium";

const runs = 5;
const median = (values: number[]) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)]!;

/** Milliseconds from the navigation until points are drawn and controls answer. */
async function interactive(): Promise<number> {
    const browser = await launch(devices.none);
    const {page} = await open(browser, "#count=4096");
    const ready = await page.evaluate(
        () =>
            new Promise<number>(resolve =>
                requestAnimationFrame(() => setTimeout(() => resolve(performance.now()))),
            ),
    );
    await browser.close();
    return ready;
}

interface Dragged {
    /** Milliseconds from frame to frame, sorted. */
    frames: number[];
    /** Milliseconds that the page's thread computes for a frame, which other programs do not change. */
    computed: number;
}

/** What happens while the slider moves, before each frame, between 2048 and 4096 points. */
async function drag(): Promise<Dragged> {
    const browser = await launch(devices.none);
    const {page} = await open(browser, "#count=4096", {viewport: {width: 1280, height: 900}});
    await page.getByText("Mean of 32 patterns.").waitFor();
    const tools = await page.context().newCDPSession(page);
    await tools.send("Performance.enable", {timeDomain: "threadTicks"});
    const computed = async () => {
        const {metrics} = await tools.send("Performance.getMetrics");
        return 1000 * metrics.find(({name}) => name === "TaskDuration")!.value;
    };
    const before = await computed();
    const times = await page.evaluate(async () => {
        const slider = document.querySelector<HTMLInputElement>("input[type=range]")!;
        const frame = () => new Promise<number>(resolve => requestAnimationFrame(resolve));
        const seen: number[] = [];
        let last = await frame();
        for (let i = 0; i < 180; ++i) {
            slider.value = String(12 - Math.abs((i % 60) - 30) / 30);
            slider.dispatchEvent(new Event("input", {bubbles: true}));
            const now = await frame();
            seen.push(now - last);
            last = now;
        }
        return seen;
    });
    const after = await computed();
    await browser.close();
    return {frames: times.sort((a, b) => a - b), computed: (after - before) / times.length};
}

const starts: number[] = [];
for (let i = 0; i < runs; ++i) starts.push(await interactive());
const {frames, computed} = await drag();
const at = (part: number) => frames[Math.floor(part * (frames.length - 1))]!.toFixed(1);
console.log(`${cpus()[0]!.model}, ${cpus().length} cores, Chromium without a graphics device`);
console.log(`interactive after ${median(starts).toFixed(0)} ms (${runs} starts)`);
console.log(
    `a frame while dragging 4096 points: ${computed.toFixed(1)} ms of computing, ` +
        `${at(0.5)} ms from frame to frame (median), ${at(0.95)} ms (95 %); 60 a second are 16.7 ms`,
);
