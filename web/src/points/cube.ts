// SPDX-License-Identifier: Apache-2.0
//
// Points of the unit cube, seen from above and from a side that the reader chooses.

import type {Palette} from "../theme";
import {drawMark, drawPoints, pointRadius, type Groups} from "./scatter";

export interface Cube {
    x: Float32Array;
    y: Float32Array;
    z: Float32Array;
    groups: Groups;
    /** How far it is turned about its z axis, in radians. */
    turn: number;
    marked: number | undefined;
}

const tilt = 0.42; // radians, from the side

export function drawCube(
    context: CanvasRenderingContext2D,
    width: number,
    height: number,
    colors: Palette,
    {x, y, z, groups, turn, marked}: Cube,
): void {
    const scale = 0.56 * width;
    const [sin, cos] = [Math.sin(turn), Math.cos(turn)];
    const across = (px: number, py: number) => (cos * (px - 0.5) - sin * (py - 0.5)) * scale;
    const down = (px: number, py: number, pz: number) =>
        -((sin * (px - 0.5) + cos * (py - 0.5)) * Math.sin(tilt) + (pz - 0.5) * Math.cos(tilt)) *
        scale;
    context.save();
    context.translate(width / 2, height / 2);
    context.strokeStyle = colors.muted;
    context.lineWidth = 1;
    context.fillStyle = colors.ink;
    context.font = "13px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "middle";

    const edge = (from: readonly number[], to: readonly number[]) => {
        context.moveTo(across(from[0]!, from[1]!), down(from[0]!, from[1]!, from[2]!));
        context.lineTo(across(to[0]!, to[1]!), down(to[0]!, to[1]!, to[2]!));
    };
    context.beginPath();
    for (const a of [0, 1]) {
        for (const b of [0, 1]) {
            edge([0, a, b], [1, a, b]);
            edge([a, 0, b], [a, 1, b]);
            edge([a, b, 0], [a, b, 1]);
        }
    }
    context.stroke();
    for (const [name, px, py, pz] of [
        ["x", 0.5, -0.12, -0.04],
        ["y", -0.12, 0.5, -0.04],
        ["z", -0.08, -0.08, 0.5],
    ] as const) {
        context.fillText(name, across(px, py), down(px, py, pz));
    }

    const u = x.map((px, i) => across(px, y[i]!));
    const v = x.map((px, i) => down(px, y[i]!, z[i]!));
    drawPoints(context, u, v, pointRadius(scale, u.length), colors.ink, groups);
    if (marked !== undefined && marked < u.length) {
        drawMark(context, u[marked]!, v[marked]!, colors);
    }
    context.restore();
}
