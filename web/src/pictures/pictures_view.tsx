// SPDX-License-Identifier: Apache-2.0
//
// The third view: pictures by several kinds of samples, and their errors.

import {useMemo} from "preact/hooks";
import {maxPattern, maxPictureSamples, type View} from "../address";
import {Canvas} from "../canvas";
import {Choice, CountSlider, NumberField} from "../controls";
import {Plot} from "../plot";
import type {ViewProps} from "../points/points_view";
import {colorOf, useTheme} from "../theme";
import {encode} from "./film";
import {compared, pictureSize, type Errors} from "./progress";
import {usePictures, type Shown} from "./use_pictures";

const titles: Record<(typeof compared)[number], string> = {
    white: "white",
    pmj: "pmj",
    joint: "joint",
    blue: "blue",
};

const explained: Record<(typeof compared)[number], string> = {
    white: "independent",
    pmj: "stratified",
    joint: "with slots",
    blue: "over pixels",
};

const sceneNames: readonly (readonly [View["scene"], string])[] = [
    ["shadow", "A soft shadow"],
    ["lens", "Depth of field"],
    ["both", "Both"],
];

const wayNames: readonly (readonly [View["by"], string])[] = [
    ["auto", "The best that there is"],
    ["webgpu", "WebGPU"],
    ["webgl2", "WebGL2"],
    ["wasm", "WebAssembly"],
];

function PictureCanvas({label, sums, count}: {label: string; sums: Float32Array; count: number}) {
    const image = useMemo(
        () => new ImageData(encode(sums, count), pictureSize, pictureSize),
        [sums, count],
    );
    return (
        <Canvas
            label={label}
            class="picture"
            draw={(context, width, height) => {
                const source = new OffscreenCanvas(pictureSize, pictureSize);
                source.getContext("2d")!.putImageData(image, 0, 0);
                context.imageSmoothingEnabled = false;
                context.drawImage(source, 0, 0, width, height);
            }}
        />
    );
}

/** The errors of one kind over those of independent samples, and these themselves. */
function ErrorTable({errors}: {errors: Errors}) {
    const row = (name: string, values: number[]) => (
        <tr>
            <th scope="row">{name}</th>
            <td>{values[0]!.toPrecision(3)}</td>
            {values.slice(1).map((value, i) => (
                <td key={i}>× {(value / values[0]!).toFixed(2)}</td>
            ))}
        </tr>
    );
    return (
        <table>
            <caption class="unseen">Root mean square errors</caption>
            <thead>
                <tr>
                    <th scope="col">Error at {errors.samples}</th>
                    {compared.map(source => (
                        <th scope="col" key={source}>
                            {titles[source]}
                        </th>
                    ))}
                </tr>
            </thead>
            <tbody>
                {row("as rendered", errors.raw)}
                {row("filtered", errors.filtered)}
            </tbody>
        </table>
    );
}

function ErrorPlot({errors}: {errors: Errors[]}) {
    const data = useMemo(
        () =>
            [
                errors.map(each => each.samples),
                ...compared.flatMap((_, i) => [
                    errors.map(each => each.raw[i]!),
                    errors.map(each => each.filtered[i]!),
                ]),
            ] as [number[], ...number[][]],
        [errors],
    );
    const curves = compared.flatMap((source, i) => [
        {name: titles[source], color: colorOf(i, compared.length)},
        {name: `${titles[source]}, filtered`, color: colorOf(i, compared.length), dashed: true},
    ]);
    return (
        <section class="wide">
            <h2>Error while samples are added</h2>
            <ul class="keys">
                {compared.map((source, i) => (
                    <li key={source}>
                        <i style={{color: colorOf(i, compared.length)}} />
                        {titles[source]}
                    </li>
                ))}
                <li>
                    <i class="dashed" />
                    filtered
                </li>
            </ul>
            <Plot
                label="Error of each picture against its samples"
                xTitle="samples of each pixel"
                yTitle="root mean square error, radiance"
                logarithmic
                curves={curves}
                data={data}
            />
            <ErrorTable errors={errors.at(-1)!} />
        </section>
    );
}

export function PicturesView({library, view, change}: ViewProps) {
    useTheme();
    const {scene, samples, seed, filter, by} = view;
    const shown = usePictures(library, view);
    const {progress} = shown;
    return (
        <div class="layout">
            <div class="controls">
                <CountSlider
                    label="Samples of each pixel"
                    value={samples}
                    high={maxPictureSamples}
                    onChange={value => change({samples: value})}
                />
                <Choice
                    label="Scene"
                    value={scene}
                    options={sceneNames}
                    onChange={value => change({scene: value})}
                />
                <Choice
                    label="Filter, standard deviation"
                    value={filter}
                    options={[
                        ["1", "1 pixel"],
                        ["2", "2 pixels"],
                        ["4", "4 pixels"],
                    ]}
                    onChange={value => change({filter: value})}
                />
                <NumberField
                    label="Seed"
                    value={seed}
                    low={0}
                    high={maxPattern}
                    onChange={value => change({seed: value})}
                />
                <Choice
                    label="Rendered by"
                    value={by}
                    options={wayNames}
                    onChange={value => change({by: value})}
                />
            </div>
            <div>
                {shown.complaints.length > 0 && (
                    <p class="notice" role="status">
                        {shown.complaints.join(" ")} {shown.by && `${shown.by} does it.`}
                    </p>
                )}
                <p role="status" id="progress">
                    {progressText(shown, samples)}
                </p>
                {progress && (
                    <>
                        <div class="panels four">
                            {compared.map((source, i) => (
                                <figure key={source}>
                                    <h2>{titles[source]}</h2>
                                    <p class="hint">{explained[source]}</p>
                                    <PictureCanvas
                                        label={`${titles[source]}, as rendered`}
                                        sums={progress.film.raw[i]!}
                                        count={progress.film.samples}
                                    />
                                    <figcaption>as rendered</figcaption>
                                    <PictureCanvas
                                        label={`${titles[source]}, filtered`}
                                        sums={progress.film.filtered[i]!}
                                        count={progress.film.samples}
                                    />
                                    <figcaption>filtered</figcaption>
                                </figure>
                            ))}
                        </div>
                        <ErrorPlot errors={progress.errors} />
                    </>
                )}
            </div>
        </div>
    );
}

function progressText({by, complaints, progress}: Shown, all: number): string {
    if (!by) return complaints.length > 0 ? "" : "Looking for a way to render.";
    if (!progress) return `Rendering by ${by}.`;
    const done = `${progress.film.samples} of ${all} samples of each pixel, rendered by ${by}.`;
    return `${done} Errors are those against a picture of ${progress.reference} other samples.`;
}
