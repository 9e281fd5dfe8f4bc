// A point or a direction of space.
export type Vec3 = [number, number, number];

export function isVec3(value: unknown): value is Vec3 {
    return Array.isArray(value) && value.length === 3 && value.every(Number.isFinite);
}
