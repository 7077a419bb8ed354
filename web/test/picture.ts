// SPDX-License-Identifier: Apache-2.0
//
// Takes the page's picture for README.md: `scripts/page --picture FILE.png`.

import {launch, open} from "./chromium";

const browser = await launch();
const {page} = await open(browser, "#color=x&count=64", {
    viewport: {width: 1000, height: 640},
    colorScheme: "light",
    deviceScaleFactor: 1,
});
await page.getByText("Mean of 32 patterns.").waitFor();
await page.screenshot({path: process.argv.at(-1)!});
await browser.close();
