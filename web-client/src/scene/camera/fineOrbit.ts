// Orbit controls for domains of any size: three's own tell of no movement shorter than a thousandth of a
// unit, which in a domain of micrometres is every one, so that nothing would be drawn again.
import { Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

/** Is a part of the distance to the target: far less than a pixel. */
const leastMovement = 1e-6;

export class FineOrbit extends OrbitControls {
    /** Not there while three's constructor runs. */
    private told?: { position: Vector3; target: Vector3 };

    override update(deltaTime?: number | null): boolean {
        const changed = super.update(deltaTime);
        const { position } = this.object;
        const { target } = this;
        this.told ??= { position: new Vector3(Infinity), target: new Vector3() };
        const least = leastMovement * position.distanceTo(target);
        const moved = this.told.position.distanceTo(position) > least || this.told.target.distanceTo(target) > least;
        if (!changed && !moved) return false;
        this.told.position.copy(position);
        this.told.target.copy(target);
        if (!changed) this.dispatchEvent({ type: 'change' });
        return true;
    }
}
