// SPDX-License-Identifier: Apache-2.0
//
// The installed package in headless Chromium: golden values of both modules, and the example's page.

import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import { text } from "node:stream/consumers";
import { test } from "node:test";
import { setTimeout } from "node:timers/promises";
import { fileURLToPath } from "node:url";

const here = fileURLToPath(new URL(".", import.meta.url));
const golden = fileURLToPath(new URL("../../../tests/golden/", import.meta.url));
const kinds = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm" };

const goldenPage = `<!DOCTYPE html>
<script type="importmap">{ "imports": { "wellstrat": "./node_modules/wellstrat/src/index.js" } }</script>
<p>loading ...</p>
<script type="module">
  import { load } from "wellstrat";
  import { checkGolden } from "./golden.js";
  const texts = await Promise.all(["samples", "joint", "long", "blue"].map(async (name) =>
    (await fetch("golden/" + name + ".txt")).text()));
  const said = [];
  for (const simd of [true, false]) {
    const library = await load({ simd });
    const { agreed, faults } = checkGolden(library, texts);
    said.push(library.instructionSet + ": " + agreed + " agree, " + faults.length + " do not");
  }
  document.querySelector("p").textContent = said.join("; ");
</script>`;

function chromium() {
  for (const name of ["chromium", "chromium-browser"]) {
    try {
      return execFileSync("which", [name], { encoding: "utf8" }).trim();
    } catch { /* the next one */ }
  }
  return undefined;
}

/** Shows a page, and tells the server what its paragraph says once it has loaded. */
const watchPage = `<!DOCTYPE html>
<iframe></iframe>
<script>
  const frame = document.querySelector("iframe");
  frame.src = location.hash.slice(1);
  const timer = setInterval(() => {
    const text = frame.contentDocument?.querySelector("p")?.textContent ?? "loading ...";
    if (text === "loading ...") return;
    clearInterval(timer);
    fetch("said", { method: "POST", body: text });
  }, 50);
</script>`;

/** The file that a page asks for. */
function contentOf(path) {
  if (path === "/golden.html") return goldenPage;
  if (path === "/watch.html") return watchPage;
  return readFileSync(path.startsWith("/golden/") ? join(golden, path.slice(8)) : join(here, path));
}

function serve(request, response) {
  try {
    const content = contentOf(request.url);
    response.setHeader("Content-Type", kinds[extname(request.url)] ?? "text/plain");
    response.end(content);
  } catch {
    response.statusCode = 404;
    response.end();
  }
}

/** What the paragraph of a page says, once its scripts are done. */
async function paragraphOf(page) {
  let tell;
  const said = new Promise((resolve) => { tell = resolve; });
  const server = createServer(async (request, response) => {
    if (request.method !== "POST") return serve(request, response);
    tell(await text(request));
    response.end();
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const profile = mkdtempSync(join(tmpdir(), "wellstrat-"));
  const browser = spawn(chromium(), ["--headless", "--no-sandbox", "--disable-gpu",
    "--disable-dev-shm-usage", "--remote-debugging-port=0", `--user-data-dir=${profile}`,
    `http://127.0.0.1:${server.address().port}/watch.html#${page}`],
  { env: { ...process.env, HOME: profile }, stdio: "ignore" });
  const ended = once(browser, "exit");
  const late = new AbortController();
  try {
    return await Promise.race([said, setTimeout(100000, "nothing", { signal: late.signal })]);
  } finally {
    late.abort();
    browser.kill();
    await ended;
    server.closeAllConnections?.();
    server.close();
    rmSync(profile, { recursive: true, force: true, maxRetries: 10, retryDelay: 200 });
  }
}

const skip = chromium() === undefined && "no Chromium";

test("golden values in Chromium", { skip }, async () => {
  assert.match(await paragraphOf("golden.html"),
    /^simd128: [45]\d{3} agree, 0 do not; scalar: [45]\d{3} agree, 0 do not$/);
});

test("the example's page", { skip }, async () => {
  assert.equal(await paragraphOf("index.html"), "1024 points by simd128");
});
