// SPDX-License-Identifier: Apache-2.0

interface Props {
    sample: number;
    /** Names of coordinates, and what they are. */
    coordinates: readonly (readonly [string, number])[];
}

/** The numbers of a marked sample, which stay in view. */
export function Readout({sample, coordinates}: Props) {
    const list = coordinates.map(([name, value]) => `${name} = ${value.toFixed(5)}`).join(", ");
    return (
        <p class="readout" role="status">
            Sample {sample}: {list}
        </p>
    );
}
