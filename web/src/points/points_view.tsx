// SPDX-License-Identifier: Apache-2.0
//
// The first view: samples of one pattern in three dimensions.

import {useCallback, useMemo, useState} from "preact/hooks";
import type {Wellstrat} from "wellstrat";
import {maxCount, type View} from "../address";
import {Canvas} from "../canvas";
import {Choice, CountSlider, NumberField} from "../controls";
import {colorOf} from "../theme";
import {drawCube} from "./cube";
import {axes, groupsOf, pointsOf, type Points} from "./points";
import type {Groups} from "./scatter";
import {Readout} from "./readout";
import {ScatterPanel} from "./scatter_panel";
import {SequenceControls} from "./sequence_controls";
import {SpectrumPanel} from "./spectrum_panel";
import {countInStrata, filledStrata, strataDigits, strataShape} from "./strata";

export interface ViewProps {
    library: Wellstrat;
    view: View;
    change(part: Partial<View>): void;
}

function ColorKey({groups, digits, name}: {groups: Groups; digits: number; name: string}) {
    if (groups.count === 1) return null;
    return (
        <ul class="keys" aria-label={`First digits of ${name}`}>
            {Array.from({length: groups.count}, (_, i) => (
                <li key={i}>
                    <i class="square" style={{background: colorOf(i, groups.count)}} />
                    {i.toString(2).padStart(digits, "0")}
                </li>
            ))}
        </ul>
    );
}

export function PointsView({library, view, change}: ViewProps) {
    const {generator, pattern, first, count, strata, color, digits} = view;
    const [marked, setMarked] = useState<number>();
    const [turn, setTurn] = useState(-0.5);
    const points = useMemo(
        () => pointsOf(library, view, pattern),
        [library, generator, pattern, first, count],
    );
    const ofPattern = useCallback(
        (i: number) => (i === 0 ? points : pointsOf(library, view, (pattern + i) % 2 ** 32)),
        [points],
    );
    const groups = useMemo(() => groupsOf(view, points), [points, color, digits]);
    const shape =
        strata === "none"
            ? undefined
            : strataShape(count, strata === "square" ? strata : Number(strata));
    const possible = 2 ** strataDigits(count);
    const alone = axes.map(axis =>
        filledStrata(countInStrata(points[axis], points[axis], {columns: possible, rows: 1})),
    );

    function projection(across: keyof Points, up: keyof Points) {
        const [u, v] = [points[across], points[up]];
        const counts = shape && countInStrata(u, v, shape);
        const scatter = {u, v, uName: across, vName: up, shape, counts, groups, marked};
        return (
            <ScatterPanel title={`${across} and ${up}`} scatter={scatter} onMark={setMarked}>
                {shape && counts && (
                    <>
                        {filledStrata(counts)} of {possible} strata, {shape.columns} × {shape.rows},
                        have a sample.
                    </>
                )}
            </ScatterPanel>
        );
    }

    return (
        <div class="layout">
            <div class="controls">
                <CountSlider
                    label="Samples"
                    value={count}
                    high={maxCount}
                    onChange={value => change({count: value})}
                />
                <SequenceControls pattern="Pattern" view={view} change={change} />
                <Choice
                    label="Colors"
                    value={color}
                    options={[
                        ["one", "One color"],
                        ["order", "Digits of the order"],
                        ["x", "Digits of x"],
                        ["y", "Digits of y"],
                        ["z", "Digits of z"],
                    ]}
                    onChange={value => change({color: value})}
                />
                {color !== "one" && (
                    <Choice
                        label="First binary digits"
                        value={String(digits) as "1" | "2" | "3" | "4"}
                        options={[
                            ["1", "1"],
                            ["2", "2"],
                            ["3", "3"],
                            ["4", "4"],
                        ]}
                        onChange={value => change({digits: Number(value)})}
                    />
                )}
                <NumberField
                    label="Marked sample"
                    value={first + Math.min(marked ?? 0, count - 1)}
                    low={first}
                    high={first + count - 1}
                    onChange={value => setMarked(value - first)}
                />
            </div>
            <div>
                <ColorKey groups={groups} digits={digits} name={color} />
                <div class="panels">
                    {projection("x", "y")}
                    {projection("x", "z")}
                    {projection("z", "y")}
                    <figure>
                        <h2>All three</h2>
                        <Canvas
                            label={`${count} points in the unit cube; left and right turn it`}
                            class="turns"
                            tabIndex={0}
                            draw={(context, width, height, colors) =>
                                drawCube(context, width, height, colors, {
                                    ...points,
                                    groups,
                                    turn,
                                    marked,
                                })
                            }
                            onPointerDown={event =>
                                event.currentTarget.setPointerCapture(event.pointerId)
                            }
                            onPointerMove={event => {
                                const {movementX, buttons} = event;
                                if (buttons) setTurn(angle => angle - movementX / 100);
                            }}
                            onKeyDown={({key}) => {
                                if (key === "ArrowLeft") setTurn(angle => angle + 0.1);
                                if (key === "ArrowRight") setTurn(angle => angle - 0.1);
                            }}
                        />
                        <figcaption>
                            Alone, x, y and z fill {alone.join(", ")} of {possible} intervals. Drag
                            to turn.
                        </figcaption>
                    </figure>
                    <SpectrumPanel points={ofPattern} />
                </div>
                {marked !== undefined && marked < count && (
                    <Readout
                        sample={first + marked}
                        coordinates={axes.map(axis => [axis, points[axis][marked]!])}
                    />
                )}
            </div>
        </div>
    );
}
