// Describes what a panel shows as calls of the server, for scripts that do the same: pythonScript.ts and
// curlScript.ts spell them.

export type MeshFormat = 'vtp' | 'glb' | 'ply' | 'obj' | 'drc';

/** A file of a mesh, as the server offers it. */
export interface MeshFile {
    format: MeshFormat;
    /** Belongs to a .glb: false for programs that cannot read Draco. */
    draco?: false;
    /** Holds what is shown now, where that is not final yet. */
    now?: true;
    /** Lines, ribbons or arrows instead of the mesh. */
    lines?: string;
}

/** Below the address of the surface. */
export function meshPath({ format, draco, now, lines }: MeshFile): string {
    const query = [
        draco === false ? 'draco=false' : '',
        now === true ? 'now=true' : '',
        lines === undefined ? '' : `lines=${encodeURIComponent(lines)}`,
    ].filter((each) => each !== '');
    return `mesh.${format}${query.length === 0 ? '' : `?${query.join('&')}`}`;
}

/** The id that an earlier step of the script has answered, under the name it was kept as. */
export class KeptId {
    readonly name: string;

    constructor(name: string) {
        this.name = name;
    }
}

export interface CallStep {
    method: string;
    /** Are the parameters as JSON has them, without `session`; at the top level a KeptId may stand for an
     *  id. */
    params: object;
    /** Keeps the member of the answer that is named like the record (`rake` of rake.set) under this name. */
    keep?: string;
}

/** A download, in full precision, once the surface is final. */
export interface MeshStep {
    mesh: MeshFile;
    surface: KeptId | string;
}

/** A surface that is there: of it a mesh and a file, once it is final. Where it is not there any more, it is
 *  made again. */
export interface SurfaceStep {
    there: string;
    otherwise: readonly CallStep[];
}

export type ScriptStep = CallStep | MeshStep | SurfaceStep;

/** All calls that a script may make, also those that it makes only where something is missing. */
export function callsOf(steps: readonly ScriptStep[]): (CallStep | MeshStep)[] {
    return steps.flatMap((step): readonly (CallStep | MeshStep)[] => ('there' in step ? step.otherwise : [step]));
}

/** Where a script runs. The token is no part of it: texts are pasted into chats and tickets. */
export interface ScriptPlace {
    /** Address of the server, with the prefix of a proxy. */
    server: string;
    session: string;
}

const sessionless: ReadonlySet<string> = new Set(['server', 'dataset', 'cache', 'probe', 'rpc']);

/** Returns whether a method acts on a session, and takes its id. */
export function ofSession(method: string): boolean {
    return !sessionless.has(method.split('.')[0] ?? '') && !['session.create', 'session.list'].includes(method);
}

/** The noun of a method: what its answer calls the id of the record. */
export function nounOf(method: string): string {
    return method.split('.')[0] ?? '';
}
