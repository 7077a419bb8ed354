// SPDX-License-Identifier: Apache-2.0
//
// What users write, by the types of the package; the compiler checks it. What it must refuse is
// marked.

import { OutOfMemoryError, load } from "wellstrat";
import type { DrawOptions, Generator, Wellstrat } from "wellstrat";

async function samples(): Promise<Float32Array> {
  const library: Wellstrat = await load({ simd: false });
  const generator: Generator = "blue";
  const options: DrawOptions = { dims: 3, generator, slot: 2 };
  const pixels: Uint32Array = library.blueContexts(4, 4, 1, 0, { origin: [1, 2] });
  const light = library.newDomain(pixels, library.jointScramble(2), { generator });
  const bits: Uint32Array = library.words(1, 16, { generator: "long", out: new Uint32Array(32) });
  try {
    library.buildTables();
  } catch (error) {
    if (!(error instanceof OutOfMemoryError)) throw error;
  }

  // @ts-expect-error
  library.samples("7", 4);
  // @ts-expect-error
  library.samples(7, 4, { dims: 4 });
  // @ts-expect-error
  library.words(7, 4, { generator: "pmj" });
  // @ts-expect-error
  library.draw([1, 2]);
  // @ts-expect-error
  library.draw(pixels, { generator: "joint" });
  // @ts-expect-error
  library.blueContexts(4, 4, 1, 0, { seed: 1 });
  // @ts-expect-error
  library.version = "2";
  return library.draw(light, { ...options, out: new Float32Array(48 + bits.length - 32) });
}

export const drawn: Promise<Float32Array> = load({ wasm: new Uint8Array(8) }).then(samples);
