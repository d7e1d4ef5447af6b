// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reads recordings with the libraries of MCAP and Foxglove, and compares them with what was written.
//
//   node recording.mjs values FILE EXPECTED   EXPECTED: a line {"topic", "value"} for each message, in order
//   node recording.mjs stream FILE            messages that a reader finds which goes from the beginning, for files without end
//   node recording.mjs count FILE             messages of each topic by the index, and the gaps in their sequence numbers
//
// It prints JSON; its exit status is 1 if something differs or cannot be read.
import { createRequire } from "node:module";
import { open, readFile } from "node:fs/promises";
import { join } from "node:path";

// The packages are in the folder in which this runs, not where this file is.
const require = createRequire(join(process.cwd(), "index.js"));
const { McapIndexedReader, McapStreamReader } = require("@mcap/core");
const { loadDecompressHandlers } = require("@mcap/support");
const { crc32 } = require("@foxglove/crc");
const { parse: parseRos } = require("@foxglove/rosmsg");
const { MessageReader: RosReader } = require("@foxglove/rosmsg2-serialization");
const { parseIDL } = require("@foxglove/omgidl-parser");
const { MessageReader: IdlReader } = require("@foxglove/omgidl-serialization");

class FileReadable {
  constructor(handle) {
    this.handle = handle;
  }
  async size() {
    return BigInt((await this.handle.stat()).size);
  }
  async read(offset, size) {
    const buffer = new Uint8Array(Number(size));
    const { bytesRead } = await this.handle.read(buffer, 0, buffer.length, Number(offset));
    if (bytesRead !== buffer.length) throw new Error(`read ${bytesRead} of ${size} bytes at ${offset}`);
    return buffer;
  }
}

const textOf = (bytes) => new TextDecoder().decode(bytes);

// Reads messages of a schema; `constants` are its enumerators by struct and name.
function decoderOf(schema) {
  const text = textOf(schema.data);
  const constants = new Map();
  if (schema.encoding === "ros2msg") {
    const definitions = parseRos(text, { ros2: true });
    for (const one of definitions)
      for (const field of one.definitions) if (field.isConstant) add(constants, field.name, field.value);
    const reader = new RosReader(definitions);
    return { constants, isRos: true, read: (data) => reader.readMessage(data) };
  }
  if (schema.encoding !== "omgidl") throw new Error(`schema ${schema.name} has the encoding ${schema.encoding}`);
  const definitions = parseIDL(text);
  for (const one of definitions)
    if (one.aggregatedKind === "module") for (const field of one.definitions) add(constants, field.name, field.value);
  const reader = new IdlReader(schema.name, definitions);
  return { constants, isRos: false, read: (data) => reader.readMessage(data) };
}

function add(constants, name, value) {
  if (!constants.has(name)) constants.set(name, []);
  constants.get(name).push(BigInt(value));
}

const snake = (name) =>
  name
    .replace(/([A-Z]+)([A-Z][a-z])/g, "$1_$2")
    .replace(/([a-z0-9])([A-Z])/g, "$1_$2")
    .replace(/[^A-Za-z0-9]+/g, "_")
    .replace(/^_+|_+$/g, "")
    .toLowerCase();

const isList = (value) => Array.isArray(value) || ArrayBuffer.isView(value);
const show = (value) => JSON.stringify(value, (_, one) => (typeof one === "bigint" ? `${one}n` : one));

// Where `found`, which was decoded, differs from `expected`, which C++ wrote; null if it does not.
function difference(found, expected, path, field, decoder) {
  const no = () => `${path}: found ${show(found)}, expected ${show(expected)}`;
  if (found !== null && typeof found === "object" && !isList(found)) {
    const keys = Object.keys(found);
    if (keys.length === 1 && keys[0] === "data" && expected?.data === undefined)
      return difference(found.data, expected, `${path}.data`, field, decoder);
    if (expected?.alternative !== undefined) {
      if (keys.length !== 1 || keys[0].replace(/^_/, "") !== expected.alternative.replace(/[^A-Za-z0-9_]/g, "_").replace(/^_/, ""))
        return no();
      if (expected.value === undefined) return Object.keys(found[keys[0]]).length === 0 ? null : no();
      return difference(found[keys[0]], expected.value, `${path}.${keys[0]}`, keys[0], decoder);
    }
    if (expected === null || typeof expected !== "object" || isList(expected)) return no();
    for (const key of keys) {
      if (key === "structure_needs_at_least_one_member" && Object.keys(expected).length === 0) continue;
      const its = Object.keys(expected).find((one) => one === key || `_${one}` === key);
      if (its === undefined) return `${path}: ${key} is in the schema only`;
      const other = difference(found[key], expected[its], `${path}.${key}`, key, decoder);
      if (other) return other;
    }
    return null;
  }
  if (isList(found)) {
    if (!isList(expected) || found.length !== expected.length) return no();
    for (let i = 0; i !== found.length; ++i) {
      const other = difference(found[i], expected[i], `${path}[${i}]`, field, decoder);
      if (other) return other;
    }
    return null;
  }
  return isEqual(found, expected, field, decoder) ? null : no();
}

