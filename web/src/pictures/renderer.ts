// SPDX-License-Identifier: Apache-2.0
//
// What draws pictures, on a graphics device or not.

/** Where samples come from, by the numbers that shaders know. */
export const sources = ["white", "pmj", "joint", "long", "blue"] as const;
export type Source = (typeof sources)[number];

/** Some samples of every pixel of a picture of size times size pixels. */
export interface Request {
    scene: Float32Array;
    size: number;
    source: Source;
    /** The first sample, and how many from there on. */
    first: number;
    count: number;
    /** Pictures of different seeds are independent. */
    seed: number;
}

export interface Renderer {
    /** As the reader knows it. */
    readonly name: string;
    /**
     * The sums of the radiance of the samples: red, green, blue and a number without meaning for each
     * pixel, row by row from the top. Throws a DeviceLost once the device is.
     */
    render(request: Request): Promise<Float32Array>;
    close(): void;
}

export class DeviceLost extends Error {}

/** Why a way to render is not there; the message is a sentence. */
export class Unavailable extends Error {}
