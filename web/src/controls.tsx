// SPDX-License-Identifier: Apache-2.0
//
// Controls are the browser's own, which keyboards, fingers and screen readers know, each with a label.

import type {ComponentChildren} from "preact";
import {useId, useState} from "preact/hooks";

interface ChoiceProps<T extends string> {
    label: string;
    value: T;
    options: readonly (readonly [T, string])[];
    onChange(value: T): void;
}

export function Choice<T extends string>({label, value, options, onChange}: ChoiceProps<T>) {
    const id = useId();
    return (
        <div class="control">
            <label for={id}>{label}</label>
            <select
                id={id}
                value={value}
                onChange={event => onChange(event.currentTarget.value as T)}
            >
                {options.map(([name, text]) => (
                    <option key={name} value={name}>
                        {text}
                    </option>
                ))}
            </select>
        </div>
    );
}

interface NumberProps {
    label: string;
    value: number;
    low: number;
    high: number;
    onChange(value: number): void;
    children?: ComponentChildren;
}

/** A whole number of [low, high]. What is not one stays in the field, marked, until it is left. */
export function NumberField({label, value, low, high, onChange, children}: NumberProps) {
    const id = useId();
    const [entry, setEntry] = useState<string>(); // while it is being made
    const text = entry ?? String(value);
    const accepts = (number: string) =>
        /^\d+$/.test(number) && Number(number) >= low && Number(number) <= high;
    return (
        <div class="control">
            <label for={id}>{label}</label>
            <div class="row">
                <input
                    id={id}
                    type="number"
                    inputMode="numeric"
                    min={low}
                    max={high}
                    value={text}
                    aria-invalid={!accepts(text)}
                    onInput={event => {
                        const number = event.currentTarget.value;
                        setEntry(number);
                        if (accepts(number)) onChange(Number(number));
                    }}
                    onBlur={() => setEntry(undefined)}
                />
                {children}
            </div>
            {!accepts(text) && (
                <p class="hint" role="status">
                    A whole number from {low} to {high}.
                </p>
            )}
        </div>
    );
}

/**
 * A number of [1, high] by a slider whose steps are factors, since 1 to 2 is as much as 2048 to 4096.
 * The arrow keys go by one; page up and down double and halve.
 */
export function CountSlider({label, value, high, onChange}: Omit<NumberProps, "low">) {
    const id = useId();
    const set = (count: number) => onChange(Math.min(Math.max(Math.round(count), 1), high));
    const keys: Record<string, () => number> = {
        ArrowRight: () => value + 1,
        ArrowUp: () => value + 1,
        ArrowLeft: () => value - 1,
        ArrowDown: () => value - 1,
        PageUp: () => 2 * value,
        PageDown: () => value / 2,
        Home: () => 1,
        End: () => high,
    };
    return (
        <div class="slider">
            <NumberField label={label} value={value} low={1} high={high} onChange={onChange}>
                <button type="button" onClick={() => set(Math.floor(value / 2))}>
                    <span aria-hidden="true">÷ 2</span>
                    <span class="unseen">Half as many</span>
                </button>
                <button type="button" onClick={() => set(2 * value)}>
                    <span aria-hidden="true">× 2</span>
                    <span class="unseen">Twice as many</span>
                </button>
            </NumberField>
            <input
                id={id}
                type="range"
                aria-label={`${label}, slider`}
                aria-valuetext={String(value)}
                min={0}
                max={Math.log2(high)}
                step="any"
                value={Math.log2(value)}
                onInput={event => set(2 ** Number(event.currentTarget.value))}
                onKeyDown={event => {
                    const next = keys[event.key];
                    if (!next) return;
                    event.preventDefault();
                    set(next());
                }}
            />
        </div>
    );
}
