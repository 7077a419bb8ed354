// SPDX-License-Identifier: Apache-2.0
//
// The package's interface; index.d.ts documents it.

import {
  OutOfMemoryError, choice, contextsOf, generatorOf, generators, integer, optionsOf, outputOf, shown, word,
  words,
} from "./arguments.js";
import { hasSimd, start } from "./module.js";

export { OutOfMemoryError };

const pageBytes = 65536;
const side = 65536; // of the largest picture

export async function load(options = {}) {
  const { simd = hasSimd(), wasm } = optionsOf(options, ["simd", "wasm"]);
  if (typeof simd !== "boolean") {
    throw new TypeError(`simd must be true or false, not ${shown(simd)}`);
  }
  if (simd && !hasSimd()) {
    throw new RangeError("this engine has no vector instructions; simd must be false");
  }
  return new Wellstrat(await start(simd, wasm));
}

/** A string of C's in memory. */
function textAt(memory, address) {
  const bytes = new Uint8Array(memory.buffer, address);
  return String.fromCharCode(...bytes.subarray(0, bytes.indexOf(0)));
}

class Wellstrat {
  #module;
  #batch;
  #hasTables = false;
  // Of the module's memory. They are made anew when that has grown.
  #contexts;
  #xis;
  #words;

  constructor(module) {
    this.#module = module;
    this.#batch = module.batch();
    this.#view();
    this.version = textAt(module.memory, module.version());
    this.streamVersion = module.streamVersion();
    this.instructionSet = module.simd() ? "simd128" : "scalar";
    Object.freeze(this);
  }

