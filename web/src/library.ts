// SPDX-License-Identifier: Apache-2.0
//
// The library, as WebAssembly that is part of this page's file: pages that are opened from a folder may
// not load others.

import {load, OutOfMemoryError, type Wellstrat} from "wellstrat";

interface Loaded {
    library: Wellstrat;
    /** A sentence where something is missing. */
    complaint?: string;
}

/** A library without room for the tables, which draws `long` samples in their place. */
function withoutTables(library: Wellstrat): Wellstrat {
    const computed = (value: unknown) =>
        typeof value === "object" && (value as {generator?: string}).generator === "pmj"
            ? {...value, generator: "long"}
            : value;
    return new Proxy(library, {
        get(target, name) {
            const member = Reflect.get(target, name, target);
            if (typeof member !== "function") return member;
            return (...values: unknown[]) => member.apply(target, values.map(computed));
        },
    });
}

export async function loadLibrary(): Promise<Loaded> {
    const library = await load();
    try {
        library.buildTables();
        return {library};
    } catch (error) {
        if (!(error instanceof OutOfMemoryError)) throw error;
        const complaint = "The tables do not fit into memory. For pmj there are samples of long.";
        return {library: withoutTables(library), complaint};
    }
}