function isEqual(found, expected, field, decoder) {
  if (expected?.$int !== undefined) return BigInt(found) === BigInt(expected.$int);
  if (typeof found === "string") {
    // A text that is not UTF-8 is a list of its bytes in JSON.
    if (isList(expected)) return textOf(Uint8Array.from(expected)) === found;
    return found === expected;
  }
  if (typeof expected === "boolean") return Boolean(found) === expected;
  if (typeof expected === "string") {
    if (["NaN", "Infinity", "-Infinity"].includes(expected)) return Object.is(Number(expected), found);
    const name = decoder.isRos ? snake(`${field}_${expected}`).toUpperCase() : expected;
    const values = decoder.constants.get(name) ?? decoder.constants.get(`_${name}`);
    // parseIDL reads constants as doubles.
    if (values?.some((one) => one === BigInt(found) || (!decoder.isRos && Number(one) === Number(found)))) return true;
    if (typeof found === "boolean") return true; // an enumeration of bool has no constants
    return expected.length === 1 && expected.charCodeAt(0) === Number(found); // a letter
  }
  if (typeof found === "bigint") return found === BigInt(expected);
  if (typeof found === "boolean") return found === Boolean(expected);
  if (expected < 0 && found === expected + 256) return true; // a char with a sign
  return found === expected || Math.fround(expected) === found;
}

// Whole numbers that a double does not hold stay texts.
function parseExact(line) {
  return JSON.parse(
    line.replace(/"(?:[^"\\]|\\.)*"|-?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?/g, (word) =>
      /^-?\d{16,}$/.test(word) ? `{"$int":"${word}"}` : word,
    ),
  );
}

async function indexed(file) {
  const readable = new FileReadable(await open(file));
  return await McapIndexedReader.Initialize({ readable, decompressHandlers: await loadDecompressHandlers() });
}

async function values(file, expectedFile) {
  const reader = await indexed(file);
  const expected = new Map();
  for (const line of (await readFile(expectedFile, "utf8")).split("\n").filter(Boolean)) {
    const { topic, value } = parseExact(line);
    if (!expected.has(topic)) expected.set(topic, []);
    expected.get(topic).push(value);
  }
  const decoders = new Map();
  const differences = [];
  const encodings = {};
  for (const [id, schema] of reader.schemasById) {
    try {
      decoders.set(id, decoderOf(schema));
      encodings[schema.encoding] = (encodings[schema.encoding] ?? 0) + 1;
    } catch (error) {
      differences.push(`schema ${schema.name}: ${error.message}\n${textOf(schema.data)}`);
    }
  }
  let messages = 0;
  const next = new Map();
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    const channel = reader.channelsById.get(message.channelId);
    const at = next.get(channel.topic) ?? 0;
    next.set(channel.topic, at + 1);
    ++messages;
    const decoder = decoders.get(channel.schemaId);
    if (!decoder) continue;
    const type = reader.schemasById.get(channel.schemaId).name;
    try {
      const other = difference(decoder.read(message.data), expected.get(channel.topic)?.[at], type, "data", decoder);
      if (other) differences.push(other);
    } catch (error) {
      differences.push(`${type}: ${error.message}\n${textOf(reader.schemasById.get(channel.schemaId).data)}`);
    }
  }
  for (const [topic, all] of expected)
    if ((next.get(topic) ?? 0) !== all.length)
      differences.push(`${topic}: found ${next.get(topic) ?? 0} messages, expected ${all.length}`);
  console.log(JSON.stringify({ messages, encodings, differences }, null, 1));
  return differences.length === 0;
}

async function stream(file) {
  const reader = new McapStreamReader({ decompressHandlers: await loadDecompressHandlers(), validateCrcs: true });
  const counts = {};
  const topics = new Map();
  const last = new Map();
  let gaps = 0;
  reader.append(await readFile(file));
  for (let record; (record = reader.nextRecord()); ) {
    if (record.type === "Channel") topics.set(record.id, record.topic);
    if (record.type !== "Message") continue;
    const topic = topics.get(record.channelId);
    counts[topic] = (counts[topic] ?? 0) + 1;
    gaps += record.sequence - (last.get(topic) ?? -1) - 1;
    last.set(topic, record.sequence);
  }
  console.log(JSON.stringify({ counts, gaps, done: reader.done() }));
  return true;
}

async function count(file) {
  const reader = await indexed(file);
  const counts = {};
  const last = new Map();
  let gaps = 0;
  let previous = 0n;
  let ordered = true;
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    const topic = reader.channelsById.get(message.channelId).topic;
    counts[topic] = (counts[topic] ?? 0) + 1;
    gaps += message.sequence - (last.get(topic) ?? -1) - 1;
    last.set(topic, message.sequence);
    ordered &&= message.logTime >= previous;
    previous = message.logTime;
  }
  // The library keeps the checksum of the data section, but does not compare it.
  const data = (await readFile(file)).subarray(0, Number(reader.dataEndOffset));
  if (reader.dataSectionCrc !== crc32(data))
    throw new Error(`the checksum of the data section is ${reader.dataSectionCrc}, expected ${crc32(data)}`);
  const metadata = {};
  for await (const one of reader.readMetadata()) metadata[one.name] = Object.fromEntries(one.metadata);
  console.log(JSON.stringify({ counts, gaps, ordered, metadata, statistics: String(reader.statistics.messageCount) }));
  return ordered && reader.statistics.messageCount === BigInt(Object.values(counts).reduce((a, b) => a + b, 0));
}

const [verb, ...words] = process.argv.slice(2);
try {
  if (!(await { values, stream, count }[verb](...words))) process.exitCode = 1;
} catch (error) {
  console.log(JSON.stringify({ error: `${error.name}: ${error.message}` }));
  process.exitCode = 1;
}
