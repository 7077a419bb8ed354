// SPDX-License-Identifier: Apache-2.0
//
// Points of the unit square over their strata, with labelled axes, and their projections along these.

import {colorOf, type Palette} from "../theme";
import type {Shape} from "./strata";

export interface Scatter {
    u: Float32Array;
    v: Float32Array;
    uName: string;
    vName: string;
    shape?: Shape;
    /** The number of points in each stratum of `shape`. */
    counts?: Uint16Array;
    groups?: Groups;
    /** A point that is drawn larger. */
    marked?: number | undefined;
}

/** Points that have one color: each has a group below `count`. */
export interface Groups {
    of: Uint8Array;
    count: number;
}

/** The square within a canvas, in CSS pixels: what is left of it, and above. */
export const margin = {left: 48, right: 10, top: 8};
const below = 42; // room for the names of an axis

/** The side of the square on a canvas of this width. */
export const sideOf = (width: number) => width - margin.left - margin.right;

export function drawScatter(
    context: CanvasRenderingContext2D,
    width: number,
    colors: Palette,
    scatter: Scatter,
): void {
    const side = sideOf(width);
    context.save();
    context.translate(margin.left, margin.top);
    if (scatter.shape && scatter.counts) {
        drawStrata(context, side, colors, scatter.shape, scatter.counts, scatter.u.length);
    }
    drawAxes(context, side, colors, scatter.uName, scatter.vName, ["0", "¼", "½", "¾", "1"]);
    drawProjections(context, side, colors, scatter);
    const x = scatter.u.map(u => u * side);
    const y = scatter.v.map(v => (1 - v) * side);
    drawPoints(context, x, y, pointRadius(side, x.length), colors.ink, scatter.groups);
    if (scatter.marked !== undefined && scatter.marked < x.length) {
        drawMark(context, x[scatter.marked]!, y[scatter.marked]!, colors);
    }
    context.restore();
}

/** The point within reach of (x, y) on a canvas of this width, or undefined. */
export function nearestPoint(
    {u, v}: Scatter,
    width: number,
    x: number,
    y: number,
): number | undefined {
    const side = sideOf(width);
    let nearest: number | undefined;
    let least = 16 ** 2;
    for (let i = 0; i < u.length; ++i) {
        const dx = margin.left + u[i]! * side - x;
        const dy = margin.top + (1 - v[i]!) * side - y;
        const square = dx * dx + dy * dy;
        if (square < least) {
            least = square;
            nearest = i;
        }
    }
    return nearest;
}

/** Of points that are drawn on a square, in CSS pixels. */
export function pointRadius(side: number, count: number): number {
    return Math.min(Math.max((0.2 * side) / Math.sqrt(count), 1.1), 4);
}

/** Disks; where there are many, small squares, one by one, which is several times as fast as a path. */
export function drawPoints(
    context: CanvasRenderingContext2D,
    x: Float32Array,
    y: Float32Array,
    radius: number,
    color: string,
    groups?: Groups,
): void {
    const count = groups?.count ?? 1;
    for (let group = 0; group < count; ++group) {
        context.fillStyle = count > 1 ? colorOf(group, count) : color;
        context.beginPath();
        for (let i = 0; i < x.length; ++i) {
            if (groups && groups.of[i] !== group) continue;
            if (radius < 1.8) {
                context.fillRect(x[i]! - radius, y[i]! - radius, 2 * radius, 2 * radius);
            } else {
                context.moveTo(x[i]! + radius, y[i]!);
                context.arc(x[i]!, y[i]!, radius, 0, 2 * Math.PI);
            }
        }
        context.fill();
    }
}

export function drawMark(
    context: CanvasRenderingContext2D,
    x: number,
    y: number,
    colors: Palette,
): void {
    context.beginPath();
    context.arc(x, y, 8, 0, 2 * Math.PI);
    context.strokeStyle = colors.accent;
    context.lineWidth = 2.5;
    context.stroke();
}

/** Lines between strata, where there is room, and shades for those with none or several points. */
function drawStrata(
    context: CanvasRenderingContext2D,
    side: number,
    colors: Palette,
    {columns, rows}: Shape,
    counts: Uint16Array,
    points: number,
): void {
    const width = side / columns;
    const height = side / rows;
    const full = points >= columns * rows;
    for (let row = 0; row < rows; ++row) {
        for (let column = 0; column < columns; ++column) {
            const count = counts[row * columns + column]!;
            if (count === 1 || (count === 0 && !full)) continue;
            context.fillStyle = count > 1 ? colors.crowded : colors.empty;
            context.fillRect(column * width, side - (row + 1) * height, width, height);
        }
    }
    const lines = new Path2D();
    for (let column = 1; column < columns && width >= 4; ++column) {
        lines.moveTo(column * width, 0);
        lines.lineTo(column * width, side);
    }
    for (let row = 1; row < rows && height >= 4; ++row) {
        lines.moveTo(0, row * height);
        lines.lineTo(side, row * height);
    }
    context.strokeStyle = colors.line;
    context.lineWidth = 1;
    context.stroke(lines);
}

/** A frame of the square, with marks at equal distances along both axes. */
export function drawAxes(
    context: CanvasRenderingContext2D,
    side: number,
    colors: Palette,
    uName: string,
    vName: string,
    marks: readonly string[],
): void {
    context.strokeStyle = colors.muted;
    context.lineWidth = 1;
    context.strokeRect(0, 0, side, side);
    context.fillStyle = colors.ink;
    context.font = "12px system-ui, sans-serif";
    marks.forEach((mark, i) => {
        const at = (i * side) / (marks.length - 1);
        context.textAlign = "center";
        context.textBaseline = "top";
        context.fillText(mark, at, side + 10);
        context.textAlign = "right";
        context.textBaseline = "middle";
        context.fillText(mark, -10, side - at);
    });
    context.font = "13px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "bottom";
    context.fillText(uName, side / 2, side + below - 1);
    context.save();
    context.translate(-margin.left + 1, side / 2);
    context.rotate(-Math.PI / 2);
    context.textBaseline = "top";
    context.fillText(vName, 0, 0);
    context.restore();
}

/** A tick for each point beside the axes: where its coordinates are alone. */
function drawProjections(
    context: CanvasRenderingContext2D,
    side: number,
    colors: Palette,
    {u, v}: Scatter,
): void {
    const across = new Set(u.map(value => Math.floor(value * side)));
    const up = new Set(v.map(value => Math.floor((1 - value) * side)));
    context.fillStyle = colors.muted;
    for (const at of across) context.fillRect(at, side + 2, 1, 6);
    for (const at of up) context.fillRect(-8, at, 6, 1);
}
