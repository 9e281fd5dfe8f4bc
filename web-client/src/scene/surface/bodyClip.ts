// Cuts the solid body by the planes that cut the surfaces.
import { type Material, Plane, Vector3 } from 'three';

/** @param planes (n, w): nothing is left where n . point > w */
export function clipMaterial(material: Material, planes: readonly (readonly [number, number, number, number])[]): void {
    const cutting = planes.filter(([x, y, z]) => x !== 0 || y !== 0 || z !== 0);
    material.clippingPlanes = cutting.map(([x, y, z, w]) => new Plane(new Vector3(-x, -y, -z), w));
    material.needsUpdate = true;
}
