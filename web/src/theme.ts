// SPDX-License-Identifier: Apache-2.0
//
// Light and dark: colors are custom properties of style.css, and pictures that are drawn by programs
// ask here for what they are now.

import {useEffect, useReducer} from "preact/hooks";

const names = ["paper", "ink", "muted", "line", "accent", "crowded", "empty", "surface"] as const;
export type Palette = Record<(typeof names)[number], string>;

const systemIsDark = matchMedia("(prefers-color-scheme: dark)");
const changed = new EventTarget();
systemIsDark.addEventListener("change", () => changed.dispatchEvent(new Event("theme")));

export type Theme = "light dark" | "light" | "dark";

export function setTheme(theme: Theme): void {
    document.documentElement.style.colorScheme = theme;
    changed.dispatchEvent(new Event("theme"));
}

export function palette(): Palette {
    const style = getComputedStyle(document.documentElement);
    return Object.fromEntries(
        names.map(name => [name, style.getPropertyValue(`--${name}`)]),
    ) as Palette;
}

function isDark(): boolean {
    const scheme = document.documentElement.style.colorScheme;
    return scheme === "dark" || (scheme !== "light" && systemIsDark.matches);
}

/** One of `count` colors that can be told from each other, in their order. */
export function colorOf(index: number, count: number): string {
    return `oklch(${isDark() ? 0.76 : 0.56} 0.15 ${40 + (300 * index) / count})`;
}

/** Renders the component anew when the theme changes. */
export function useTheme(): void {
    const [, again] = useReducer((n: number, _: Event) => n + 1, 0);
    useEffect(() => {
        changed.addEventListener("theme", again);
        return () => changed.removeEventListener("theme", again);
    }, []);
}
