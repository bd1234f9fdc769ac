// Reads an MCAP file with the official reader, holds every message against the schemas, and prints what was there as JSON.
//
//   node read.mjs indexed FILE.mcap     by its summary and its indexes: a file that is whole
//   node read.mjs streamed FILE.mcap    from its beginning, as far as it goes: any file
//
// Exit code 1: something is not as it should be; the sentences are in "problems".
import { open, readFile } from "node:fs/promises";

import * as foxglove from "@foxglove/schemas/jsonschema.js";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import Ajv from "ajv";
import { decompress } from "fzstd";

const [mode, file] = process.argv.slice(2);
const decompressHandlers = { zstd: (bytes, size) => decompress(bytes, new Uint8Array(Number(size))) };
const found = { mode, library: "", messages: 0, chunks: 0, end_ns: "0", complete: false, metadata: {}, channels: {}, problems: [] };
const problem = (text) => found.problems.length < 20 && found.problems.push(text);

const schemas = new Map();
const channels = new Map();
const checks = new Map();
const ajv = new Ajv({ strict: false, allErrors: true });

// Foxglove and Lichtblick understand a part of JSON schema: anything else makes a channel unreadable for them.
function checkForViewers(schema, at) {
  if (Array.isArray(schema.oneOf)) {
    if (!schema.oneOf.every((choice) => typeof choice.const === "number")) problem(`${at}: a choice of other things than numbers`);
    return;
  }
  if (schema.type === "object") {
    if (typeof schema.properties !== "object") problem(`${at}: an object without properties`);
    if (typeof schema.additionalProperties === "object") problem(`${at}: members that it does not list, so that nothing can offer them`);
    for (const [name, property] of Object.entries(schema.properties ?? {})) checkForViewers(property, `${at}.${name}`);
  } else if (schema.type === "array") {
    checkForViewers(schema.items ?? {}, `${at}[]`);
  } else if (!["boolean", "string", "number", "integer"].includes(schema.type)) {
    problem(`${at}: type ${JSON.stringify(schema.type)}`);
  }
}

// Our schema must not promise another type than the official one, nor lack what that requires.
function compare(own, official, at) {
  if (own.type !== official.type) problem(`${at}: type ${own.type}, officially ${official.type}`);
  for (const name of official.required ?? Object.keys(official.properties ?? {})) {
    if (!own.properties?.[name]) problem(`${at}: lacks ${name}`);
  }
  for (const [name, property] of Object.entries(own.properties ?? {})) {
    if (official.properties?.[name]) compare(property, official.properties[name], `${at}.${name}`);
  }
  if (own.items) compare(own.items, official.items ?? {}, `${at}[]`);
}

function addSchema(schema) {
  if (schemas.has(schema.id)) return;
  schemas.set(schema.id, schema);
  const text = JSON.parse(new TextDecoder().decode(schema.data));
  const all = [ajv.compile(text)];
  checkForViewers(text, schema.name);
  if (schema.encoding !== "jsonschema") problem(`${schema.name}: encoding ${schema.encoding}`);
  if (schema.name.startsWith("foxglove.")) {
    const official = foxglove[schema.name.slice("foxglove.".length)];
    if (official) {
      compare(text, official, schema.name);
      all.push(ajv.compile(official));
    } else {
      problem(`${schema.name}: there is no such schema`);
    }
  }
  checks.set(schema.id, all);
}

// What a viewer could list for plots: the paths of the numbers that a schema names.
function numbersOf(schema, path) {
  if (schema.type === "number") return [path.join(".")];
  return Object.entries(schema.properties ?? {}).flatMap(([name, property]) => numbersOf(property, [...path, name]));
}

function addChannel(channel) {
  if (channels.has(channel.id)) return;
  channels.set(channel.id, channel);
  if (channel.messageEncoding !== "json") problem(`${channel.topic}: encoding ${channel.messageEncoding}`);
  const schema = schemas.get(channel.schemaId);
  found.channels[channel.topic] = { schema: schema?.name ?? "", messages: 0, numbers: schema ? numbersOf(JSON.parse(new TextDecoder().decode(schema.data)), []) : [] };
}

