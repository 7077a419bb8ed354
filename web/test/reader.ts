// SPDX-License-Identifier: Apache-2.0

import axe from "axe-core";
import type {Page} from "playwright-core";

/** What keeps some readers from reading the page as it is, as rules and examples. */
export async function obstacles(page: Page): Promise<[string, string][]> {
    await page.evaluate(axe.source);
    const {violations} = await page.evaluate(() =>
        (window as unknown as {axe: typeof axe}).axe.run(),
    );
    return violations.map(({id, nodes}) => [id, nodes[0]!.html]);
}

/** How much wider than the window the page is. */
export function overflow(page: Page): Promise<number> {
    return page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
}
