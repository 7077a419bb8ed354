// SPDX-License-Identifier: Apache-2.0

import type {ComponentChildren} from "preact";
import {Canvas} from "../canvas";
import {drawScatter, nearestPoint, type Scatter} from "./scatter";

interface Props {
    title: string;
    scatter: Scatter;
    onMark(point: number | undefined): void;
    children?: ComponentChildren;
}

/** A scatter plot whose points can be touched. */
export function ScatterPanel({title, scatter, onMark, children}: Props) {
    return (
        <figure>
            <h2>{title}</h2>
            <Canvas
                label={`${scatter.u.length} points: ${scatter.uName} across, ${scatter.vName} up`}
                style={{aspectRatio: "350 / 350"}}
                draw={(context, width, _, colors) => drawScatter(context, width, colors, scatter)}
                onClick={event => {
                    const {width} = event.currentTarget.getBoundingClientRect();
                    onMark(nearestPoint(scatter, width, event.offsetX, event.offsetY));
                }}
            />
            <figcaption>{children}</figcaption>
        </figure>
    );
}
