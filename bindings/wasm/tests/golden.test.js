// SPDX-License-Identifier: Apache-2.0
//
// Both modules give the golden values of the library.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { load } from "wellstrat";
import { checkGolden } from "./golden.js";

const texts = ["samples", "joint", "long", "blue"].map((name) =>
  readFileSync(new URL(`../../../tests/golden/${name}.txt`, import.meta.url), "utf8"));

for (const simd of [true, false]) {
  test(`golden values ${simd ? "with" : "without"} vector instructions`, async () => {
    const library = await load({ simd });
    assert.equal(library.instructionSet, simd ? "simd128" : "scalar");
    const { agreed, faults } = checkGolden(library, texts);
    assert.deepEqual(faults, []);
    assert.ok(agreed > 4000, `only ${agreed} records`);
  });
}
