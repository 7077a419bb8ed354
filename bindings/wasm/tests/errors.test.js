// SPDX-License-Identifier: Apache-2.0
//
// What is wrong gets a typed error of one sentence, and nothing is written.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { OutOfMemoryError, load } from "wellstrat";

const library = await load();
const contexts = new Uint32Array(8);

for (const [call, type, message] of [
  [() => library.samples("7", 4), TypeError, 'pattern must be an integer, not "7"'],
  [() => library.samples(1.5, 4), TypeError, "pattern must be an integer, not 1.5"],
  [() => library.samples(-1, 4), RangeError, "pattern must be from 0 to 4294967295, not -1"],
  [() => library.samples(7, NaN), TypeError, "count must be an integer, not NaN"],
  [() => library.samples(7), TypeError, "count must be an integer, not undefined"],
  [() => library.samples(7, 4n), TypeError, "count must be an integer, not 4n"],
  [() => library.samples(7, 2 ** 33), RangeError,
    "count must be from 0 to 4294967296, not 8589934592"],
  [() => library.samples(7, 2, { first: 2 ** 32 - 1 }), RangeError,
    "first + count must be at most 2**32, the samples of a pattern, not 4294967297"],
  [() => library.samples(7, 4, { dims: 4 }), RangeError, "dims must be from 1 to 3, not 4"],
  [() => library.samples(7, 4, { generator: "joint" }), RangeError,
    'generator must be one of "pmj", "long", "blue", "random", not "joint"'],
  [() => library.samples(7, 4, { generator: 0 }), RangeError,
    'generator must be one of "pmj", "long", "blue", "random", not 0'],
  [() => library.samples(7, 4, { dim: 2 }), TypeError,
    'there is no option "dim"; there are first, dims, generator, out'],
  [() => library.samples(7, 4, 2), TypeError, "options must be an object, not 2"],
  [() => library.samples(7, 4, null), TypeError, "options must be an object, not null"],
  [() => library.samples(7, 4, { out: [] }), TypeError, "out must be a Float32Array, not Array"],
  [() => library.samples(7, 4, { out: new Float64Array(8) }), TypeError,
    "out must be a Float32Array, not Float64Array"],
  [() => library.samples(7, 4, { out: new Float32Array(9) }), RangeError,
    "out must have 8 elements, not 9"],
  [() => library.words(7, 4, { generator: "pmj" }), RangeError,
    'generator must be one of "long", "blue", "random", not "pmj"'],
  [() => library.draw([1, 2]), TypeError, "contexts must be a Uint32Array, not Array"],
  [() => library.draw(), TypeError, "contexts must be a Uint32Array, not undefined"],
  [() => library.draw(new Uint32Array(3)), RangeError,
    "contexts must be pairs of a patternid and a sampleid, not 3 numbers"],
  [() => library.draw(contexts, { slot: 16 }), RangeError, "slot must be from 0 to 15, not 16"],
  [() => library.draw(contexts, { slot: NaN }), TypeError, "slot must be an integer, not NaN"],
  [() => library.draw(contexts, { slot: 1, splits: 257 }), RangeError,
    "splits must be from 1 to 256, not 257"],
  [() => library.cameraContexts(65537, 1), RangeError, "width must be from 0 to 65536, not 65537"],
  [() => library.cameraContexts(1, 1, -1), RangeError, "frame must be from 0 to 4294967295, not -1"],
  [() => library.blueContexts(1, 1, 0, 0, { seed: 1 }), TypeError,
    'there is no option "seed"; there are origin, out'],
  [() => library.cameraContexts(1, 1, 0, 0, { origin: 3 }), TypeError,
    "origin must be an array of two integers"],
  [() => library.deviceTables("2D"), RangeError,
    'draws must be one of "computed", "draws2D", "all", not "2D"'],
  [() => library.newDomain(contexts, 2 ** 32), RangeError,
    "scramble must be from 0 to 4294967295, not 4294967296"],
  [() => library.newDomainSplit(contexts, 1), TypeError,
    "newnumsamples must be an integer, not undefined"],
  [() => library.newDomainDistrib(contexts, 1, -1), RangeError,
    "newsampleid must be from 0 to 4294967295, not -1"],
  [() => library.newDomain(contexts, 1, { out: new Float32Array(8) }), TypeError,
    "out must be a Uint32Array, not Float32Array"],
  [() => library.jointScramble(16), RangeError, "slot must be from 0 to 15, not 16"],
  [() => library.hashToRandom(1, "2"), TypeError, 'b must be an integer, not "2"'],
]) {
  test(message, () => {
    assert.throws(call, (error) => {
      assert.equal(error.constructor, type);
      assert.equal(error.message, message);
      return true;
    });
  });
}

