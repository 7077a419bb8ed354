// SPDX-License-Identifier: Apache-2.0
//
// The error of an integral over the lens of a camera, by 1 to 4096 samples of each generator: how
// much of the lens sees a light, as an average over 200 pixels.

import { load } from "wellstrat";

const wellstrat = await load();
const pixels = 200;
const radius = 0.45;
const seen = (x, y) => (Math.hypot(x - 0.52, y - 0.47) < radius ? 1 : 0);
const exact = Math.PI * radius ** 2;

console.log("samples   random      pmj     long     blue");
for (let count = 1; count <= 4096; count *= 8) {
  const errors = ["random", "pmj", "long", "blue"].map((generator) => {
    let squares = 0;
    for (let pattern = 0; pattern < pixels; ++pattern) {
      const xy = wellstrat.samples(pattern, count, { generator });
      let sum = 0;
      for (let i = 0; i < xy.length; i += 2) sum += seen(xy[i], xy[i + 1]);
      squares += (sum / count - exact) ** 2;
    }
    return Math.sqrt(squares / pixels).toFixed(5).padStart(9);
  });
  console.log(String(count).padStart(7) + errors.join(""));
}
