// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Deployers that judges look at.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";

const script = `
import("filling")
loadComponent("tank", "filling::Tank")
loadComponent("pump", "filling::Pump")
connect("pump.flow", "tank.flow", ConnPolicy())
tank.capacity = 1.5
tank.configure()
tank.start()
`;

// A deployer that has executed the script, in a folder of its own, its environment, and the address of its live window.
export async function deploy(deployer, components) {
  const folder = mkdtempSync(join(tmpdir(), "judge-"));
  writeFileSync(join(folder, "app.ops"), script);
  const env = { ...process.env, RTT_COMPONENT_PATH: components, XDG_RUNTIME_DIR: folder, ORO_LOGFILE: "/dev/null" };
  const program = spawn(deployer, ["-s", "app.ops", "--web=127.0.0.1:0", "--web-allow=properties,operations"], {
    cwd: folder,
    env,
    stdio: ["pipe", "pipe", "inherit"],
  });
  const end = () => {
    program.kill("SIGTERM");
    rmSync(folder, { recursive: true });
  };
  for await (const line of createInterface({ input: program.stdout })) {
    const url = /live window: (\S+)/.exec(line);
    if (url) return { url: url[1], typed: program.stdin, folder, env, end };
  }
  throw new Error("the deployer ended");
}
