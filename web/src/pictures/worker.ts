// SPDX-License-Identifier: Apache-2.0
//
// Renders on a processor beside the one that the page needs: gets a Request, and answers with the sums.

import {loadLibrary} from "../library";
import {renderOnProcessor} from "./processor";
import type {Request} from "./renderer";

const loaded = loadLibrary();

addEventListener("message", async ({data}: MessageEvent<Request>) => {
    const sums = renderOnProcessor((await loaded).library, data);
    postMessage(sums, {transfer: [sums.buffer]});
});
