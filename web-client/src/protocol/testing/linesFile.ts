// A file of streamlines as the server writes it.
export interface WrittenLines {
    /** x, y, z and the value of each point of each line. */
    lines: readonly (readonly (readonly [number, number, number, number])[])[];
    outside?: number;
    cut?: number;
}

export function linesFileOf({ lines, outside = 0, cut = 0 }: WrittenLines): ArrayBuffer {
    const points = lines.flat();
    const bytes = new ArrayBuffer(88 + 4 * (2 * lines.length + 1) + 16 * points.length);
    const view = new DataView(bytes);
    [0x57, 0x53, 0x54, 1].forEach((byte, i) => view.setUint8(i, byte));
    let at = 4;
    const whole = (value: number): void => {
        view.setUint32(at, value, true);
        at += 4;
    };
    [lines.length, points.length, lines.length + outside, outside, 0, 0, 0, 0, cut].forEach(whole);
    view.setFloat64(64, 10, true);
    at = 88;
    let passed = 0;
    for (const line of [[], ...lines]) whole((passed += line.length));
    lines.forEach((_, i) => whole(i));
    const number = (value: number): void => {
        view.setFloat32(at, value, true);
        at += 4;
    };
    points.forEach(([x, y, z]) => [x, y, z].forEach(number));
    points.forEach(([, , , value]) => number(value));
    return bytes;
}