function isPng(base64) {
  const bytes = Buffer.from(base64, "base64");
  return bytes.toString("base64") === base64 && bytes.subarray(1, 4).toString() === "PNG" && bytes.subarray(-8, -4).toString() === "IEND";
}

function addMessage(message) {
  const channel = channels.get(message.channelId);
  const value = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(message.data));
  for (const check of checks.get(channel.schemaId) ?? []) {
    if (!check(value)) problem(`${channel.topic} at ${message.logTime}: ${ajv.errorsText(check.errors)}`);
  }
  if (found.channels[channel.topic].schema === "foxglove.CompressedImage" && !isPng(value.data)) problem(`${channel.topic}: no PNG`);
  if (message.sequence !== found.channels[channel.topic].messages) problem(`${channel.topic}: sequence ${message.sequence}`);
  ++found.channels[channel.topic].messages;
  ++found.messages;
  if (message.logTime > BigInt(found.end_ns)) found.end_ns = String(message.logTime);
}

const addMetadata = (record) => (found.metadata[record.name] = Object.fromEntries(record.metadata));

async function readIndexed() {
  const handle = await open(file);
  const readable = {
    size: async () => BigInt((await handle.stat()).size),
    read: async (offset, length) => {
      const bytes = new Uint8Array(Number(length));
      const { bytesRead } = await handle.read(bytes, 0, bytes.length, Number(offset));
      if (bytesRead !== bytes.length) throw new Error(`only ${bytesRead} of ${length} bytes at ${offset}`);
      return bytes;
    },
  };
  const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
  found.library = reader.header.library;
  reader.schemasById.forEach(addSchema);
  reader.channelsById.forEach(addChannel);
  for await (const message of reader.readMessages({ validateCrcs: true })) addMessage(message);
  for await (const record of reader.readMetadata()) addMetadata(record);
  found.chunks = reader.chunkIndexes.length;
  found.complete = true;
  const counts = reader.statistics.channelMessageCounts;
  for (const channel of reader.channelsById.values()) {
    const { messages } = found.channels[channel.topic];
    if (counts.get(channel.id) !== BigInt(messages)) problem(`${channel.topic}: statistics say ${counts.get(channel.id)}, found ${messages}`);
    // By topic, backwards: each through its index alone.
    let again = 0;
    let time;
    for await (const message of reader.readMessages({ topics: [channel.topic], reverse: true })) {
      if (time !== undefined && message.logTime > time) problem(`${channel.topic}: not in the order of time`);
      time = message.logTime;
      ++again;
    }
    if (again !== messages) problem(`${channel.topic}: ${messages} messages, by its index ${again}`);
  }
  if (reader.statistics.messageCount !== BigInt(found.messages)) problem("the statistics count other messages");
  if (reader.statistics.metadataCount !== Object.keys(found.metadata).length) problem("the statistics count other metadata");
  await handle.close();
}

async function readStreamed() {
  const reader = new McapStreamReader({ validateCrcs: true, decompressHandlers, includeChunks: true });
  reader.append(await readFile(file));
  for (let record; (record = reader.nextRecord()); ) {
    if (record.type === "Header") found.library = record.library;
    else if (record.type === "Schema") addSchema(record);
    else if (record.type === "Channel") addChannel(record);
    else if (record.type === "Message") addMessage(record);
    else if (record.type === "Metadata") addMetadata(record);
    else if (record.type === "Chunk") ++found.chunks;
  }
  found.complete = reader.done();
}

try {
  await (mode === "indexed" ? readIndexed() : readStreamed());
} catch (error) {
  problem(String(error));
}
console.log(JSON.stringify(found));
process.exitCode = found.problems.length > 0 ? 1 : 0;
