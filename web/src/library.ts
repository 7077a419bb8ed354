// SPDX-License-Identifier: Apache-2.0
//
// The library, as WebAssembly that is part of this page's file: pages that are opened from a folder may
// not load others.

import {load, type Wellstrat} from "wellstrat";

export function loadLibrary(): Promise<Wellstrat> {
    return load();
}
