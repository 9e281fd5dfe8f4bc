// The solid body in the flow: matte grey, so that all colour belongs to the surface.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshLambertMaterial } from 'three';
import type { BodyMesh } from '../../mesh/bodyMesh.ts';

export function createObstacleMesh({ positions, normals, indices }: BodyMesh): Mesh<BufferGeometry, MeshLambertMaterial> {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    geometry.setIndex(new BufferAttribute(indices, 1));
    return new Mesh(geometry, new MeshLambertMaterial({ color: 0xb4bcc9, side: DoubleSide }));
}
