// SPDX-License-Identifier: Apache-2.0
//
// The light along one ray from a scene, on the processor; radiance.wgsl and radiance.glsl do the same
// with the same names. Numbers instead of vectors, since an object for each would be slow.

/** A point of the unit square. */
export interface Xi {
    x: number;
    y: number;
}

const offset = 1e-3; // off a surface, so that rays do not hit it again

/** The square to a disk of radius 1, concentric squares to rings (Shirley and Chiu 1997). */
function squareToDisk({x, y}: Xi): [number, number] {
    const a = 2 * x - 1;
    const b = 2 * y - 1;
    if (a === 0 && b === 0) return [0, 0];
    const wide = Math.abs(a) > Math.abs(b);
    const radius = wide ? a : b;
    const angle = wide ? (Math.PI / 4) * (b / a) : Math.PI / 2 - (Math.PI / 4) * (a / b);
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
}

/** The distance to a sphere along a ray whose direction has length 1. */
function sphereDistance(
    s: Float32Array,
    at: number,
    [ox, oy, oz]: readonly number[],
    [dx, dy, dz]: readonly number[],
): number {
    const cx = s[at]! - ox!;
    const cy = s[at + 1]! - oy!;
    const cz = s[at + 2]! - oz!;
    const radius = s[at + 3]!;
    const along = cx * dx! + cy * dy! + cz * dz!;
    const square = along * along - (cx * cx + cy * cy + cz * cz) + radius * radius;
    return along < 0 || square < 0 ? Infinity : along - Math.sqrt(square);
}

/**
 * Adds to sums[at], [at + 1] and [at + 2] what arrives through point `image` of the picture, [0, 1)
 * from left to right and from top to bottom, point `onLens` of the lens and from point `onLight`.
 */
export function addRadiance(
    s: Float32Array,
    image: Xi,
    onLens: Xi,
    onLight: Xi,
    sums: Float32Array,
    at: number,
): void {
    const [lensX, lensY] = squareToDisk(onLens);
    const spheres = s[15]!;
    const half = Math.hypot(s[4]!, s[5]!, s[6]!);
    const origin = [0, 0, 0];
    const direction = [0, 0, 0];
    for (let k = 0; k < 3; ++k) {
        const right = s[4 + k]!;
        const down = s[8 + k]!;
        const aim = s[12 + k]! + right * (2 * image.x - 1) + down * (2 * image.y - 1);
        const shift = (s[3]! / half) * (right * lensX + down * lensY);
        origin[k] = s[k]! + shift;
        direction[k] = s[7]! * aim - shift;
    }
    const length = Math.hypot(direction[0]!, direction[1]!, direction[2]!);
    for (let k = 0; k < 3; ++k) direction[k]! /= length;

    let distance = direction[1]! < 0 ? -origin[1]! / direction[1]! : Infinity;
    let hit = -1;
    for (let i = 0; i < spheres; ++i) {
        const other = sphereDistance(s, 28 + 8 * i, origin, direction);
        if (other < distance) {
            distance = other;
            hit = 28 + 8 * i;
        }
    }
    if (distance === Infinity) {
        const t = Math.max(direction[1]!, 0);
        sums[at]! += 0.3 - 0.2 * t;
        sums[at + 1]! += 0.35 - 0.2 * t;
        sums[at + 2]! += 0.42 - 0.16 * t;
        return;
    }

    const position = [0, 0, 0];
    const normal = [0, 1, 0];
    for (let k = 0; k < 3; ++k) {
        position[k] = origin[k]! + direction[k]! * distance;
        if (hit >= 0) normal[k] = (position[k]! - s[hit + k]!) / s[hit + 3]!;
    }
    let red = 0.6;
    let green = 0.6;
    let blue = 0.58;
    if (hit >= 0) {
        red = s[hit + 4]!;
        green = s[hit + 5]!;
        blue = s[hit + 6]!;
    } else if (s[27]! !== 0) {
        const odd = (Math.floor(position[0]!) + Math.floor(position[2]!)) & 1;
        if (odd) red = green = blue = 0.22;
    }

    const toLight = [0, 0, 0];
    for (let k = 0; k < 3; ++k) {
        position[k]! += offset * normal[k]!;
        const onSource = s[16 + k]! + s[20 + k]! * onLight.x + s[24 + k]! * onLight.y;
        toLight[k] = onSource - position[k]!;
    }
    const range = Math.hypot(toLight[0]!, toLight[1]!, toLight[2]!);
    for (let k = 0; k < 3; ++k) toLight[k]! /= range;
    const cosSurface =
        normal[0]! * toLight[0]! + normal[1]! * toLight[1]! + normal[2]! * toLight[2]!;
    const cosLight = toLight[1]!;
    let light = s[23]! * (0.6 + 0.4 * normal[1]!);
    if (cosSurface > 0 && cosLight > 0) {
        let blocked = false;
        for (let i = 0; i < spheres && !blocked; ++i) {
            blocked = sphereDistance(s, 28 + 8 * i, position, toLight) < range;
        }
        if (!blocked) light += (s[19]! * cosSurface * cosLight) / (Math.PI * range * range);
    }
    sums[at]! += red * light;
    sums[at + 1]! += green * light;
    sums[at + 2]! += blue * light;
}
