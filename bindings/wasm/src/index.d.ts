// SPDX-License-Identifier: Apache-2.0
//
// Well-stratified samples, the bits of the C++ library. docs/javascript.md is the guide.
//
// Functions check their arguments: what is wrong is a TypeError or RangeError of one sentence, and
// nothing has been written. Integers are JavaScript numbers; words are integers in [0, 2**32).
// Results are new arrays, or `out`, and belong to the caller.

/** How to load the module. */
export interface LoadOptions {
  /** Vector instructions. By default if the engine has them; then true is an error where it has
   * none. */
  simd?: boolean;
  /** What to load instead of the package's own file: its bytes, or where it is. With bytes, nothing
   * is fetched. */
  wasm?: ArrayBuffer | ArrayBufferView | URL | string;
}

/** Loads the module and starts it. Each call makes one of its own, with its own memory.
 *
 * Rejects with what the engine says where it cannot compile modules or the file is not there. */
export function load(options?: LoadOptions): Promise<Wellstrat>;

/** Not enough memory, for the tables of "pmj" or for a result. Everything else still works. */
export class OutOfMemoryError extends Error {}

/** Whose samples:
 *
 * - `"pmj"`: from tables of 12 MiB, built at first use; stratified to sample 4096, by blocks to
 *   196608.
 * - `"long"`: computed; stratified to 2**32.
 * - `"blue"`: computed; errors of neighboring pixels cancel. Begins at {@link Wellstrat.blueContexts}.
 * - `"random"`: not stratified, to compare with.
 */
export type Generator = "pmj" | "long" | "blue" | "random";

/** Coordinates of a sample: x and y; z alone; or x, y and z. */
export type Dims = 2 | 1 | 3;

export interface SamplesOptions {
  /** The first sample, a word; by default 0. */
  first?: number;
  /** By default 2. */
  dims?: Dims;
  /** By default `"pmj"`. */
  generator?: Generator;
  /** What to fill: count * dims elements. */
  out?: Float32Array;
}

export interface WordsOptions {
  /** The first sample, a word; by default 0. */
  first?: number;
  /** By default 2. */
  dims?: Dims;
  /** By default `"long"`. `"pmj"` has 24 bits only. */
  generator?: Exclude<Generator, "pmj">;
  /** What to fill: count * dims elements. */
  out?: Uint32Array;
}

export interface DrawOptions {
  /** By default 2. */
  dims?: Dims;
  /** By default `"pmj"`. */
  generator?: Generator;
  /** The contexts are those of the domain `jointScramble(slot)`, 0 to 15: all slots of one parent
   * are stratified together. By default none. `"random"` ignores it. */
  slot?: number;
  /** The product of all splits between the camera and the slot's domain, 1 to 256; by default 1. */
  splits?: number;
  /** What to fill: a sample of `dims` elements for each context. */
  out?: Float32Array;
}

export interface CameraOptions {
  /** A word; pictures of one frame with other seeds are independent. By default 0. */
  seed?: number;
  /** x and y of the first pixel, which count modulo 65536; by default [0, 0]. */
  origin?: [x: number, y: number];
  /** What to fill: 2 * width * height elements. */
  out?: Uint32Array;
}

export type BlueOptions = Omit<CameraOptions, "seed">;

export interface DomainOptions {
  /** Domains of `"blue"` are derived in another way than all others; by default `"pmj"`. */
  generator?: Generator;
  /** What to fill: as long as the contexts, which it may be. */
  out?: Uint32Array;
}

/** A loaded module.
 *
 * Contexts are pairs of words in one array: patternid, sampleid, patternid, sampleid, ... All
 * functions are pure: the same arguments give the same bits, on every machine, as long as
 * `streamVersion` is the same. */
export interface Wellstrat {
  /** Of the library, such as "0.1.0". */
  readonly version: string;
  /** Of the sample values. */
  readonly streamVersion: number;
  /** What draws batches: "simd128" or "scalar". The bits are the same. */
  readonly instructionSet: "simd128" | "scalar";

  /** Builds the tables of `"pmj"`, which its first draw would do otherwise: some 30 milliseconds.
   * Throws {@link OutOfMemoryError} if they do not fit; it may be tried again. */
  buildTables(): void;

  /** What shaders look up (docs/gpu.md), to be uploaded: 70 KiB for `"computed"`, which are `"long"` and
   * `"blue"`; 6.1 MiB with 2D draws of `"pmj"`, too; 12.1 MiB for all, the default. The tables are
   * built for the last two. */
  deviceTables(draws?: "computed" | "draws2D" | "all"): Uint32Array;

  /** Samples `first` to `first + count - 1` of a pattern, a word: count * dims numbers in [0, 1),
   * multiples of 2**-24, sample after sample. */
  samples(pattern: number, count: number, options?: SamplesOptions): Float32Array;

  /** The same with all 32 bits, as fractions of 2**32. Samples are the upper 24. */
  words(pattern: number, count: number, options?: WordsOptions): Uint32Array;

  /** The sample of each context: `dims` numbers in [0, 1) for each. */
  draw(contexts: Uint32Array, options?: DrawOptions): Float32Array;

  /** The context of one sample of every pixel of a picture, row after row. width and height are at
   * most 65536; frame and sampleid are words, by default 0. */
  cameraContexts(width: number, height: number, frame?: number, sampleid?: number,
    options?: CameraOptions): Uint32Array;

  /** The same for `"blue"`. Pictures of different seeds are independent; the frames of a sequence
   * share a seed and go on in sampleid. */
  blueContexts(width: number, height: number, seed?: number, sampleid?: number,
    options?: BlueOptions): Uint32Array;

  /** The contexts of a new domain, such as a lens or a light, that has samples of its own.
   * `scramble`, a word, tells it from other domains of the same parents. */
  newDomain(contexts: Uint32Array, scramble: number, options?: DomainOptions): Uint32Array;

  /** The same where each visit takes `newnumsamples` samples: its contexts begin at
   * sampleid * newnumsamples, modulo 2**32. */
  newDomainSplit(contexts: Uint32Array, scramble: number, newnumsamples: number,
    options?: DomainOptions): Uint32Array;

  /** The same with a pattern of its own for each visit, which takes any number of samples, from
   * `newsampleid` on, by default 0. */
  newDomainDistrib(contexts: Uint32Array, scramble: number, newsampleid?: number,
    options?: DomainOptions): Uint32Array;

  /** The scramble of a domain that is stratified together with those of the other slots, 0 to 15. */
  jointScramble(slot: number): number;

  /** A uniformly distributed word, or number in [0, 1), that depends on two words only. Of many
   * pairs, `draw(pairs, { generator: "random", dims: 1 })` makes the same numbers. */
  hashToUnsigned(a: number, b: number): number;
  hashToRandom(a: number, b: number): number;
}
