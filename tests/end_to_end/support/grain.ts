// The grain of the flow texture, looked at pixel by pixel: which way it lies beside the flow on the screen, and how far it has gone.
import type { Page } from 'playwright-core';

/** Half the side of a square of pixels that is looked at. */
const reach = 8;
/** So many neighbouring squares are looked at together: in one of them there are too few grains to tell a direction to some degrees. */
const together = 25;

/** Where a vertex is on the screen, and which way the flow goes there, as an angle on the screen. */
export interface Place {
    x: number;
    y: number;
    flow: number;
    /** Pixels in a unit of time. */
    speed: number;
}
/** Second moments of the slope of the light, along the flow and across it. */
type Moments = [along: number, mixed: number, across: number];

/** What is looked at, and in units of length: what is at most between a vertex and what is seen there, and across a square of pixels. */
export interface Ground {
    of: 'surface' | 'body';
    near: number;
    across: number;
}

/** Vertices around which it fills a square of pixels, without a fold or an edge in it. */
export async function places(page: Page, every: number, ground: Ground): Promise<Place[]> {
    return page.evaluate(
        ([n, around, { of, near, across }]) => {
            const hook = window.wakesurf!;
            const box = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!.getBoundingClientRect();
            const middle = { x: Math.round(box.left + box.width / 2), y: Math.round(box.top + box.height / 2) };
            const grid = hook.pickGrid(middle, Math.floor(box.height / 2) - 2);
            const gap = (x: number, y: number, from: readonly number[]): number => {
                const hit = grid.hits[(y - grid.corner.y) * grid.size + x - grid.corner.x];
                const seen = hit !== null && hit !== undefined && (hit.surface === null) === (of === 'body');
                return seen ? Math.hypot(...hit.point.map((c, i) => c - from[i]!)) : Infinity;
            };
            return (of === 'body' ? hook.bodyVertices(n) : hook.vertices(n)).flatMap(({ point, normal, flow }) => {
                const at = hook.project(point);
                if (at === null || flow === null) return [];
                const [x, y] = [Math.round(at.x), Math.round(at.y)];
                const left = Math.min(x - grid.corner.x, y - grid.corner.y);
                if (left < around || Math.max(x - grid.corner.x, y - grid.corner.y) >= grid.size - around) return [];
                // In front of it there may be another sheet.
                if (!(gap(x, y, point) < near)) return [];
                for (let row = -around; row <= around; ++row) {
                    for (let column = -around; column <= around; ++column) {
                        if (!(gap(x + column, y + row, point) < across)) return [];
                    }
                }
                // Seen edge-on, a square of pixels is a long way on the surface.
                const sight = point.map((c, i) => hook.camera.position[i]! - c);
                const facing = Math.abs(sight.reduce((sum, c, i) => sum + c * normal[i]!, 0)) / Math.hypot(...sight);
                const through = flow.reduce((sum, v, i) => sum + v * normal[i]!, 0);
                const along = flow.map((v, i) => v - through * normal[i]!);
                const speed = Math.hypot(...along);
                if (facing < 0.35 || !(speed > 0.4 * Math.hypot(...flow))) return [];
                const step = (0.4 * near) / speed;
                const on = hook.project(point.map((c, i) => c + step * along[i]!) as typeof point)!;
                const [u, v] = [on.x - at.x, on.y - at.y];
                return [{ x, y, flow: Math.atan2(v, u), speed: Math.hypot(u, v) / step }];
            });
        },
        [every, reach, ground] as const,
    );
}

/**
 * How the light changes around places, in the picture as it is now, over what it was in the picture without texture.
 * @param without  the light that this has returned for that; empty: it is that one
 */
