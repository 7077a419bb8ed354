// SPDX-License-Identifier: Apache-2.0
//
// Checks of arguments. What is wrong is said in one sentence, before anything is written.

/** Not enough memory, for the tables or for a result. */
export class OutOfMemoryError extends Error {
  name = "OutOfMemoryError";
}

export const words = 2 ** 32;

/** The numbers of generators in module.cpp. */
export const generators = ["pmj", "long", "blue", "random"];

/** A value as a sentence shows it. */
export function shown(value) {
  if (typeof value === "string") return JSON.stringify(value);
  if (typeof value === "bigint") return `${value}n`;
  if (value === null || !["object", "function"].includes(typeof value)) return String(value);
  return value.constructor?.name ?? typeof value;
}

/** `value`, an integer in [low, high). */
export function integer(value, name, low, high) {
  if (!Number.isInteger(value)) {
    throw new TypeError(`${name} must be an integer, not ${shown(value)}`);
  }
  if (value < low || value >= high) {
    throw new RangeError(`${name} must be from ${low} to ${high - 1}, not ${value}`);
  }
  return value;
}

export const word = (value, name) => integer(value, name, 0, words);

/** `value`, one of these strings. */
export function choice(value, name, accepted) {
  if (accepted.includes(value)) return value;
  const known = accepted.map((other) => `"${other}"`).join(", ");
  throw new RangeError(`${name} must be one of ${known}, not ${shown(value)}`);
}

/** The number of a generator, one of `accepted`. */
export const generatorOf = (name, accepted = generators) =>
  generators.indexOf(choice(name, "generator", accepted));

/** The options, which have no other names than these. */
export function optionsOf(options, names) {
  if (typeof options !== "object" || options === null) {
    throw new TypeError(`options must be an object, not ${shown(options)}`);
  }
  for (const name in options) {
    if (!names.includes(name)) {
      throw new TypeError(`there is no option ${shown(name)}; there are ${names.join(", ")}`);
    }
  }
  return options;
}

/** Whether `value` is of this built-in type, of any realm. */
export const isA = (type, value) =>
  Object.prototype.toString.call(value) === `[object ${type.name}]`;

/** `contexts`, an array of patternid, sampleid, patternid, ... */
export function contextsOf(contexts, name = "contexts") {
  if (!isA(Uint32Array, contexts)) {
    throw new TypeError(`${name} must be a Uint32Array, not ${shown(contexts)}`);
  }
  if (contexts.length % 2 !== 0) {
    throw new RangeError(`${name} must be pairs of a patternid and a sampleid, ` +
      `not ${contexts.length} numbers`);
  }
  return contexts;
}

/** `out`, if it is an array of this type and length, or a new one if there is none. */
export function outputOf(out, type, length) {
  if (out === undefined) {
    try {
      return new type(length);
    } catch {
      throw new OutOfMemoryError(`${length} results do not fit into memory`);
    }
  }
  if (!isA(type, out)) throw new TypeError(`out must be a ${type.name}, not ${shown(out)}`);
  if (out.length !== length) {
    throw new RangeError(`out must have ${length} elements, not ${out.length}`);
  }
  return out;
}
