// SPDX-License-Identifier: Apache-2.0
//
// Renders on the processor: in a worker, or, where the page may have none, between what the page does.

import type {Wellstrat} from "wellstrat";
import {renderOnProcessor} from "./processor";
import {DeviceLost, Unavailable, type Renderer, type Request} from "./renderer";
import RenderWorker from "./worker?worker&inline";

class WorkerRenderer implements Renderer {
    readonly name = "WebAssembly";

    constructor(private readonly worker: Worker) {}

    render(request: Request): Promise<Float32Array> {
        return new Promise((resolve, reject) => {
            this.worker.onmessage = ({data}: MessageEvent<Float32Array>) => resolve(data);
            this.worker.onerror = event => reject(new DeviceLost(event.message));
            this.worker.postMessage(request);
        });
    }

    close(): void {
        this.worker.terminate();
    }
}

class PageRenderer implements Renderer {
    readonly name = "WebAssembly, without a worker";

    constructor(private readonly library: Wellstrat) {}

    async render(request: Request): Promise<Float32Array> {
        await new Promise(resolve => setTimeout(resolve));
        return renderOnProcessor(this.library, request);
    }

    close(): void {}
}

const onePixel: Request = {
    scene: new Float32Array(4),
    size: 1,
    source: "white",
    first: 0,
    count: 0,
    seed: 0,
};

/** Throws Unavailable where the page may have no worker. */
export async function openWorker(): Promise<Renderer> {
    let renderer: Renderer | undefined;
    try {
        renderer = new WorkerRenderer(new RenderWorker());
        await renderer.render(onePixel); // blocked workers fail late
        return renderer;
    } catch {
        renderer?.close();
        throw new Unavailable("This browser lets the page have no worker.");
    }
}

export async function openOnPage(library: Wellstrat): Promise<Renderer> {
    return new PageRenderer(library);
}