  #view() {
    const { memory, contexts, results } = this.#module;
    this.#contexts = new Uint32Array(memory.buffer, contexts(), 2 * this.#batch);
    this.#xis = new Float32Array(memory.buffer, results(), 3 * this.#batch);
    this.#words = new Uint32Array(memory.buffer, results(), 3 * this.#batch);
  }

  buildTables() {
    if (this.#hasTables) return;
    const { memory } = this.#module;
    try {
      memory.grow(Math.ceil(this.#module.tableRoom() / pageBytes));
    } catch {
      throw new OutOfMemoryError('the tables of "pmj", 12 MiB, do not fit into memory; ' +
        '"long" and "blue" need none');
    }
    this.#view();
    this.#module.buildTables();
    this.#hasTables = true;
  }

  deviceTables(draws = "all") {
    const kinds = ["computed", "draws2D", "all"]; // as DeviceDraws
    const kind = kinds.indexOf(choice(draws, "draws", kinds));
    const { memory, deviceTableBytes, deviceHead, tableWords } = this.#module;
    const head = deviceTableBytes(0) / 4;
    const out = outputOf(undefined, Uint32Array, deviceTableBytes(kind) / 4);
    if (kind > 0) {
      this.buildTables();
      out.set(new Uint32Array(memory.buffer, tableWords(), out.length - head), head);
    }
    out.set(new Uint32Array(memory.buffer, deviceHead(), head));
    return out;
  }

  /** Calls compute(n, i) for batches of n of `count` things, from thing i on, and copies the
   * results, `width` for each, into `out`. */
  #run(count, width, results, out, compute) {
    for (let i = 0; i < count; i += this.#batch) {
      const n = Math.min(this.#batch, count - i);
      compute(n, i);
      out.set(n === this.#batch && results.length === n * width
        ? results : results.subarray(0, n * width), i * width);
    }
    return out;
  }

  /** The same of contexts, a batch of which is in the module when compute(n) is called. */
  #runOf(contexts, width, results, out, compute) {
    const apart = this.#apart(contexts, out);
    return this.#run(contexts.length / 2, width, results, out, (n, i) => {
      this.#contexts.set(2 * n === apart.length ? apart : apart.subarray(2 * i, 2 * (i + n)));
      compute(n);
    });
  }

  /** What a batch reads, apart from what the same one of more batches writes. */
  #apart(contexts, out) {
    return contexts.buffer === out.buffer && contexts.length > 2 * this.#batch
      ? contexts.slice() : contexts;
  }

  #ready(generator) {
    if (generator === 0) this.buildTables();
  }

  #sampleRun(pattern, count, first, dims) {
    word(pattern, "pattern");
    integer(count, "count", 0, words + 1);
    word(first, "first");
    integer(dims, "dims", 1, 4);
    if (first + count > words) {
      throw new RangeError("first + count must be at most 2**32, the samples of a pattern, " +
        `not ${first + count}`);
    }
  }

  samples(pattern, count, options = {}) {
    const { first = 0, dims = 2, generator = "pmj", out } =
      optionsOf(options, ["first", "dims", "generator", "out"]);
    const kind = generatorOf(generator);
    this.#sampleRun(pattern, count, first, dims);
    const filled = outputOf(out, Float32Array, count * dims);
    this.#ready(kind);
    const { setRun, draw, drawRun, slots } = this.#module;
    if (kind === 0) {
      return this.#run(count, dims, this.#xis, filled, (n, i) => drawRun(n, dims, pattern, first + i));
    }
    const none = slots();
    return this.#run(count, dims, this.#xis, filled, (n, i) => {
      setRun(n, pattern, first + i);
      draw(n, kind, dims, none, 1);
    });
  }

  words(pattern, count, options = {}) {
    const { first = 0, dims = 2, generator = "long", out } =
      optionsOf(options, ["first", "dims", "generator", "out"]);
    const kind = generatorOf(generator, generators.slice(1));
    this.#sampleRun(pattern, count, first, dims);
    const filled = outputOf(out, Uint32Array, count * dims);
    const { setRun, drawWords, slots } = this.#module;
    const none = slots();
    return this.#run(count, dims, this.#words, filled, (n, i) => {
      setRun(n, pattern, first + i);
      drawWords(n, kind, dims, none, 1);
    });
  }

  draw(contexts, options = {}) {
    const { dims = 2, generator = "pmj", slot, splits = 1, out } =
      optionsOf(options, ["dims", "generator", "slot", "splits", "out"]);
    const count = contextsOf(contexts).length / 2;
    integer(dims, "dims", 1, 4);
    const kind = generatorOf(generator);
    const { draw, slots, maxSplits } = this.#module;
    const place = slot === undefined ? slots() : integer(slot, "slot", 0, slots());
    integer(splits, "splits", 1, maxSplits() + 1);
    const filled = outputOf(out, Float32Array, count * dims);
    this.#ready(kind);
    return this.#runOf(contexts, dims, this.#xis, filled, (n) => draw(n, kind, dims, place, splits));
  }

  cameraContexts(width, height, frame = 0, sampleid = 0, options = {}) {
    const { seed = 0, origin, out } = optionsOf(options, ["seed", "origin", "out"]);
    for (const [value, name] of [[frame, "frame"], [sampleid, "sampleid"], [seed, "seed"]]) {
      word(value, name);
    }
    const { setCamera } = this.#module;
    return this.#pixels(width, height, origin, out,
      (n, x, y) => setCamera(n, x, y, frame, sampleid, seed));
  }

  blueContexts(width, height, seed = 0, sampleid = 0, options = {}) {
    const { origin, out } = optionsOf(options, ["origin", "out"]);
    word(seed, "seed");
    word(sampleid, "sampleid");
    const { setBlue } = this.#module;
    return this.#pixels(width, height, origin, out, (n, x, y) => setBlue(n, x, y, seed, sampleid));
  }

  /** Contexts of all pixels, by set(n, x, y) for n of a row from (x, y) on. */
  #pixels(width, height, origin = [0, 0], out, set) {
    integer(width, "width", 0, side + 1);
    integer(height, "height", 0, side + 1);
    if (!Array.isArray(origin) || origin.length !== 2) {
      throw new TypeError("origin must be an array of two integers");
    }
    for (const at of origin) integer(at, "origin", -words, words);
    const filled = outputOf(out, Uint32Array, 2 * width * height);
    for (let y = 0; y < height; ++y) {
      this.#run(width, 2, this.#contexts, filled.subarray(2 * width * y, 2 * width * (y + 1)),
        (n, i) => set(n, origin[0] + i, origin[1] + y));
    }
    return filled;
  }

  newDomain(contexts, scramble, options = {}) {
    return this.newDomainSplit(contexts, scramble, 1, options);
  }

  newDomainSplit(contexts, scramble, newnumsamples, options = {}) {
    word(newnumsamples, "newnumsamples");
    return this.#derive(this.#module.newDomainSplit, contexts, scramble, newnumsamples, options);
  }

  newDomainDistrib(contexts, scramble, newsampleid = 0, options = {}) {
    word(newsampleid, "newsampleid");
    return this.#derive(this.#module.newDomainDistrib, contexts, scramble, newsampleid, options);
  }

  #derive(derive, contexts, scramble, number, options) {
    const { generator = "pmj", out } = optionsOf(options, ["generator", "out"]);
    contextsOf(contexts);
    word(scramble, "scramble");
    const isBlue = generatorOf(generator) === generators.indexOf("blue");
    const filled = outputOf(out, Uint32Array, contexts.length);
    return this.#runOf(contexts, 2, this.#contexts, filled,
      (n) => derive(n, isBlue, scramble, number));
  }

  jointScramble(slot) {
    const { jointScramble, slots } = this.#module;
    return jointScramble(integer(slot, "slot", 0, slots())) >>> 0;
  }

  hashToUnsigned(a, b) {
    return this.#module.hashToUnsigned(word(a, "a"), word(b, "b")) >>> 0;
  }

  hashToRandom(a, b) {
    return (this.hashToUnsigned(a, b) >>> 8) * 2 ** -24;
  }
}
