// SPDX-License-Identifier: Apache-2.0

import {useEffect, useRef, useState} from "preact/hooks";
import {Canvas} from "../canvas";
import {Plot} from "../plot";
import {palette, useTheme, type Palette} from "../theme";
import {drawAxes, margin, sideOf} from "./scatter";
import {radialMean, spectrumOf, type Spectrum} from "./spectrum";

/** x and y of the points of the i-th of several patterns. */
export type PointsOfPattern = (i: number) => {x: Float32Array; y: Float32Array};

const patterns = 32; // a power of two
const restart = 100; // milliseconds between first spectra of other points
const brightest = 2; // the power that is as dark as it gets

interface Mean {
    spectrum: Spectrum;
    patterns: number;
}

/** The mean spectrum of 1, 2, 4 and more patterns, begun anew for other points. */
function useMeanSpectrum(points: PointsOfPattern): Mean | undefined {
    const [mean, setMean] = useState<Mean>();
    const lastStart = useRef(0);
    useEffect(() => {
        let sums: Float32Array | undefined;
        let timer = 0;
        function add(i: number): void {
            const {x, y} = points(i);
            const {reach, power: more} = spectrumOf(x, y);
            sums = sums ? sums.map((sum, k) => sum + more[k]!) : more;
            const done = i + 1;
            if ((done & i) === 0) {
                // 1, 2, 4, ...
                const power = sums.map(sum => sum / done);
                setMean({spectrum: {reach, power}, patterns: done});
            }
            if (done < patterns) timer = window.setTimeout(add, 20, done);
        }
        // While a slider is dragged, points change each frame: take some of them.
        const wait = lastStart.current + restart - performance.now();
        timer = window.setTimeout(() => {
            lastStart.current = performance.now();
            add(0);
        }, wait);
        return () => clearTimeout(timer);
    }, [points]);
    return mean;
}

function drawSpectrum(
    context: CanvasRenderingContext2D,
    width: number,
    colors: Palette,
    {reach, power}: Spectrum,
): void {
    const size = 2 * reach + 1;
    const image = new OffscreenCanvas(size, size);
    const drawing = image.getContext("2d")!;
    const pixels = drawing.createImageData(size, size);
    for (let i = 0; i < power.length; ++i) {
        pixels.data[4 * i + 3] = 255 * Math.min(power[i]! / brightest, 1);
    }
    pixels.data[4 * ((power.length - 1) / 2) + 3] = 0; // frequency 0 says how many points there are
    drawing.putImageData(pixels, 0, 0);
    drawing.globalCompositeOperation = "source-in";
    drawing.fillStyle = colors.ink;
    drawing.fillRect(0, 0, size, size);

    const side = sideOf(width);
    context.save();
    context.translate(margin.left, margin.top);
    context.imageSmoothingEnabled = false;
    context.scale(1, -1);
    context.drawImage(image, 0, -side, side, side);
    context.scale(1, -1);
    const marks = [`−${reach}`, `−${reach / 2}`, "0", `${reach / 2}`, `${reach}`];
    drawAxes(context, side, colors, "frequency along x, 1 / length", "frequency along y", marks);
    context.restore();
}

export function SpectrumPanel({points}: {points: PointsOfPattern}) {
    useTheme();
    const mean = useMeanSpectrum(points);
    if (!mean) return null;
    const {spectrum} = mean;
    const radial = radialMean(spectrum);
    const of = mean.patterns === 1 ? "one pattern" : `${mean.patterns} patterns`;
    return (
        <>
            <figure>
                <h2>Spectrum of x and y</h2>
                <Canvas
                    label={`Power spectrum, mean of ${of}`}
                    draw={(context, width, _, colors) =>
                        drawSpectrum(context, width, colors, spectrum)
                    }
                />
                <figcaption>
                    Power, blank for 0 and darkest or lightest from 2 on; independent samples have 1
                    everywhere. Mean of {of}.
                </figcaption>
            </figure>
            <figure>
                <h2>Spectrum by frequency</h2>
                <Plot
                    label={`Mean power at frequencies from 1 to ${spectrum.reach}`}
                    xTitle="frequency, 1 / length of the square"
                    yTitle="power, 1 = independent samples"
                    yRange={[0, 2]}
                    curves={[
                        {name: "samples", color: palette().accent},
                        {name: "independent samples", color: palette().muted, dashed: true},
                    ]}
                    data={[
                        Float64Array.from(radial, (_, i) => i + 1),
                        radial,
                        Float64Array.from(radial, () => 1),
                    ]}
                />
                <figcaption>
                    The mean over all directions. Where it is low, features of that size are
                    integrated with less noise.
                </figcaption>
            </figure>
        </>
    );
}
