// SPDX-License-Identifier: Apache-2.0
//
// Renders on the processor, with samples from WebAssembly.

import type {Wellstrat} from "wellstrat";
import {addRadiance} from "./radiance";
import type {Request} from "./renderer";

/** What Renderer.render gives. */
export function renderOnProcessor(library: Wellstrat, request: Request): Float32Array {
    const {scene, size, source, seed} = request;
    const generator = source === "white" ? "random" : source === "joint" ? "pmj" : source;
    const slotted = source !== "white" && source !== "pmj";
    const drawSlot = (pixels: Uint32Array, slot: number) => {
        const domain = library.newDomain(pixels, library.jointScramble(slot), {generator});
        return library.draw(domain, {generator, dims: 2, ...(slotted ? {slot} : {})});
    };
    const sums = new Float32Array(4 * size * size);
    const [image, onLens, onLight] = [
        {x: 0, y: 0},
        {x: 0, y: 0},
        {x: 0, y: 0},
    ];
    for (let sample = request.first; sample < request.first + request.count; ++sample) {
        const pixels =
            generator === "blue"
                ? library.blueContexts(size, size, seed, sample)
                : library.cameraContexts(size, size, seed, sample);
        const [inPixel, lens, light] = [0, 1, 2].map(slot => drawSlot(pixels, slot));
        for (let y = 0, at = 0; y < size; ++y) {
            for (let x = 0; x < size; ++x, ++at) {
                image.x = (x + inPixel![2 * at]!) / size;
                image.y = (y + inPixel![2 * at + 1]!) / size;
                onLens.x = lens![2 * at]!;
                onLens.y = lens![2 * at + 1]!;
                onLight.x = light![2 * at]!;
                onLight.y = light![2 * at + 1]!;
                addRadiance(scene, image, onLens, onLight, sums, 4 * at);
            }
        }
    }
    return sums;
}
