// What a painted mask shows at a place of its surface, as the shader looks it up.
import { maskSize, type SurfaceMask } from '../scene/surface/surfaceMask.ts';

export function revealedAt({ texels, tStart, tLength }: SurfaceMask, s: number, t: number): boolean {
    const texelOf = (part: number): number => Math.min(maskSize - 1, Math.max(0, Math.floor(part * maskSize)));
    return texels[texelOf((t - tStart) / tLength) * maskSize + texelOf(s)]! > 127;
}
