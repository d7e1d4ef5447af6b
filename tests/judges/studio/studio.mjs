// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Foxglove Studio, in a browser, shows a real deployer and a recording of it.
//
//   node studio.mjs DEPLOYER ORO COMPONENTS
//
// The exit status is 1 if something is not shown as it should be, 77 without the packages, which `./dev stress` installs.
import { execFileSync } from "node:child_process";
import { createReadStream, existsSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { dirname, extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";

import { deploy } from "../deployed.mjs";

const [deployer, oro, components] = process.argv.slice(2);
const browser = "/usr/bin/chromium-headless-shell";
if (!existsSync("node_modules") || !existsSync(browser)) {
  console.log("left out: Foxglove Studio or its browser is not installed: ./dev stress");
  process.exit(77);
}
// The packages are in the folder in which this runs, not where this file is.
const { default: puppeteer } = createRequire(join(process.cwd(), "index.js"))("puppeteer-core");

const page = join(dirname(fileURLToPath(import.meta.url)), "page.html");
const types = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm" };

// Serves the page, the packages that it loads, and the files of a folder below /files/, also in parts.
function serve(folder) {
  const fileOf = (path) => {
    if (path === "/") return page;
    if (path.startsWith("/files/")) return join(folder, path.slice(7));
    const asset = join("node_modules/@foxglove/studio-base/assets", path);
    return existsSync(asset) ? asset : join("node_modules", path);
  };
  const server = createServer((request, response) => {
    const file = fileOf(normalize(new URL(request.url, "http://localhost").pathname));
    if (!existsSync(file)) return response.writeHead(404).end();
    const { size } = statSync(file);
    const part = /bytes=(\d+)-(\d*)/.exec(request.headers.range ?? "");
    const start = part ? Number(part[1]) : 0;
    const end = part?.[2] ? Number(part[2]) : size - 1;
    response.writeHead(part ? 206 : 200, {
      "accept-ranges": "bytes",
      "content-length": end - start + 1,
      "content-type": types[extname(file)] ?? "application/octet-stream",
      ...(part && { "content-range": `bytes ${start}-${end}/${size}` }),
    });
    if (request.method === "HEAD") return response.end();
    createReadStream(file, { start, end }).pipe(response);
  });
  return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(server)));
}

// Waits until the page shows all of these texts.
async function look(window, what, url, wanted) {
  const tab = await window.newPage();
  await tab.setViewport({ width: 1600, height: 1000 });
  const errors = [];
  tab.on("pageerror", (error) => errors.push(error));
  await tab.goto(url, { timeout: 120000 });
  let text = "";
  const missing = () => wanted.filter((one) => !one.test(text));
  for (let tries = 0; tries === 0 || (tries < 300 && missing().length > 0); ++tries) {
    await new Promise((resolve) => setTimeout(resolve, 200));
    text = await tab.evaluate(() => document.body.innerText);
  }
  if (missing().length > 0) throw new Error(`${what}: not shown: ${missing().join(", ")}; but:\n${text}`);
  if (errors.length > 0) throw new Error(`${what}: Foxglove Studio failed:\n${errors.join("\n")}`);
  console.log(`${what}: ok`);
  await tab.close();
}

let running, server, window;
try {
  running = await deploy(deployer, components);
  server = await serve(running.folder);
  window = await puppeteer.launch({ executablePath: browser, headless: "shell", args: ["--no-sandbox", "--disable-gpu"] });
  const home = `http://localhost:${server.address().port}/?layoutId=it&ds=`;
  const command = (...words) => execFileSync(oro, words, { env: running.env, cwd: running.folder, stdio: "pipe" });
  command("call", "tank.fill", "1.25");
  command("set", "tank.label", "oil"); // a warning in the log names the caller
  const channel = /\/tank\/level\s+std_msgs\/msg\/Float64/;
  const year = `${new Date().getUTCFullYear()}-`;
  await look(window, "live window", `${home}foxglove-websocket&ds.url=${encodeURIComponent(running.url)}`, [
    channel,
    new RegExp(`START TIME\\s+${year}`),
    /data\s+1.25/,
    /tank\.capacity\s+1\.5/,
    /tank\.label\s+"oil"/,
  ]);
  command("record", "-o", "run.mcap", "--duration", "2");
  const recording = `http://localhost:${server.address().port}/files/run.mcap`;
  await look(window, "recording", `${home}remote-file&ds.url=${encodeURIComponent(recording)}`, [
    channel,
    new RegExp(`START TIME\\s+${year}`),
    /data\s+1.25/,
  ]);
} catch (error) {
  console.error(error);
  process.exitCode = 1;
} finally {
  await window?.close();
  server?.close();
  running?.end();
}
