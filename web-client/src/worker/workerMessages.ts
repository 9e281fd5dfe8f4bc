// Everything the page and its worker say to each other, one table for each direction.
import type { ConnectionState } from '../connection/liveSocket.ts';
import type { Notification } from '../protocol/messages.ts';

export interface ToWorker {
    /** The worker connects and stays connected. `baseUrl` ends in a slash. */
    start: { baseUrl: string; token: string | null };
    call: { id: number; method: string; params: object };
    obstacle: { id: number; dataset: string; lattice: LatticeMessage };
    /** The browser believes that it is online again. */
    retryNow: object;
}

export interface FromWorker {
    connection: ConnectionState;
    reply: { id: number; result: unknown };
    failure: { id: number; failure: CallFailure };
    notification: { notification: Notification };
    surface: SurfaceState;
    /** Frames of a surface did not fit together; it has to be subscribed again. */
    frameTrouble: { subscription: number; reason: string };
}

export interface LatticeMessage {
    origin: [number, number, number];
    step: number;
    bits: number;
}

export interface CallFailure {
    kind: 'rpc' | 'disconnected';
    code: number;
    message: string;
    hint: string;
}

/** One complete state of a surface, ready for the GPU. */
export interface SurfaceState {
    subscription: number;
    epoch: number;
    final: boolean;
    stateCrc: number;
    vertices: number;
    cells: number;
    triangles: number;
    speedRange: [number, number];
    positions: Float32Array;
    normals: Float32Array;
    scalars: Float32Array;
    indices: Uint32Array;
}

export interface GeometryArrays {
    positions: Float32Array;
    indices: Uint32Array;
}

export type MessageOf<Table> = { [Type in keyof Table]: { type: Type } & Table[Type] }[keyof Table];
