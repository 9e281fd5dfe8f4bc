// A small flow at any scale, as a solver far from the origin or in micrometres writes it: .vti files and their .pvd.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Vec3 } from '../../../web-client/src/protocol/messages.ts';

export interface ScaledFlow {
    folder: string;
    name: string;
    /** Lowest corner of the domain. */
    origin: Vec3;
    /** Length along x; along y and z half of it. */
    size: number;
    times: readonly number[];
}

/** Sheared flow along x that crosses the domain in the time of the data. Returns the file to serve. */
export function writeScaledFlow({ folder, name, origin, size, times }: ScaledFlow): string {
    mkdirSync(folder, { recursive: true });
    const nodes = [17, 9, 9];
    const spacing = size / 16;
    const speed = size / (times.at(-1)! - times[0]!);
    const extent = nodes.map((count) => `0 ${count - 1}`).join(' ');
    const entries = times.map((time, step) => {
        const values: string[] = [];
        for (let k = 0; k < nodes[2]!; ++k) {
            for (let j = 0; j < nodes[1]!; ++j) {
                for (let i = 0; i < nodes[0]!; ++i) {
                    const turned = Math.sin(i / 3 + step / 2) * 0.2;
                    values.push(`${speed * (0.6 + 0.1 * j)} ${speed * turned} ${(speed * turned * (k - 4)) / 8}`);
                }
            }
        }
        const file = `${name}_${step}.vti`;
        const piece = `<PointData Vectors="U"><DataArray type="Float64" Name="U" NumberOfComponents="3" format="ascii">
${values.join('\n')}
</DataArray></PointData>`;
        const image = `WholeExtent="${extent}" Origin="${origin.join(' ')}" Spacing="${spacing} ${spacing} ${spacing}"`;
        writeFileSync(
            join(folder, file),
            `<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian"><ImageData ${image}><Piece Extent="${extent}">
${piece}
</Piece></ImageData></VTKFile>
`,
        );
        return `<DataSet timestep="${time}" part="0" file="${file}"/>`;
    });
    const series = join(folder, `${name}.pvd`);
    writeFileSync(
        series,
        `<?xml version="1.0"?>
<VTKFile type="Collection" version="0.1"><Collection>
${entries.join('\n')}
</Collection></VTKFile>
`,
    );
    return series;
}
