// SPDX-License-Identifier: Apache-2.0
//
// The golden values of the library, tests/golden/*.txt, against a loaded module. For Node.js and for
// browsers. golden.h there explains the lines.

/** Kinds that are not reachable from JavaScript; all samples of tables are. */
export const leftOut = ["stream", "table"];

/** The records of each kind, `{arguments, results}`. `texts` are the files. */
function recordsOf(texts) {
  const records = new Map();
  for (const line of texts.join("\n").split("\n")) {
    if (line === "" || line.startsWith("#")) continue;
    const [head, tail] = line.split("=");
    const [kind, ...given] = head.trim().split(" ");
    const numbers = (list) => list.map((text) => parseInt(text, 16));
    if (!records.has(kind)) records.set(kind, []);
    records.get(kind).push({ arguments: numbers(given), results: numbers(tail.trim().split(" ")) });
  }
  return records;
}

const bitsOf = (xis) => Array.from(xis, (xi) => xi * 2 ** 24);

/** FNV-1a of the bytes of words. */
function digestOf(values) {
  let digest = 2166136261;
  for (const value of values) {
    for (let shift = 0; shift < 32; shift += 8) {
      digest = Math.imul(digest ^ (value >>> shift & 0xff), 16777619) >>> 0;
    }
  }
  return digest;
}

/** x, y and z of a context, drawn with all dims, alone and within a batch. */
function drawn(library, pattern, sampleid, options) {
  const context = [pattern, sampleid];
  const batch = new Uint32Array(2 * 37);
  for (let i = 0; i < 37; ++i) batch.set([pattern + i, sampleid + i], 2 * i);
  const xyz = bitsOf(library.draw(new Uint32Array(context), { ...options, dims: 3 }));
  const xy = bitsOf(library.draw(batch, { ...options, dims: 2 })).slice(0, 2);
  const [z] = bitsOf(library.draw(batch, { ...options, dims: 1 }));
  return [xy, z].flat().every((value, i) => value === xyz[i]) ? xyz : ["the dims differ"];
}

/** What each kind of record asks for, by the library and the record's arguments. */
const answers = {
  sample: (w, p, s) => drawn(w, p, s, { generator: "pmj" }),
  random: (w, p, s) => drawn(w, p, s, { generator: "random" }),
  long: (w, p, s) => drawn(w, p, s, { generator: "long" }),
  blue: (w, p, s) => drawn(w, p, s, { generator: "blue" }),
  joint: (w, p, s, slot, splits) => drawn(w, p, s, { generator: "pmj", slot, splits }),
  longslot: (w, p, s, slot, splits) => drawn(w, p, s, { generator: "long", slot, splits }),
  blueslot: (w, p, s, slot, splits) => drawn(w, p, s, { generator: "blue", slot, splits }),
  sequence: (w, p, first) => w.words(p, 1, { first, dims: 3 }),
  run: (w, p, first, count) => {
    const contexts = new Uint32Array(2 * count);
    for (let i = 0; i < count; ++i) contexts.set([p, first + i], 2 * i);
    return [digestOf(bitsOf(w.draw(contexts, { dims: 3 })))];
  },
  hash: (w, a, b) => [w.hashToUnsigned(a, b)],
  domain: (w, p, s, scramble) => w.newDomain(new Uint32Array([p, s]), scramble),
  split: (w, p, s, scramble, n) => w.newDomainSplit(new Uint32Array([p, s]), scramble, n),
  distrib: (w, p, s, scramble, n) => w.newDomainDistrib(new Uint32Array([p, s]), scramble, n),
  bluesplit: (w, p, s, scramble, n) =>
    w.newDomainSplit(new Uint32Array([p, s]), scramble, n, { generator: "blue" }),
  bluedistrib: (w, p, s, scramble, n) =>
    w.newDomainDistrib(new Uint32Array([p, s]), scramble, n, { generator: "blue" }),
  camera: (w, x, y, frame, s) => w.cameraContexts(1, 1, frame, s, { origin: [x, y] }),
  seeded: (w, x, y, frame, s, seed) => w.cameraContexts(1, 1, frame, s, { seed, origin: [x, y] }),
  bluecamera: (w, x, y, seed, s) => w.blueContexts(1, 1, seed, s, { origin: [x, y] }),
};

/** Compares all records. Returns how many agree, and lines that say what does not. */
export function checkGolden(library, texts) {
  const faults = [];
  let agreed = 0;
  const records = recordsOf(texts);
  for (const kind of Object.keys(answers)) {
    if (!records.has(kind)) faults.push(`there is no ${kind}`);
  }
  for (const [kind, list] of records) {
    if (leftOut.includes(kind)) continue;
    if (!(kind in answers)) faults.push(`nobody knows ${kind}`);
    for (const record of answers[kind] ? list : []) {
      const found = Array.from(answers[kind](library, ...record.arguments));
      if (found.join() === record.results.join()) ++agreed;
      else faults.push(`${kind} ${record.arguments} = ${record.results}, not ${found}`);
    }
  }
  const [stream] = records.get("stream");
  if (stream.results[0] !== library.streamVersion) faults.push("the stream version differs");
  return { agreed, faults };
}
