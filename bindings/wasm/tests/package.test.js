// SPDX-License-Identifier: Apache-2.0
//
// What is in the package.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { createRequire } from "node:module";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { load } from "wellstrat";

const folder = dirname(createRequire(import.meta.url).resolve("wellstrat/package.json"));
const contentOf = (...path) => readFileSync(join(folder, ...path));
const scripts = readdirSync(join(folder, "src")).filter((name) => name.endsWith(".js"));

test("its files", () => {
  assert.deepEqual(readdirSync(folder).sort(), ["LICENSE", "README.md", "THIRD-PARTY.md",
    "package.json", "src", "wellstrat-simd.wasm", "wellstrat.wasm"]);
  assert.deepEqual(readdirSync(join(folder, "src")).sort(),
    ["arguments.js", "index.d.ts", "index.js", "module.js"]);
});

test("its version is the library's", async () => {
  assert.equal((await load()).version, JSON.parse(contentOf("package.json")).version);
});

test("a page loads at most 40 KB of either module and all scripts, each compressed by gzip -9", () => {
  const compressed = (content) => gzipSync(content, { level: 9 }).length;
  const shared = scripts.reduce((sum, name) => sum + compressed(contentOf("src", name)), 0);
  for (const name of ["wellstrat-simd.wasm", "wellstrat.wasm"]) {
    const size = shared + compressed(contentOf(name));
    assert.ok(size <= 40000, `${name} and scripts take ${size} bytes`);
  }
});

test("modules need nothing of the page but one function", async () => {
  for (const name of ["wellstrat-simd.wasm", "wellstrat.wasm"]) {
    const imports = WebAssembly.Module.imports(await WebAssembly.compile(contentOf(name)));
    assert.deepEqual(imports.map((found) => found.name), ["emscripten_notify_memory_growth"]);
  }
});

test("bundlers for browsers find no module of Node.js in it", () => {
  for (const name of scripts) {
    assert.doesNotMatch(String(contentOf("src", name)), /(import\s*\(?|from)\s*["']node:/, name);
  }
});

test("tables take little more than they say", async () => {
  const { instance } = await WebAssembly.instantiate(contentOf("wellstrat-simd.wasm"), {
    env: { emscripten_notify_memory_growth() { assert.fail("the module grew its memory"); } } });
  const { _initialize, memory, tableRoom, buildTables } = instance.exports;
  _initialize();
  assert.ok(memory.buffer.byteLength <= 2 ** 20);
  assert.ok(tableRoom() < 12.1 * 2 ** 20);
  memory.grow(Math.ceil(tableRoom() / 65536));
  buildTables();
});

/** What an example prints. */
const printedBy = (name) => execFileSync(process.execPath,
  [fileURLToPath(new URL(name, import.meta.url))], { encoding: "utf8" });

test("the first example prints what that in C++ prints", () => {
  const guide = readFileSync(new URL("../../../docs/javascript.md", import.meta.url), "utf8");
  const [, expected] = /<!-- output: quick_look -->\n```text\n(.*?)```/s.exec(guide);
  assert.equal(printedBy("quick_look.js"), expected);
});

test("the example of a lens", () => {
  const printed = printedBy("lens_error.js");
  const rows = printed.trim().split("\n").map((line) => line.trim().split(/\s+/));
  assert.deepEqual(rows[0], ["samples", "random", "pmj", "long", "blue"]);
  const last = rows.at(-1).map(Number);
  assert.equal(last[0], 4096);
  for (const error of last.slice(2)) assert.ok(error < last[1] / 5, printed);
});
