// SPDX-License-Identifier: Apache-2.0

import {fileURLToPath} from "node:url";
import {viteSingleFile} from "vite-plugin-singlefile";
import {defineConfig} from "vitest/config";

const inTree = (path: string) => fileURLToPath(new URL(`../${path}`, import.meta.url));

// One file without anything beside it, so that it opens from a folder.
export default defineConfig({
    plugins: [viteSingleFile()],
    resolve: {alias: {wellstrat: inTree("build/wasm/package/src/index.js")}},
    esbuild: {jsx: "automatic", jsxImportSource: "preact"},
    build: {
        target: "es2022",
        outDir: inTree("build/page"),
        emptyOutDir: true,
        assetsInlineLimit: Number.MAX_SAFE_INTEGER,
        chunkSizeWarningLimit: 2000,
    },
    server: {fs: {allow: [".."]}},
    test: {testTimeout: 200_000, hookTimeout: 200_000, expect: {poll: {timeout: 30_000}}},
});
