// SPDX-License-Identifier: Apache-2.0
//
// Finds the WebAssembly module for this engine and starts it.

import { isA, shown } from "./arguments.js";

/** A module of one function that uses a vector instruction: i32x4.splat. */
const simdProbe = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 9, 1, 7, 0, 65, 0, 253, 17, 26, 11,
]);

/** Whether this engine has vector instructions. */
export const hasSimd = () => WebAssembly.validate(simdProbe);

/** The bytes at an address. Those of files are read, which `fetch` of Node.js does not. */
async function bytesAt(url) {
  if (url.protocol === "file:" && globalThis.process?.versions?.node !== undefined) {
    const name = "node:fs/promises"; // a variable, or bundlers for browsers look for it and fail
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ name);
    return readFile(url);
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url} cannot be loaded: ${response.status}`);
  return response.arrayBuffer();
}

/** The module at an address. Servers give pages of their own for what they do not have. */
async function moduleAt(url) {
  const bytes = new Uint8Array(await bytesAt(url));
  if (String.fromCharCode(...bytes.subarray(0, 4)) !== "\0asm") {
    throw new Error(`there is no WebAssembly module at ${url}`);
  }
  return bytes;
}

/** The exports of the started module. `wasm` is what to start instead of the package's own. */
export async function start(simd, wasm) {
  // Written out, so that bundlers see which files the package has.
  const own = simd
    ? new URL("../wellstrat-simd.wasm", import.meta.url)
    : new URL("../wellstrat.wasm", import.meta.url);
  const source = wasm ?? own;
  let bytes = source;
  if (typeof source === "string" || isA(URL, source)) {
    bytes = await moduleAt(new URL(source, globalThis.document?.baseURI ?? import.meta.url));
  } else if (!ArrayBuffer.isView(source) && !isA(ArrayBuffer, source)) {
    throw new TypeError(`wasm must be a URL, a string or the bytes of a module, not ${shown(source)}`);
  }
  const { instance } = await WebAssembly.instantiate(bytes, {
    env: { emscripten_notify_memory_growth() {} },
  });
  instance.exports._initialize();
  return instance.exports;
}
