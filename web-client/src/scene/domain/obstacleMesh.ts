// The solid body in the flow: matte grey, so that all colour belongs to the surface.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshLambertMaterial } from 'three';

export function createObstacleMesh(positions: Float32Array, indices: Uint32Array): Mesh<BufferGeometry, MeshLambertMaterial> {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setIndex(new BufferAttribute(indices, 1));
    // Flat: the body follows the cells of the solid mask, whose edges are really there.
    const material = new MeshLambertMaterial({
        color: 0xb4bcc9,
        flatShading: true,
        side: DoubleSide,
    });
    return new Mesh(geometry, material);
}
