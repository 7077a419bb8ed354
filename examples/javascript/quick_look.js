// SPDX-License-Identifier: Apache-2.0
import { load } from "wellstrat";

const wellstrat = await load();
const contexts = new Uint32Array(8);
for (let i = 0; i < 4; ++i) { // four samples of pixel (320, 200) in frame 1
  contexts.set(wellstrat.cameraContexts(1, 1, 1, i, { origin: [320, 200] }), 2 * i);
}
const xi = wellstrat.draw(contexts);
const onLight = wellstrat.draw(wellstrat.newDomain(contexts, 0x5d1c9a37)); // an independent domain

const pair = (points, i) => `(${points[2 * i].toFixed(3)}, ${points[2 * i + 1].toFixed(3)})`;
for (let i = 0; i < 4; ++i) {
  console.log(`sample ${i}: pixel ${pair(xi, i)}  light ${pair(onLight, i)}`);
}
