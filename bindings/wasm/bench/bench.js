// SPDX-License-Identifier: Apache-2.0
//
// Nanoseconds of a sample by the package, in turn with the C++ library on SSE4 (the program
// batch_rounds, the first argument) and with npm's sobol. Prints medians, and medians of the ratios
// of what was measured one after the other.

import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { cpus } from "node:os";
import { createInterface } from "node:readline";
import sobol from "sobol";
import { load } from "wellstrat";

const points = 4096;
const rounds = 50;
const warming = 5; // rounds that are not measured
const repetitions = 41;

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];

/** The nanoseconds of one of the samples that draw() draws. The first calls, after another program ran,
 * only warm caches up; the other program does so itself. */
function time(draw) {
  for (let i = 0; i < warming; ++i) draw();
  const start = performance.now();
  for (let i = 0; i < rounds; ++i) draw();
  return ((performance.now() - start) * 1e6) / (rounds * points);
}

/** A module's own exports, without the arrays of JavaScript. */
async function exportsOf(name) {
  const bytes = readFileSync(new URL(`node_modules/wellstrat/${name}`, import.meta.url));
  const { instance } = await WebAssembly.instantiate(bytes, {
    env: { emscripten_notify_memory_growth() {} },
  });
  const module = instance.exports;
  module._initialize();
  module.memory.grow(Math.ceil(module.tableRoom() / 65536));
  module.buildTables();
  return module;
}

const native = spawn(process.argv[2], { stdio: ["pipe", "pipe", "inherit"] });
const lines = createInterface({ input: native.stdout })[Symbol.asyncIterator]();
async function nativeTime(generator, dims) {
  native.stdin.write(`${generator} ${dims} ${rounds}\n`);
  return Number((await lines.next()).value);
}

const library = await load();
const plain = await load({ simd: false });
const modules = { simd: await exportsOf("wellstrat-simd.wasm"), plain: await exportsOf("wellstrat.wasm") };
const generators = ["pmj", "long", "blue"];

/** What is measured of a generator and dims, by name. */
function ours(generator, dims) {
  const contexts = generator === "blue" ? library.blueContexts(64, 64) : library.cameraContexts(64, 64);
  const kind = generators.indexOf(generator);
  const out = new Float32Array(points * dims);
  for (const module of Object.values(modules)) {
    new Uint32Array(module.memory.buffer, module.contexts(), 2 * points).set(contexts);
  }
  return {
    module: () => modules.simd.draw(points, kind, dims, 16, 1),
    draw: () => library.draw(contexts, { generator, dims, out }),
    samples: () => library.samples(7, points, { generator, dims, out }),
    "plain module": () => modules.plain.draw(points, kind, dims, 16, 1),
    "plain draw": () => plain.draw(contexts, { generator, dims, out }),
  };
}

/** npm's sobol into an array, as ours. */
function rival(dims) {
  const sequence = new sobol.SobolSequenceGenerator(dims);
  const out = new Float32Array(points * dims);
  return () => {
    for (let i = 0; i < out.length; i += dims) {
      const point = sequence.nextVector();
      for (let k = 0; k < dims; ++k) out[i + k] = point[k];
    }
  };
}

const fixed = (value, digits, width) => value.toFixed(digits).padStart(width);
const names = Object.keys(ours("pmj", 2));
console.log(`${cpus()[0].model.trim()}, Node.js ${process.version}; ${points} samples, nanoseconds of one\n`);
console.log(`${"".padEnd(10)}${"SSE4".padStart(8)}${"sobol".padStart(8)}` +
  names.map((name) => name.padStart(14)).join("") +
  "module/SSE4".padStart(14) + "sobol/draw".padStart(12) + "sobol/samples".padStart(15));
for (const generator of generators) {
  for (const dims of [1, 2, 3]) {
    const measured = { ...ours(generator, dims), sobol: rival(dims) };
    const times = Object.fromEntries(["SSE4", ...Object.keys(measured)].map((name) => [name, []]));
    for (const draw of Object.values(measured)) time(draw); // compiled well
    for (let i = 0; i < repetitions; ++i) {
      times.SSE4.push(await nativeTime(generator, dims));
      for (const [name, draw] of Object.entries(measured)) times[name].push(time(draw));
    }
    const ratio = (a, b) => median(times[a].map((value, i) => value / times[b][i]));
    console.log(`${`${generator} ${dims}D`.padEnd(10)}${fixed(median(times.SSE4), 2, 8)}` +
      fixed(median(times.sobol), 1, 8) + names.map((name) => fixed(median(times[name]), 2, 14)).join("") +
      fixed(ratio("module", "SSE4"), 2, 14) + fixed(ratio("sobol", "draw"), 1, 12) +
      fixed(ratio("sobol", "samples"), 1, 15));
  }
}
native.stdin.end();