test("a call that fails has written nothing", () => {
  const out = new Float32Array(8).fill(-1);
  for (const wrong of [{ generator: "none" }, { dims: 3 }, { slot: -1 }, { splits: 0 }, { more: 1 }]) {
    assert.throws(() => library.draw(contexts, { out, ...wrong }));
  }
  assert.deepEqual(out, new Float32Array(8).fill(-1));
});

test("results that do not fit into memory", () => {
  assert.throws(() => library.samples(7, 2 ** 32, { dims: 3, generator: "long" }), (error) =>
    error instanceof OutOfMemoryError && error.name === "OutOfMemoryError" &&
    error.message === "12884901888 results do not fit into memory");
});

test("tables that do not fit into memory, until they do", async () => {
  const small = await load();
  const { grow } = WebAssembly.Memory.prototype;
  WebAssembly.Memory.prototype.grow = () => { throw new RangeError("no memory"); };
  try {
    const out = new Float32Array(8).fill(-1);
    for (const call of [() => small.samples(7, 4, { out }), () => small.buildTables(),
      () => small.draw(contexts, { slot: 1 })]) {
      assert.throws(call, (error) => error.constructor === OutOfMemoryError &&
        /^the tables of "pmj", 12 MiB, do not fit into memory/.test(error.message));
    }
    assert.deepEqual(out, new Float32Array(8).fill(-1));
    assert.deepEqual(small.samples(7, 4, { generator: "long" }),
      library.samples(7, 4, { generator: "long" }));
  } finally {
    WebAssembly.Memory.prototype.grow = grow;
  }
  assert.deepEqual(small.samples(7, 4), library.samples(7, 4));
});

test("an engine without vector instructions gets the plain module", async () => {
  const { validate } = WebAssembly;
  WebAssembly.validate = () => false;
  try {
    assert.equal((await load()).instructionSet, "scalar");
    await assert.rejects(load({ simd: true }),
      new RangeError("this engine has no vector instructions; simd must be false"));
  } finally {
    WebAssembly.validate = validate;
  }
  assert.equal(library.instructionSet, "simd128");
});

test("a module of one's own choice: bytes, an address, a file", async () => {
  const path = createRequire(import.meta.url).resolve("wellstrat/wellstrat.wasm");
  const url = pathToFileURL(path);
  const bytes = readFileSync(path);
  for (const wasm of [bytes, new Uint8Array(bytes).buffer, url, url.href]) {
    assert.equal((await load({ wasm })).instructionSet, "scalar");
  }
});

test("modules that are not there or are no modules", async () => {
  await assert.rejects(load({ wasm: new URL("file:///nowhere/wellstrat.wasm") }), /ENOENT/);
  for (const wasm of ["data:text/html,<p>", import.meta.url]) {
    await assert.rejects(load({ wasm }), new Error(`there is no WebAssembly module at ${wasm}`));
  }
  await assert.rejects(load({ wasm: new Uint8Array(5) }), WebAssembly.CompileError);
  await assert.rejects(load({ wasm: 5 }), new TypeError(
    "wasm must be a URL, a string or the bytes of a module, not 5"));
  await assert.rejects(load({ simd: 1 }), new TypeError("simd must be true or false, not 1"));
  await assert.rejects(load({ vectors: true }), TypeError);
});
