// Everything the page and its worker say to each other, one table for each direction.
import type { StoredLogin } from '../connection/ownServer.ts';
import type { ConnectionState } from '../connection/liveSocket.ts';
import type { TimedMeshChange } from '../mesh/meshChange.ts';
import type { Lattice } from '../protocol/lattice.ts';
import type { Phase } from '../protocol/meshFrame.ts';
import type { Notification } from '../protocol/messages.ts';

export interface ToWorker {
    /** The worker connects and stays connected. `baseUrl` ends in a slash. */
    start: { baseUrl: string; token: string | null; login: string | null };
    call: { id: number; method: string; params: object };
    /** The answer to this call is not wanted any more; it comes all the same, as a failure. */
    cancel: { id: number };
    /** To the server; nothing is answered. */
    notify: { method: 'presence.update'; params: object };
    obstacle: { id: number; dataset: string; lattice: Lattice; allPatches: boolean };
    /** Beside the obstacle at a time; field: empty for the velocity alone. */
    bodyValues: { id: number; dataset: string; lattice: Lattice; allPatches: boolean; time: number; field: string };
    /** A state of this surface is on the screen: the next one may come. */
    taken: { surface: string };
    /** Which of the surface's attributes the page wants; of its parts, what is asked here. */
    show: { surface: string } & ShowWish;
    /** The surface is no more. */
    forget: { surface: string };
    /** Another token; or a login, for a page that is not let in with what it has. Connects, if it was
     *  refused. */
    logIn: { token: string; login?: undefined } | { token?: undefined; login: string };
    /** The browser believes that it is online again. */
    retryNow: object;
    /** Answered at once, unless the worker hangs. */
    areYouThere: object;
}

export interface FromWorker {
    connection: ConnectionState;
    /** Or its login is good for longer. */
    loggedIn: StoredLogin;
    /** The page may have another, for takeLogin(). */
    loginEnded: { login: string };
    reply: { id: number; result: unknown };
    failure: { id: number; failure: CallFailure };
    notification: { notification: Notification };
    /** What of a notification the page would not understand, in words. */
    unreadable: { faults: string[] };
    surface: SurfaceState;
    /** Frames of a surface did not fit together; it has to be subscribed again. */
    frameTrouble: { surface: string; subscription: number; reason: string };
    here: object;
    /** How long a message to the server and back takes. */
    roundTrip: { ms: number };
}

export interface CallFailure {
    kind: 'rpc' | 'disconnected' | 'unreadable';
    code: number;
    message: string;
    hint: string;
}

/** One complete state of a surface: what is new in it since the state sent before, ready for the GPU. */
export interface SurfaceState extends TimedMeshChange {
    surface: string;
    epoch: number;
    phase: Phase;
    stateSum: number;
    cells: number;
    /** Counts the vertices of the mesh: those of the arrays are more where cells are curved. */
    meshVertices: number;
    /** Updates applied so far: whole states, and changes of the state before. */
    keys: number;
    deltas: number;
    /** Attributes that came with it and stayed in the worker: until then the page had not said that it wants
     *  them. */
    withheld: readonly string[];
    /** The arrays are of curved cells. */
    curved: boolean;
    /** Time it took here to decode what is new and to make the arrays. */
    decodeMs: number;
}

/** What the page wants of a surface. */
export interface ShowWish {
    attributes: readonly string[];
    parts: PartsWish | null;
    /** Smooth borders where it is torn. */
    trimmed: boolean;
    /** Cells of states that stand still are curved: pixels that a unit of length has in the picture. Left
     *  out: flat. */
    curved?: number;
    /** How long units of s and t are, on a surface whose rake is open or closed; left out: no user needs
     *  to know. */
    units?: 'open' | 'closed';
    /** What a fixed grid cannot resolve, which smoke hides. */
    unresolved?: true;
}

/** Those parts are hidden that hold the vertex nearest to one of these places, [s, t]. */
export interface PartsWish {
    hidden: readonly (readonly [number, number])[];
}

export type MessageOf<Table> = { [Type in keyof Table]: { type: Type } & Table[Type] }[keyof Table];
