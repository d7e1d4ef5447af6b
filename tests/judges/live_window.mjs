// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Looks at a real deployer with Foxglove's own client and parsers, by both names of its protocol.
//
//   node live_window.mjs DEPLOYER COMPONENTS
//
// The exit status is 1 if something is not as it should be, 77 without the packages, which `./dev judges` installs.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";

import { deploy } from "./deployed.mjs";

const [deployer, components] = process.argv.slice(2);
if (!existsSync("node_modules")) {
  console.log("left out: Foxglove's client is not installed: ./dev judges");
  process.exit(77);
}
// The packages are in the folder in which this runs, not where this file is.
const require = createRequire(join(process.cwd(), "index.js"));
const { FoxgloveClient } = require("@foxglove/ws-protocol");
const { parse: parseRos } = require("@foxglove/rosmsg");
const { MessageReader } = require("@foxglove/rosmsg2-serialization");
const { WebSocket } = require("ws");

// Waits for events of a client. `all` has those that came before, by name.
class Events {
  constructor(client, names) {
    this.all = new Map(names.map((name) => [name, []]));
    this.waiting = new Set();
    for (const name of names)
      client.on(name, (event) => {
        this.all.get(name).push(event);
        for (const look of this.waiting) look();
      });
    client.on("error", (error) => {
      console.error(error);
      process.exitCode = 1;
    });
  }
  // The first event of that name, present or future, for which `test` holds.
  get(name, test = () => true) {
    return new Promise((resolve, reject) => {
      const late = setTimeout(() => reject(new Error(`no ${name} as ${test}, only ${show(this.all.get(name))}`)), 15000);
      const look = () => {
        const found = this.all.get(name).find(test);
        if (found === undefined) return;
        clearTimeout(late);
        this.waiting.delete(look);
        resolve(found);
      };
      this.waiting.add(look);
      look();
    });
  }
}

const show = (value) => JSON.stringify(value, (_, one) => (typeof one === "bigint" ? `${one}` : one));
const names =
  "open serverInfo status advertise unadvertise parameterValues advertiseServices connectionGraphUpdate message time " +
  "serviceCallResponse serviceCallFailure";

async function look(url, typed, protocol) {
  const client = new FoxgloveClient({ ws: new WebSocket(url, [protocol]) });
  const events = new Events(client, names.split(" "));
  const info = await events.get("serverInfo");
  client.getParameters([], "early"); // as Foxglove does
  for (const one of ["time", "parameters", "parametersSubscribe", "connectionGraph", "services"])
    assert(info.capabilities.includes(one), `capability ${one}`);

  const channelOf = async (topic) => {
    const channels = await events.get("advertise", (all) => all.some((one) => one.topic === topic));
    return channels.find((one) => one.topic === topic);
  };
  const level = await channelOf("/tank/level");
  assert.deepEqual([level.encoding, level.schemaEncoding, level.schemaName], ["cdr", "ros2msg", "std_msgs/msg/Float64"]);
  const reader = new MessageReader(parseRos(level.schema, { ros2: true }));
  const subscription = client.subscribe(level.id);
  const sample = (value) =>
    events.get("message", (one) => one.subscriptionId === subscription && reader.readMessage(one.data).data === value);

  const services = await events.get("advertiseServices", (all) => all.some((one) => one.name === "/tank/fill"));
  const fill = services.find((one) => one.name === "/tank/fill");
  assert.ok(!services.some((one) => one.name.startsWith("/Deployer/")), "operations that this client may not call");
  assert.equal(fill.request?.encoding ?? "json", "json");
  const call = (callId, request) =>
    client.sendServiceCallRequest({
      serviceId: fill.id,
      callId,
      encoding: "json",
      data: new TextEncoder().encode(JSON.stringify(request)),
    });
  call(1, { level: 1.25 });
  const answer = await events.get("serviceCallResponse", (one) => one.callId === 1);
  assert.deepEqual(JSON.parse(new TextDecoder().decode(answer.data)), { result: true });
  const filled = await sample(1.25);
  const age = BigInt(Date.now()) * 1000000n - filled.timestamp;
  assert(age > -1000000000n && age < 15000000000n, `the sample is ${age} ns old`);
  const schemas = [fill.request.schema, fill.response.schema].map((one) => JSON.parse(one).properties);
  assert.deepEqual([schemas[0].level.type, schemas[1].result.type], ["number", "boolean"]);
  call(2, { level: "high" });
  assert.match((await events.get("serviceCallFailure", (one) => one.callId === 2)).message, /level|double|number/);

  call(3, { volume: 1 });
  assert.match((await events.get("serviceCallFailure", (one) => one.callId === 3)).message, /'level' is missing/);

  const all = await events.get("parameterValues", (one) => one.id === "early");
  assert(all.parameters.some((one) => one.name === "tank.label" && one.value === "water"), show(all));
  client.subscribeParameterUpdates(["tank.capacity"]);
  client.setParameters([{ name: "tank.capacity", value: 2.5 }], "set");
  const set = await events.get("parameterValues", (one) => one.id === "set");
  assert.deepEqual([set.parameters[0].name, set.parameters[0].value], ["tank.capacity", 2.5]);
  await events.get("parameterValues", (one) => one.id === undefined && one.parameters[0]?.name === "tank.capacity");
  client.setParameters([{ name: "tank.capacity", value: "much" }], "wrong");
  await events.get("status", (one) => /capacity|double|number/.test(one.message));
  client.setParameters([{ name: "tank.capacity", value: 1.5 }], "back");
  await events.get("parameterValues", (one) => one.id === "back");

  client.subscribeConnectionGraph();
  const graph = await events.get("connectionGraphUpdate");
  const flow = (topics) => topics.find((one) => one.name === "/pump/flow");
  assert.deepEqual(flow(graph.publishedTopics).publisherIds, ["pump"]);
  assert.deepEqual(flow(graph.subscribedTopics).subscriberIds, ["tank"]);
  const reads = graph.subscribedTopics.find((one) => one.name === "/tank/level");
  assert.deepEqual(reads.subscriberIds, []); // not this client
  typed.write("pump.flow.disconnect()\n");
  await events.get("connectionGraphUpdate", (one) => flow(one.subscribedTopics)?.subscriberIds.length === 0);
  typed.write('connect("pump.flow", "tank.flow", ConnPolicy())\n');

  const log = client.subscribe((await channelOf("/rosout")).id);
  client.setParameters([{ name: "tank.label", value: protocol }], "logged"); // a warning names the client
  const line = await events.get("message", (one) => one.subscriptionId === log);
  assert.equal(typeof JSON.parse(new TextDecoder().decode(line.data)).message, "string");
  client.setParameters([{ name: "tank.label", value: "water" }], "label");
  await events.get("parameterValues", (one) => one.id === "label");
  await events.get("time", (one) => one.timestamp > 1600000000000000000n);
  client.unsubscribe(subscription);
  client.close();
}

let running;
try {
  running = await deploy(deployer, components);
  for (const protocol of ["foxglove.sdk.v1", "foxglove.websocket.v1"]) {
    await look(running.url, running.typed, protocol);
    console.log(`${protocol}: ok`);
  }
} catch (error) {
  console.error(error);
  process.exitCode = 1;
} finally {
  running?.end();
}
