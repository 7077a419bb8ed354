// SPDX-License-Identifier: Apache-2.0

import {useCallback, useEffect, useLayoutEffect, useState} from "preact/hooks";
import type {Wellstrat} from "wellstrat";
import {readAddress, writeAddress, type View} from "./address";
import {Choice} from "./controls";
import {DomainsView} from "./domains/domains_view";
import {PicturesView} from "./pictures/pictures_view";
import {PointsView} from "./points/points_view";
import {setTheme, type Theme} from "./theme";
import licenses from "../THIRD-PARTY.md?raw";
import packageLicenses from "../../bindings/wasm/THIRD-PARTY.md?raw";

const tabs: readonly (readonly [View["view"], string, typeof PointsView])[] = [
    ["points", "Points", PointsView],
    ["domains", "Domains", DomainsView],
    ["pictures", "Pictures", PicturesView],
];

/** The view of the page's address, kept in it; and what was wrong with that. */
function useAddress() {
    const [state, setState] = useState(() => readAddress(location.hash));
    // From the first rendering on, not a frame later, and by what the event says: until it arrives, the
    // view before may have been written over the address.
    useLayoutEffect(() => {
        const follow = ({newURL}: HashChangeEvent) => setState(readAddress(new URL(newURL).hash));
        addEventListener("hashchange", follow);
        return () => removeEventListener("hashchange", follow);
    }, []);
    useEffect(() => {
        if (state.complaints.length > 0) return; // the reader's to see, until something changes
        // Browsers complain of many a second.
        const timer = setTimeout(
            () => history.replaceState(null, "", `#${writeAddress(state.view)}`),
            200,
        );
        return () => clearTimeout(timer);
    }, [state]);
    const change = useCallback(
        (part: Partial<View>) => setState(({view}) => ({view: {...view, ...part}, complaints: []})),
        [],
    );
    return {...state, change};
}

function Share({view}: {view: View}) {
    const [said, setSaid] = useState("");
    async function copy(): Promise<void> {
        const address = `${location.href.split("#")[0]}#${writeAddress(view)}`;
        try {
            await navigator.clipboard.writeText(address);
            setSaid("Copied");
        } catch {
            setSaid("It is in the address bar");
        }
        setTimeout(() => setSaid(""), 3000);
    }
    return (
        <button type="button" onClick={copy} aria-live="polite">
            {said || "Copy the link to this view"}
        </button>
    );
}

function ThemeChoice() {
    const [theme, choose] = useState<Theme>("light dark");
    return (
        <Choice
            label="Colors of the page"
            value={theme}
            options={[
                ["light dark", "As the system"],
                ["light", "Light"],
                ["dark", "Dark"],
            ]}
            onChange={value => {
                choose(value);
                setTheme(value);
            }}
        />
    );
}

interface Props {
    library: Wellstrat;
    /** A sentence where something is missing. */
    complaint?: string;
}

export function App({library, complaint}: Props) {
    const {view, complaints, change} = useAddress();
    const [, , Shown] = tabs.find(([name]) => name === view.view)!;
    return (
        <>
            <header>
                <h1>
                    wellstrat
                    <small>Samples for renderers, to look at</small>
                </h1>
                <ThemeChoice />
                <Share view={view} />
                <div role="tablist" aria-label="Views" onKeyDown={moveFocus}>
                    {tabs.map(([name, title]) => (
                        <button
                            key={name}
                            type="button"
                            role="tab"
                            id={`tab-${name}`}
                            aria-controls="view"
                            aria-selected={view.view === name}
                            tabIndex={view.view === name ? 0 : -1}
                            onClick={() => change({view: name})}
                        >
                            {title}
                        </button>
                    ))}
                </div>
            </header>
            <main>
                {complaint && <p class="notice">{complaint}</p>}
                {complaints.map(each => (
                    <p class="notice" key={each} role="alert">
                        {each}
                    </p>
                ))}
                <div role="tabpanel" id="view" aria-labelledby={`tab-${view.view}`}>
                    <Shown library={library} view={view} change={change} />
                </div>
            </main>
            <footer>
                wellstrat {library.version}, stream {library.streamVersion}, computed here by
                WebAssembly{" "}
                {library.instructionSet === "scalar"
                    ? "without SIMD, which this browser has not: slower, and the same bits"
                    : "with SIMD"}
                .
                <details>
                    <summary>Licenses of what this page carries</summary>
                    <pre>{licenses}</pre>
                    <pre>{packageLicenses}</pre>
                </details>
            </footer>
        </>
    );
}

/** The arrow keys go from tab to tab. */
function moveFocus(event: KeyboardEvent): void {
    const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
    if (!step) return;
    const all = [...document.querySelectorAll<HTMLElement>("[role=tab]")];
    const from = all.indexOf(document.activeElement as HTMLElement);
    const to = all[(from + step + all.length) % all.length];
    to?.focus();
    to?.click();
}
