// The light on bodies: from over the viewer's shoulder, like the light of the surfaces, and a little from the
// sky.
import { DirectionalLight, Group, HemisphereLight } from 'three';
import type { Layer, View } from './base/view.ts';

export class Lights implements Layer {
    readonly object = new Group();
    private readonly key = new DirectionalLight(0xffffff, 3);

    constructor() {
        const sky = new HemisphereLight(0xdfe8ff, 0x5a6474, 1.1);
        sky.position.set(0, 0, 1);
        this.object.add(this.key, this.key.target, sky);
        // Pictures of some layers have all light as well: programs depend on how much there is.
        for (const light of [this.key, sky]) light.layers.enableAll();
    }

    update({ camera }: View): void {
        this.key.position.set(0.4, 0.6, 1).applyQuaternion(camera.quaternion);
    }
}
