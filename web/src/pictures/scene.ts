// SPDX-License-Identifier: Apache-2.0
//
// The scenes: spheres on a floor at y = 0 that is a plain or a checkerboard, a rectangular light that
// faces down, and a camera with a round lens. A lens or a light of no extent needs no samples.
// Renderers get a scene as sceneVectors vectors of four numbers, which radiance.ts, .wgsl and .glsl
// read in the same way:
//
//     0  eye, radius of the lens            4  corner of the light, its power
//     1  half of the picture's width, at    5  first edge of the light, light from everywhere
//        distance 1; distance in focus      6  second edge of the light, 1 for a checkerboard
//     2  the same of its height, downward   7 + 2 i  center of sphere i, its radius
//     3  forward, number of spheres         8 + 2 i  color of sphere i

export const maxSpheres = 8;
export const sceneVectors = 7 + 2 * maxSpheres;

type Vector = readonly [number, number, number];

interface Sphere {
    center: Vector;
    radius: number;
    color: Vector;
}

interface Scene {
    eye: Vector;
    target: Vector;
    halfWidth: number;
    lensRadius: number;
    focus: number;
    light: {corner: Vector; edgeU: Vector; edgeV: Vector; power: number};
    ambient: number;
    checkered: boolean;
    spheres: readonly Sphere[];
}

const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (a: Vector, s: number): Vector => [a[0] * s, a[1] * s, a[2] * s];
const cross = (a: Vector, b: Vector): Vector => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
];
const unit = (a: Vector): Vector => times(a, 1 / Math.hypot(...a));

function packed(scene: Scene): Float32Array {
    const forward = unit(minus(scene.target, scene.eye));
    const right = unit(cross(forward, [0, 1, 0]));
    const down = cross(forward, right);
    const {light, spheres} = scene;
    const vectors = [
        [...scene.eye, scene.lensRadius],
        [...times(right, scene.halfWidth), scene.focus],
        [...times(down, scene.halfWidth), 0],
        [...forward, spheres.length],
        [...light.corner, light.power],
        [...light.edgeU, scene.ambient],
        [...light.edgeV, scene.checkered ? 1 : 0],
        ...spheres.flatMap(({center, radius, color}) => [
            [...center, radius],
            [...color, 0],
        ]),
    ];
    const result = new Float32Array(4 * sceneVectors);
    result.set(vectors.flat());
    return result;
}

const still: Vector = [0, 0, 0];

const shadow: Scene = {
    eye: [0, 3, 4.4],
    target: [0.15, 0.42, 0.1],
    halfWidth: 0.29,
    lensRadius: 0,
    focus: 5,
    light: {corner: [-1.7, 2.8, -1.2], edgeU: [2, 0, 0], edgeV: [0, 0, 1.2], power: 17},
    ambient: 0.1,
    checkered: false,
    spheres: [{center: [0, 0.9, 0], radius: 0.6, color: [0.75, 0.36, 0.2]}],
};

const row: readonly Sphere[] = [
    {center: [-1.15, 0.5, 2.1], radius: 0.5, color: [0.2, 0.42, 0.7]},
    {center: [-0.55, 0.5, 0.8], radius: 0.5, color: [0.25, 0.6, 0.45]},
    {center: [0.15, 0.5, -0.5], radius: 0.5, color: [0.8, 0.6, 0.2]},
    {center: [1.0, 0.5, -1.9], radius: 0.5, color: [0.75, 0.36, 0.2]},
    {center: [2.0, 0.5, -3.4], radius: 0.5, color: [0.6, 0.3, 0.55]},
];

const lens: Scene = {
    eye: [-0.8, 2.6, 4.9],
    target: [0.12, 0.2, -0.1],
    halfWidth: 0.36,
    lensRadius: 0.3,
    focus: 5.1,
    light: {corner: [-2.5, 5, 2.5], edgeU: still, edgeV: still, power: 75},
    ambient: 0.22,
    checkered: true,
    spheres: row,
};

export const scenes = {
    shadow: packed(shadow),
    lens: packed(lens),
    both: packed({
        ...lens,
        light: {corner: [-3.5, 4, 0.5], edgeU: [2.4, 0, 0], edgeV: [0, 0, 2.4], power: 60},
    }),
};
