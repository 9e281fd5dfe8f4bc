// A rake as it is drawn: what the layer of all rakes hands to the widget of each.
import type { Vec3 } from '../../protocol/messages.ts';
import type { Handle } from './rakeHandles.ts';
import type { RakeShape } from './rakeShape.ts';

/** Another user who moves a rake just now. */
export interface RakeHolder {
    name: string;
    colour: string;
    /** Where they have it, if they say so. */
    points?: readonly Vec3[];
}

export interface DrawnRake {
    rake: string;
    shape: RakeShape;
    colour: string;
    chosen: boolean;
    /** Cannot be moved, from here. */
    locked: boolean;
    holder: RakeHolder | null;
    /** Words beside it; empty: none. */
    remark: string;
}

/** A handle that is not where the shape has it, because it is held. */
export interface HeldHandle {
    handle: Handle;
    at: Vec3;
}
