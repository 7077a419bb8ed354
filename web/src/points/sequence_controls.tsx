// SPDX-License-Identifier: Apache-2.0
//
// What is drawn, and over which strata: controls that views of points have in common.

import {maxFirst, maxPattern} from "../address";
import {Choice, NumberField} from "../controls";
import {generators, strataChoices} from "./generators";
import type {ViewProps} from "./points_view";
import {strataDigits} from "./strata";

interface Props extends Pick<ViewProps, "view" | "change"> {
    pattern: string; // what the pattern is called
}

export function SequenceControls({pattern: label, view, change}: Props) {
    const {count, first, generator, pattern, strata} = view;
    return (
        <>
            <Choice
                label="Generator"
                value={generator}
                options={generators}
                onChange={value => change({generator: value})}
            />
            <NumberField
                label={label}
                value={pattern}
                low={0}
                high={maxPattern}
                onChange={value => change({pattern: value})}
            />
            <NumberField
                label="First sample"
                value={first}
                low={0}
                high={maxFirst}
                onChange={value => change({first: value})}
            />
            <Choice
                label="Strata"
                value={strata}
                options={strataChoices.filter(
                    ([name]) => !(Number(name) > strataDigits(count)) || name === strata,
                )}
                onChange={value => change({strata: value})}
            />
        </>
    );
}
