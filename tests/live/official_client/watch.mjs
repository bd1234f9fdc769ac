// Watches a live run with the client of those who made the protocol, and prints what it was told as JSON.
//
//   node watch.mjs elsie run WORLD --live 0 --json ...
//
// It subscribes to everything, holds the run, goes on and back, lets it run to its end, and ends the program by an interrupt.
// Exit code 1: something is not as it should be; the sentences are in "problems".
import { spawn } from "node:child_process";

import protocol from "@foxglove/ws-protocol";
import { WebSocket } from "ws";

const found = { info: {}, channels: {}, messages: {}, times: 0, statuses: [], parameters: {}, result: {}, said: "", exit_code: null, problems: [] };
const problem = (text) => found.problems.length < 20 && found.problems.push(text);

const [command, ...words] = process.argv.slice(2);
const program = spawn(command, words, { stdio: ["ignore", "pipe", "pipe"] });
let out = "";
program.stdout.on("data", (bytes) => (out += bytes));
const address = await new Promise((resolve, reject) => {
  program.stderr.on("data", (bytes) => {
    found.said += bytes;
    const url = found.said.match(/ws:\/\/\S+/);
    if (url) resolve(url[0]);
  });
  program.on("exit", () => reject(new Error(`the program has ended: ${found.said}`)));
});
const exit = new Promise((resolve) => program.on("exit", resolve));

const { FoxgloveClient } = protocol;
const client = new FoxgloveClient({ ws: new WebSocket(address, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]) });
const subscriptions = new Map();
const waiting = [];
const until = (is_there) => new Promise((resolve) => waiting.push({ is_there, resolve }));
const look = (news) => {
  for (const each of waiting.splice(0)) each.is_there(news) ? each.resolve(news) : waiting.push(each);
};
client.on("error", (error) => problem(String(error)));
client.on("serverInfo", (info) => (found.info = info));
client.on("status", (status) => found.statuses.push(status));
client.on("advertise", (channels) => {
  for (const channel of channels) {
    found.channels[channel.topic] = channel.schemaName;
    if (channel.encoding !== "json" || channel.schemaEncoding !== "jsonschema") problem(`${channel.topic}: another encoding`);
    JSON.parse(channel.schema);
    subscriptions.set(client.subscribe(channel.id), channel.topic);
  }
});
client.on("time", () => ++found.times);
client.on("message", ({ subscriptionId, timestamp, data }) => {
  const topic = subscriptions.get(subscriptionId);
  const message = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(data));
  if (!topic) problem(`a message of the subscription ${subscriptionId}, which there is not`);
  found.messages[topic] = (found.messages[topic] ?? 0) + 1;
  look({ topic, timestamp, message });
});
client.on("parameterValues", ({ parameters, id }) => {
  found.parameters = Object.fromEntries(parameters.map(({ name, value }) => [name, value]));
  look({ id, ...found.parameters });
});
const set = async (id, values) => {
  const answer = until((news) => news.id === id);
  client.setParameters(Object.entries(values).map(([name, value]) => ({ name, value })), id);
  return await answer;
};

await until(({ topic }) => topic === "/tf");
const paused = await set("pause", { paused: true });
if (paused.paused !== true) problem("it is not paused");
const on = await set("on", { time_s: 2 });
if (on.time_s !== 2) problem(`it went to ${on.time_s} s instead of 2`);
const back = until(({ topic, timestamp }) => topic === "/tf" && timestamp === 1_000_000_000n);
await set("back", { time_s: 1 });
await back;
await set("play", { paused: false, speed: 1000 });
await new Promise((resolve) => {
  const look_for_result = () => out.trim().endsWith("}") && resolve();
  program.stdout.on("data", look_for_result);
  look_for_result();
});
found.result = JSON.parse(out);
program.kill("SIGINT");
found.exit_code = await exit;
client.close();
console.log(JSON.stringify(found));
process.exitCode = found.problems.length > 0 ? 1 : 0;
