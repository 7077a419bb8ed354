// SPDX-License-Identifier: Apache-2.0

import {useEffect, useRef} from "preact/hooks";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import {palette, useTheme} from "./theme";

export interface Curve {
    name: string;
    color: string;
    dashed?: boolean;
}

interface Props {
    /** What the curves show, for who cannot see them. */
    label: string;
    xTitle: string;
    yTitle: string;
    /** Both axes by powers: of 2 along x, of 10 along y. */
    logarithmic?: boolean;
    yRange?: [number, number];
    curves: Curve[];
    /** x, then the values of each curve. */
    data: uPlot.AlignedData;
}

/** Curves over labelled axes. */
export function Plot(props: Props) {
    useTheme();
    const place = useRef<HTMLDivElement>(null);
    const plot = useRef<uPlot>();
    const colors = palette();
    const look = JSON.stringify([props.curves, props.label, colors]);

    useEffect(() => {
        const element = place.current!;
        const made = new uPlot(optionsOf(props, element), props.data, element);
        plot.current = made;
        const observer = new ResizeObserver(() => made.setSize(sizeOf(element)));
        observer.observe(element);
        return () => {
            observer.disconnect();
            made.destroy();
        };
    }, [look]);
    useEffect(() => plot.current?.setData(props.data), [props.data]);
    return <div class="plot" role="img" aria-label={props.label} ref={place} />;
}

function sizeOf(element: HTMLElement): {width: number; height: number} {
    const {width, height} = element.getBoundingClientRect();
    return {width: Math.floor(width), height: Math.floor(height)};
}

function optionsOf(props: Props, element: HTMLElement): uPlot.Options {
    const {ink, line} = palette();
    const axis = (title: string): uPlot.Axis => ({
        label: title,
        labelSize: 22,
        labelFont: "13px system-ui",
        font: "12px system-ui",
        stroke: ink,
        grid: {stroke: line, width: 1},
        ticks: {stroke: line, width: 1},
    });
    const log = props.logarithmic;
    return {
        ...sizeOf(element),
        scales: {
            x: log ? {time: false, distr: 3, log: 2} : {time: false},
            y: {
                ...(log ? {distr: 3, log: 10} : {}),
                ...(props.yRange ? {range: props.yRange} : {}),
            },
        },
        axes: [
            axis(props.xTitle),
            {...axis(props.yTitle), size: 62, values: (_, all) => all.map(shortNumber)},
        ],
        legend: {show: false},
        cursor: {show: false},
        series: [
            {},
            ...props.curves.map(({name, color, dashed}) => ({
                label: name,
                stroke: color,
                width: 2,
                points: {show: false},
                ...(dashed ? {dash: [6, 4]} : {}),
            })),
        ],
    };
}

function shortNumber(value: number | null): string {
    return value === null ? "" : String(Number(value.toPrecision(3)));
}
