// SPDX-License-Identifier: Apache-2.0
//
// What the page shows, as the part of its address after "#": settings that differ from the default,
// such as "generator=blue&count=64". A value that is not accepted gives the default and a sentence.

/** How one setting is read. `read` returns undefined for what is not accepted. */
interface Field<T> {
    readonly initial: T;
    readonly accepted: string;
    read(text: string): T | undefined;
}

function choice<T extends string>(...values: readonly T[]): Field<T> {
    return {
        initial: values[0]!,
        accepted: `one of ${values.join(", ")}`,
        read: text => values.find(value => value === text),
    };
}

/** A whole number of [low, high]. */
function whole(initial: number, low: number, high: number): Field<number> {
    return {
        initial,
        accepted: `a whole number from ${low} to ${high}`,
        read(text) {
            const value = /^\d{1,10}$/.test(text) ? Number(text) : NaN;
            return value >= low && value <= high ? value : undefined;
        },
    };
}

const slot = (initial: string): Field<string> => ({
    initial,
    accepted: "none or a slot from 0 to 15",
    read: text => (/^(none|\d|1[0-5])$/.test(text) ? text : undefined),
});

export const maxCount = 4096;
export const maxPattern = 2 ** 32 - 1;
export const maxFirst = 2 ** 32 - maxCount;
export const maxPictureSamples = 1024;

const fields = {
    view: choice("points", "domains", "pictures"),
    generator: choice("pmj", "long", "blue", "random"),
    pattern: whole(7, 0, maxPattern),
    first: whole(0, 0, maxFirst),
    count: whole(256, 1, maxCount),
    strata: choice(
        "square",
        "none",
        "0",
        "1",
        "2",
        "3",
        "4",
        "5",
        "6",
        "7",
        "8",
        "9",
        "10",
        "11",
        "12",
    ),
    color: choice("one", "order", "x", "y", "z"),
    digits: whole(2, 1, 4),
    a: slot("0"),
    b: slot("1"),
    scene: choice("shadow", "lens", "both"),
    samples: whole(64, 1, maxPictureSamples),
    seed: whole(1, 0, maxPattern),
    filter: choice("2", "1", "4"),
    by: choice("auto", "webgpu", "webgl2", "wasm"),
};

type Fields = typeof fields;
export type View = {[K in keyof Fields]: Fields[K]["initial"]};

const names = Object.keys(fields) as (keyof View)[];

export const initialView = Object.fromEntries(
    names.map(name => [name, fields[name].initial]),
) as View;

/** The view of an address, "#..." or "", and a sentence for each part that was not accepted. */
export function readAddress(hash: string): {view: View; complaints: string[]} {
    const view: Record<string, string | number> = {...initialView};
    const complaints: string[] = [];
    for (const [name, text] of new URLSearchParams(hash.replace(/^#/, ""))) {
        if (!Object.hasOwn(fields, name)) {
            complaints.push(`The address has a setting “${name}”, which this page does not know.`);
            continue;
        }
        const field = fields[name as keyof View] as Field<string | number>;
        const value = field.read(text);
        if (value === undefined) {
            complaints.push(
                `The address says ${name}=${text}; it takes ${field.accepted}. Shown is ${field.initial}.`,
            );
        }
        view[name] = value ?? field.initial;
    }
    return {view: view as View, complaints};
}

/** The address of a view, without "#". */
export function writeAddress(view: View): string {
    const changed = names.filter(name => view[name] !== initialView[name]);
    return new URLSearchParams(changed.map(name => [name, String(view[name])])).toString();
}
