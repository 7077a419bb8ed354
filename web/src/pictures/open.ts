// SPDX-License-Identifier: Apache-2.0
//
// Opens the best way to render that there is.

import {OutOfMemoryError, type Wellstrat} from "wellstrat";
import {Unavailable, type Renderer} from "./renderer";
import {openOnPage, openWorker} from "./webassembly";
import {openWebGl2} from "./webgl2";
import {openWebGpu} from "./webgpu";

/** From the best to the one that is always there. */
const ways = ["webgpu", "webgl2", "wasm", "page"] as const;
export type Way = (typeof ways)[number];

/** An open renderer, and a sentence for each better way that is not there. */
export interface Opened {
    renderer: Renderer;
    way: Way;
    complaints: string[];
}

/** What to open when a device is lost. */
export function nextWay(way: Way): Way {
    return ways[ways.indexOf(way) + 1] ?? "page";
}

/** What 2D draws look up. Throws Unavailable where it does not fit. */
function tablesOf(library: Wellstrat): Uint32Array {
    try {
        return library.deviceTables("draws2D");
    } catch (error) {
        if (!(error instanceof OutOfMemoryError)) throw error;
        throw new Unavailable("The tables for shaders do not fit into memory.");
    }
}

/**
 * Opens the first way that there is, from the wished one on. Devices that only pretend to be some, on
 * the processor, are slower than WebAssembly, and opened only by those who wish for them.
 */
export async function openRenderer(library: Wellstrat, wish: Way | "auto"): Promise<Opened> {
    const evenSlow = wish !== "auto";
    const open: Record<Way, () => Promise<Renderer>> = {
        webgpu: async () => openWebGpu(tablesOf(library), evenSlow),
        webgl2: async () => openWebGl2(tablesOf(library), evenSlow),
        wasm: openWorker,
        page: () => openOnPage(library),
    };
    const complaints: string[] = [];
    for (const way of ways.slice(evenSlow ? ways.indexOf(wish) : 0)) {
        try {
            return {renderer: await open[way](), way, complaints};
        } catch (error) {
            if (!(error instanceof Unavailable)) throw error;
            complaints.push(error.message);
        }
    }
    throw new Error("the page itself renders everywhere");
}
