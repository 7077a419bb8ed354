// SPDX-License-Identifier: Apache-2.0
//
// The second view: the samples of two domains against each other.

import {useMemo, useState} from "preact/hooks";
import {maxCount} from "../address";
import {Choice, CountSlider} from "../controls";
import type {ViewProps} from "../points/points_view";
import {Readout} from "../points/readout";
import {ScatterPanel} from "../points/scatter_panel";
import {SequenceControls} from "../points/sequence_controls";
import {
    countInStrata,
    filledStrata,
    fullestStratum,
    strataDigits,
    strataShape,
} from "../points/strata";
import {areOne, domainPoints} from "./domains";

const slots: readonly (readonly [string, string])[] = [
    ["none", "Plain, no slot"],
    ...Array.from({length: 16}, (_, i) => [String(i), `Slot ${i}`] as const),
];

const pairs = [
    ["x", "x"],
    ["y", "x"],
    ["x", "y"],
    ["y", "y"],
] as const;

export function DomainsView({library, view, change}: ViewProps) {
    const {generator, pattern, first, count, strata, a, b} = view;
    const [marked, setMarked] = useState<number>();
    const domains = useMemo(
        () =>
            [true, false].map(slotted => ({
                a: domainPoints(library, view, "a", slotted),
                b: domainPoints(library, view, "b", slotted),
            })),
        [library, generator, pattern, first, count, a, b],
    );
    const [drawn, plain] = domains as [(typeof domains)[0], (typeof domains)[0]];
    const digits = strata === "square" || strata === "none" ? "square" : Number(strata);
    const shape = strataShape(count, digits);
    const possible = 2 ** strataDigits(count);
    const comparable = generator !== "random" && (a !== "none" || b !== "none") && !areOne(view);

    return (
        <div class="layout">
            <div class="controls">
                <CountSlider
                    label="Samples"
                    value={count}
                    high={maxCount}
                    onChange={value => change({count: value})}
                />
                <Choice
                    label="Domain A"
                    value={a}
                    options={slots}
                    onChange={value => change({a: value})}
                />
                <Choice
                    label="Domain B"
                    value={b}
                    options={slots}
                    onChange={value => change({b: value})}
                />
                <SequenceControls pattern="Pattern of the pixel" view={view} change={change} />
            </div>
            <div>
                <p>
                    Two domains of a path, such as the pixel and the light, each have samples of
                    their own. Slots are stratified together; plain domains are paired as at random.
                    {areOne(view) && " A and B are the same domain here: a mistake in a renderer."}
                    {generator === "random" && " Independent samples have no slots."}
                </p>
                <div class="panels">
                    {pairs.map(([across, up]) => {
                        const [u, v] = [drawn.a[across], drawn.b[up]];
                        const counts = countInStrata(u, v, shape);
                        const others = countInStrata(plain.a[across], plain.b[up], shape);
                        const scatter = {
                            u,
                            v,
                            uName: `${across} of A`,
                            vName: `${up} of B`,
                            ...(strata === "none" ? {} : {shape, counts}),
                            marked,
                        };
                        return (
                            <ScatterPanel
                                key={across + up}
                                title={`${across} of A and ${up} of B`}
                                scatter={scatter}
                                onMark={setMarked}
                            >
                                {filledStrata(counts)} of {possible} strata, {shape.columns} ×{" "}
                                {shape.rows}, have a sample; the fullest has{" "}
                                {fullestStratum(counts)}.
                                {comparable &&
                                    ` With plain domains, ${filledStrata(others)} have one, and` +
                                        ` the fullest has ${fullestStratum(others)}.`}
                            </ScatterPanel>
                        );
                    })}
                </div>
                {marked !== undefined && marked < count && (
                    <Readout
                        sample={first + marked}
                        coordinates={(["a", "b"] as const).flatMap(domain =>
                            (["x", "y"] as const).map(
                                axis =>
                                    [
                                        `${axis} of ${domain.toUpperCase()}`,
                                        drawn[domain][axis][marked]!,
                                    ] as const,
                            ),
                        )}
                    />
                )}
            </div>
        </div>
    );
}
