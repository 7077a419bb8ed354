// SPDX-License-Identifier: Apache-2.0
//
// Opens the best way to render that there is.

import type {Wellstrat} from "wellstrat";
import type {View} from "../address";
import {Unavailable, type Renderer} from "./renderer";
import {openOnPage, openWorker} from "./webassembly";
import {openWebGl2} from "./webgl2";
import {openWebGpu} from "./webgpu";

export type Way = Exclude<View["by"], "auto">;

/** An open renderer, and a sentence for each better way that is not there. */
export interface Opened {
    renderer: Renderer;
    way: Way;
    complaints: string[];
}

/**
 * Opens the first way that there is, from the wished one on. Devices that only pretend to be some, on
 * the processor, are slower than WebAssembly, and opened only by those who wish for them.
 */
export async function openRenderer(library: Wellstrat, wish: View["by"]): Promise<Opened> {
    const tables = () => library.deviceTables("draws2D");
    const all: [Way, () => Promise<Renderer>][] = [
        ["webgpu", () => openWebGpu(tables(), wish !== "auto")],
        ["webgl2", () => openWebGl2(tables(), wish !== "auto")],
        ["wasm", openWorker],
        ["wasm", () => openOnPage(library)],
    ];
    const from = Math.max(
        all.findIndex(([way]) => way === wish),
        0,
    );
    const complaints: string[] = [];
    for (const [way, open] of all.slice(from)) {
        try {
            return {renderer: await open(), way, complaints};
        } catch (error) {
            if (!(error instanceof Unavailable)) throw error;
            complaints.push(error.message);
        }
    }
    throw new Error("never: the page itself renders everywhere");
}
