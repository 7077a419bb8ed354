// SPDX-License-Identifier: Apache-2.0

import {useEffect, useRef, useState} from "preact/hooks";
import type {Wellstrat} from "wellstrat";
import type {View} from "../address";
import {nextWay, openRenderer, type Way} from "./open";
import {renderPictures, type Progress} from "./progress";
import {DeviceLost} from "./renderer";
import {scenes} from "./scene";

/** What there is to see of pictures that are being rendered. */
export interface Shown {
    /** How they are rendered, as the reader knows it; empty until that is found. */
    by: string;
    complaints: string[];
    progress?: Progress | undefined;
}

/** Renders the view's pictures, anew when what they show changes. One renders at a time. */
export function usePictures(library: Wellstrat, view: View): Shown {
    const {by, scene, samples, seed, filter} = view;
    const [shown, setShown] = useState<Shown>({by: "", complaints: []});
    const before = useRef<Promise<void>>(Promise.resolve());

    useEffect(() => {
        const stop = new AbortController();
        const update = (part: Partial<Shown>) => {
            if (!stop.signal.aborted) setShown(old => ({...old, ...part}));
        };
        const job = {scene: scenes[scene], samples, seed, sigma: Number(filter)};

        async function run(wish: Way | "auto", complaints: string[]): Promise<void> {
            const opened = await openRenderer(library, wish);
            const {renderer} = opened;
            const all = [...complaints, ...opened.complaints];
            update({by: renderer.name, complaints: all});
            try {
                await renderPictures(renderer, job, progress => update({progress}), stop.signal);
            } catch (error) {
                if (!(error instanceof DeviceLost)) throw error;
                await run(nextWay(opened.way), [...all, `${renderer.name} lost its device.`]);
            } finally {
                renderer.close();
            }
        }
        before.current = before.current
            .then(() => (stop.signal.aborted ? undefined : run(by, [])))
            .catch((error: Error) =>
                update({by: "", complaints: [`Rendering failed: ${error.message}.`]}),
            );
        return () => stop.abort();
    }, [library, by, scene, samples, seed, filter]);
    return shown;
}
