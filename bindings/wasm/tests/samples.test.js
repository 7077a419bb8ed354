// SPDX-License-Identifier: Apache-2.0
//
// What golden values do not say: batches, arrays to fill, and that both modules agree on many.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { test } from "node:test";
import { load } from "wellstrat";

const library = await load();
const scalar = await load({ simd: false });
const generators = ["pmj", "long", "blue", "random"];

/** Contexts without any order, more than the module takes at a time. */
function someContexts(count) {
  const contexts = new Uint32Array(2 * count);
  for (let i = 0; i < contexts.length; ++i) contexts[i] = Math.imul(i + 1, 0x9e3779b1) >>> (i & 15);
  return contexts;
}

test("both modules draw the same bits", () => {
  const contexts = someContexts(10007);
  for (const generator of generators) {
    for (const dims of [1, 2, 3]) {
      for (const options of [{}, { slot: 3 }, { slot: 5, splits: 6 }]) {
        const all = { ...options, generator, dims };
        assert.deepEqual(library.draw(contexts, all), scalar.draw(contexts, all), JSON.stringify(all));
      }
    }
  }
});

test("both modules derive the same domains", () => {
  const contexts = someContexts(5003);
  for (const generator of ["pmj", "blue"]) {
    for (const [name, number] of [["newDomainSplit", 3], ["newDomainDistrib", 9]]) {
      assert.deepEqual(library[name](contexts, 12345, number, { generator }),
        scalar[name](contexts, 12345, number, { generator }));
    }
  }
});

test("a run is what its contexts draw, however it is cut", () => {
  const count = 9000;
  for (const generator of generators) {
    const contexts = new Uint32Array(2 * count);
    for (let i = 0; i < count; ++i) contexts.set([7, 100 + i], 2 * i);
    const run = library.samples(7, count, { first: 100, dims: 3, generator });
    assert.deepEqual(run, library.draw(contexts, { dims: 3, generator }));
    assert.deepEqual(run.subarray(3 * 5000),
      library.samples(7, count - 5000, { first: 5100, dims: 3, generator }));
  }
});

test("what shaders look up is what the tool writes", () => {
  const all = library.deviceTables();
  // sha256sum of the file of: wellstrat tables --layout device --export FILE
  assert.equal(createHash("sha256").update(all).digest("hex"),
    "56350909b49588231d6e8b8794def89bbc643b4da09e966f2764fc1ce80b8de1");
  assert.deepEqual(scalar.deviceTables("all"), all);
  for (const [draws, bytes] of [["computed", 70672], ["draws2D", 6362128]]) {
    assert.deepEqual(library.deviceTables(draws), all.slice(0, bytes / 4));
  }
});

test("samples are the upper bits of words", () => {
  for (const generator of generators.slice(1)) {
    for (const dims of [1, 2, 3]) {
      const words = library.words(3, 5000, { dims, generator });
      assert.deepEqual(library.samples(3, 5000, { dims, generator }),
        Float32Array.from(words, (word) => (word >>> 8) * 2 ** -24));
    }
  }
  assert.equal(library.words(3, 1, { dims: 1, generator: "random" })[0], library.hashToUnsigned(3, 0));
});

test("the last sample of a pattern, and none", () => {
  const last = { first: 2 ** 32 - 1, generator: "long" };
  assert.deepEqual(library.samples(1, 1, last),
    library.draw(new Uint32Array([1, 2 ** 32 - 1]), { generator: "long" }));
  assert.equal(library.samples(1, 0, { first: 2 ** 32 - 1 }).length, 0);
  assert.equal(library.draw(new Uint32Array(0)).length, 0);
  assert.equal(library.cameraContexts(0, 5).length, 0);
});

test("256 samples have one in each of 16 x 16 squares, columns and rows", () => {
  for (const generator of ["pmj", "long"]) {
    const xy = library.samples(11, 256, { generator });
    const squares = new Set(), columns = new Set(), rows = new Set();
    for (let i = 0; i < xy.length; i += 2) {
      const [x, y] = [xy[i], xy[i + 1]];
      squares.add(Math.floor(16 * x) * 16 + Math.floor(16 * y));
      columns.add(Math.floor(256 * x));
      rows.add(Math.floor(256 * y));
    }
    assert.deepEqual([squares.size, columns.size, rows.size], [256, 256, 256]);
  }
});

test("pictures wider than a batch, and parts of them", () => {
  for (const [whole, part] of [
    [library.cameraContexts(5000, 3, 2, 9, { seed: 4 }),
      library.cameraContexts(10, 2, 2, 9, { seed: 4, origin: [4990, 1] })],
    [library.blueContexts(5000, 3, 4, 9), library.blueContexts(10, 2, 4, 9, { origin: [4990, 1] })],
  ]) {
    assert.equal(whole.length, 2 * 5000 * 3);
    assert.deepEqual(part.subarray(0, 20), whole.subarray(2 * 9990, 2 * 10000));
    assert.deepEqual(part.subarray(20), whole.subarray(2 * 14990));
  }
});

test("out is filled and returned, and belongs to the caller", () => {
  const contexts = someContexts(6000);
  const expected = library.draw(contexts);
  const out = new Float32Array(12000);
  assert.equal(library.draw(contexts, { out }), out);
  assert.deepEqual(out, expected);
  library.samples(1, 4096, { generator: "blue" });
  assert.deepEqual(out, expected);
});

test("out may be the contexts, or share their memory", () => {
  const children = library.newDomain(someContexts(6000), 5);
  const inPlace = someContexts(6000);
  library.newDomain(inPlace, 5, { out: inPlace });
  assert.deepEqual(inPlace, children);

  const expected = library.draw(someContexts(6000), { dims: 3 });
  const shared = new ArrayBuffer(4 * 18000);
  const contexts = new Uint32Array(shared, 4 * 6000);
  contexts.set(someContexts(6000));
  assert.deepEqual(library.draw(contexts, { dims: 3, out: new Float32Array(shared) }), expected);
});

test("each load has its own memory", async () => {
  const other = await load();
  assert.deepEqual(other.samples(5, 10), library.samples(5, 10));
  assert.notEqual(other, library);
});
