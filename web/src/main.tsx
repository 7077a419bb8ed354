// SPDX-License-Identifier: Apache-2.0

import {render} from "preact";
import {App} from "./app";
import {loadLibrary} from "./library";
import "./style.css";

const page = document.getElementById("page")!;
try {
    render(<App {...await loadLibrary()} />, page);
} catch (error) {
    page.textContent = `The samples cannot be computed here: ${(error as Error).message}`;
}
