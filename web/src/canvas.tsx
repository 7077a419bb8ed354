// SPDX-License-Identifier: Apache-2.0

import type {JSX} from "preact";
import {useLayoutEffect, useRef} from "preact/hooks";
import {palette, useTheme, type Palette} from "./theme";

/** Draws on an area of width times height CSS pixels. */
export type Draw = (
    context: CanvasRenderingContext2D,
    width: number,
    height: number,
    colors: Palette,
) => void;

interface Props extends Omit<JSX.HTMLAttributes<HTMLCanvasElement>, "ref" | "label"> {
    /** What the picture shows, for who cannot see it. */
    label: string;
    draw: Draw;
}

/** A picture as wide as its place and as sharp as the screen, drawn at most once a frame. */
export function Canvas({label, draw, ...attributes}: Props) {
    useTheme();
    const element = useRef<HTMLCanvasElement>(null);
    const latest = useRef(draw);
    const frame = useRef(0);
    latest.current = draw;

    function paint(): void {
        frame.current = 0;
        const canvas = element.current!;
        const {width, height} = canvas.getBoundingClientRect();
        if (width === 0) return;
        const scale = devicePixelRatio;
        if (canvas.width !== Math.round(width * scale)) {
            canvas.width = Math.round(width * scale);
            canvas.height = Math.round(height * scale);
        }
        const context = canvas.getContext("2d")!;
        context.setTransform(scale, 0, 0, scale, 0, 0);
        context.clearRect(0, 0, width, height);
        latest.current(context, width, height, palette());
    }
    function schedule(): void {
        if (frame.current === 0) frame.current = requestAnimationFrame(paint);
    }

    useLayoutEffect(schedule);
    // Not after the next frame: a picture that is taken away before it must not be drawn in it.
    useLayoutEffect(() => {
        const observer = new ResizeObserver(schedule);
        observer.observe(element.current!);
        return () => {
            observer.disconnect();
            cancelAnimationFrame(frame.current);
        };
    }, []);
    return <canvas ref={element} role="img" aria-label={label} {...attributes} />;
}