export async function momentsAround(
    page: Page,
    around: readonly Place[],
    without: readonly number[] = [],
): Promise<{ moments: Moments[]; light: number[] }> {
    return page.evaluate(
        ([list, half, plain]) => {
            const side = 2 * half + 1;
            const points = list.flatMap(({ x, y }) =>
                Array.from({ length: side * side }, (_, i) => ({ x: x + (i % side) - half, y: y + Math.floor(i / side) - half })),
            );
            const light = window.wakesurf!.pixelsAt(points).map(([r, g, b]) => 0.21 * r + 0.72 * g + 0.07 * b);
            const moments = list.map(({ flow }, at): [number, number, number] => {
                const value = (row: number, column: number): number => {
                    const i = at * side * side + row * side + column;
                    return light[i]! / Math.max(plain[i] ?? 1, 1);
                };
                const [cos, sin] = [Math.cos(flow), Math.sin(flow)];
                const sums: [number, number, number] = [0, 0, 0];
                for (let r = 1; r < side - 1; ++r) {
                    for (let c = 1; c < side - 1; ++c) {
                        // Scharr's slopes, which are alike in all directions.
                        const row = (of: number): number => value(of, c + 1) - value(of, c - 1);
                        const column = (of: number): number => value(r + 1, of) - value(r - 1, of);
                        const dx = 3 * row(r - 1) + 10 * row(r) + 3 * row(r + 1);
                        const dy = 3 * column(c - 1) + 10 * column(c) + 3 * column(c + 1);
                        const [along, across] = [dx * cos + dy * sin, dy * cos - dx * sin];
                        sums[0] += along * along;
                        sums[1] += along * across;
                        sums[2] += across * across;
                    }
                }
                return sums;
            });
            return { moments, light: plain.length === 0 ? light : [] };
        },
        [around as Place[], reach, without as number[]] as const,
    );
}

function added(all: readonly Moments[]): Moments {
    return all.reduce(([a, b, c], [d, e, f]) => [a + d, b + e, c + f], [0, 0, 0]);
}

/** Degrees between the grain and the flow at each place, ascending. @param pictures  moments of several, of different noise */
export function degreesOff(around: readonly Place[], pictures: readonly (readonly Moments[])[]): number[] {
    const moments = around.map((_, i) => added(pictures.map((of) => of[i]!)));
    const off = around.map(({ x, y }) => {
        const near = around
            .map((other, i) => ({ i, apart: Math.hypot(other.x - x, other.y - y) }))
            .sort((a, b) => a.apart - b.apart);
        return offOf(added(near.slice(0, together).map(({ i }) => moments[i]!)));
    });
    return off.sort((a, b) => a - b);
}

/** Degrees between the grain, which lies where the light changes least, and the flow. */
function offOf([along, mixed, across]: Moments): number {
    const steepest = 0.5 * Math.atan2(2 * mixed, along - across);
    const apart = Math.abs(Math.abs(steepest) - Math.PI / 2);
    return (180 / Math.PI) * apart;
}

/** The light of squares of pixels. */
export async function lightAround(page: Page, around: readonly Place[]): Promise<number[][]> {
    const { light } = await momentsAround(page, around);
    const size = (2 * reach + 1) ** 2;
    return around.map((_, i) => light.slice(i * size, (i + 1) * size));
}

/** What goes with the flow in the time `passed`, over how far it should: the median of the places. Lights are over those of `plain`. */
export function shiftRatio(
    around: readonly Place[],
    plain: readonly number[][],
    [before, after]: readonly [readonly number[][], readonly number[][]],
    passed: number,
): number {
    const over = (light: readonly number[], i: number): number[] => light.map((each, k) => each / Math.max(plain[i]![k]!, 1));
    const ratios = around.map(({ flow, speed }, i) => {
        const shift = shiftOf(over(before[i]!, i), over(after[i]!, i), flow);
        return shift / (speed * passed);
    });
    ratios.sort((a, b) => a - b);
    return ratios[Math.floor(ratios.length / 2)]!;
}

/** How far along a direction the second square is the first one moved: where they agree best. */
function shiftOf(first: readonly number[], second: readonly number[], direction: number): number {
    const side = 2 * reach + 1;
    const mean = (of: readonly number[]): number => of.reduce((a, b) => a + b) / of.length;
    const [m, n] = [mean(first), mean(second)];
    let [best, at] = [-Infinity, 0];
    for (let by = -8; by <= 8; by += 0.25) {
        const [u, v] = [by * Math.cos(direction), by * Math.sin(direction)];
        let [sum, a, b] = [0, 0, 0];
        for (let row = 0; row < side; ++row) {
            for (let column = 0; column < side; ++column) {
                const [x, y] = [Math.round(column + u), Math.round(row + v)];
                if (x < 0 || y < 0 || x >= side || y >= side) continue;
                const [p, q] = [first[row * side + column]! - m, second[y * side + x]! - n];
                sum += p * q;
                a += p * p;
                b += q * q;
            }
        }
        const agreement = sum / Math.sqrt(a * b || 1);
        if (agreement > best) [best, at] = [agreement, by];
    }
    return at;
}
