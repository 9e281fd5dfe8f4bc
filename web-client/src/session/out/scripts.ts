// What a panel shows as a script that does the same: its calls of the server, spelled for Python, with the client that the server gives
// away (python), or for curl.

export type MeshFormat = 'vtp' | 'glb' | 'ply' | 'obj' | 'drc';

/** A file of a mesh, as the server offers it. */
export interface MeshFile {
    format: MeshFormat;
    /** Belongs to a .glb: false for programs that cannot read Draco. */
    draco?: false;
    /** What is shown now, where that is not final yet. */
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
export class ScriptVariable {
    readonly name: string;

    constructor(name: string) {
        this.name = name;
    }
}

export interface CallStep {
    method: string;
    /** The parameters as JSON has them, without `session`; at the top level a ScriptVariable may stand for an
     *  id. */
    params: object;
    /** Keeps the member of the answer that is named like the record (`rake` of rake.set) under this name. */
    variable?: string;
}

/** A download, in full precision, once the surface is final. */
export interface MeshStep {
    mesh: MeshFile;
    surface: ScriptVariable | string;
}

/** A surface that is there: of it a mesh and a file, once it is final. Where it is not there any more, it is
 *  made again. */
export interface SurfaceStep {
    there: string;
    otherwise: readonly CallStep[];
}

export type ScriptStep = CallStep | MeshStep | SurfaceStep;

/** All calls that a script may make, also those that it makes only where something is missing. */
function callsOf(steps: readonly ScriptStep[]): (CallStep | MeshStep)[] {
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
function ofSession(method: string): boolean {
    return !sessionless.has(method.split('.')[0] ?? '') && !['session.create', 'session.list'].includes(method);
}

/** The noun of a method: what its answer calls the id of the record. */
function nounOf(method: string): string {
    return method.split('.')[0] ?? '';
}

const head = (server: string): string[] => [
    '# Needs numpy, and the client beside it:',
    `#     curl -fO ${server}/wakesurf.py`,
    '# This script does not contain your token: put it in the environment variable WAKESURF_TOKEN first.',
    'from wakesurf import Client',
    '',
];

const keywords: ReadonlySet<string> = new Set(
    (
        'False None True and as assert async await break class continue def del elif else except finally for from ' +
        'global if import in is lambda nonlocal not or pass raise return try while with yield'
    ).split(' '),
);

export function pythonScript({ server, session }: ScriptPlace, steps: readonly ScriptStep[]): string {
    const lines = [...head(server), `server = Client(${literal(server)})`];
    const inSession = steps.some((step) => 'mesh' in step || 'there' in step || ofSession(step.method));
    if (inSession) lines.push(`session = server.session(${literal(session)})`);
    for (const step of steps) lines.push(...pythonLines(step));
    return `${lines.join('\n')}\n`;
}

function pythonLines(step: ScriptStep): string[] {
    if ('mesh' in step) return pythonDownload(step);
    return 'there' in step ? surfaceThere(step) : pythonCall(step);
}

/** No user who looks at the session finds a second one in it. */
function surfaceThere({ there, otherwise }: SurfaceStep): string[] {
    return [
        `surface = next((each for each in session.surfaces() if each.id == ${literal(there)}), None)`,
        'if surface is None:  # deleted since: made again',
        ...otherwise.flatMap(pythonCall).map((line) => `    ${line}`),
        'print(surface.wait()["quads"], "quads")',
        'mesh = surface.mesh()  # numpy: mesh.points, mesh["speed"]',
        'surface.export("surface.vtp")  # for ParaView; also .glb, .ply, .obj',
    ];
}

function pythonCall(step: CallStep): string[] {
    const params = Object.entries(step.params).filter(([, value]) => value !== undefined);
    const { method, variable } = step;
    const special = idiom(method, new Map(params));
    if (special !== null) return [variable === undefined ? special : `${variable} = ${special}`];
    const on = ofSession(method) ? 'session' : 'server';
    const text = `${on}.call(${[literal(method), ...params.map(keywordArgument)].join(', ')})`;
    return [variable === undefined ? `print(${text})` : `${variable} = ${text}[${literal(nounOf(method))}]`];
}

/** Returns the call as one would write it by hand; null where the class has no method that takes all of
 *  it. */
function idiom(method: string, params: ReadonlyMap<string, unknown>): string | null {
    const known = (...names: string[]): boolean => [...params.keys()].every((name) => names.includes(name));
    const rest = (...without: string[]): string[] => [...params].filter(([name]) => !without.includes(name)).map(keywordArgument);
    const written = (name: string): string => literal(params.get(name));
    switch (method) {
        case 'rake.set':
            if (!known('kind', 'points', 'seeds', 'name', 'colour')) return null;
            return `session.rake(${[`${String(params.get('kind'))}=${written('points')}`, ...rest('kind', 'points')].join(', ')})`;
        case 'surface.set': {
            if (params.has('surface')) return null;
            if (!params.has('rake')) {
                const others = [...params].filter(([name]) => !['kind', 'field', 'level'].includes(name));
                const more = others.map(([name, value]) => keywordArgument([name === 'from' ? 'from_' : snake(name), value]));
                return `session.isosurface(${[written('field'), written('level'), ...more].join(', ')})`;
            }
            const named = [`dataset=${written('dataset')}`, `from_=${written('from')}`, `to=${written('to')}`];
            const others = [...params]
                .filter(([name]) => !['rake', 'kind', 'dataset', 'from', 'to'].includes(name))
                .map(([name, value]) => keywordArgument([snake(name), value]));
            return `session.surface(${[written('rake'), written('kind'), ...named, ...others].join(', ')})`;
        }
        case 'time.set':
            return `session.set_time(${written('time')})`;
        case 'time.play':
            return `session.play(${rest().join(', ')})`;
        case 'time.pause':
            return 'session.pause()';
        case 'session.share': {
            if (!known('role', 'expiresIn')) return null;
            const expires = params.has('expiresIn') ? `, ${written('expiresIn')}` : '';
            return `print(session.share(${written('role')}${expires}))`;
        }
        default:
            return null;
    }
}

/** Spells a name as Python does: maxQuads -> max_quads. */
function snake(name: string): string {
    return name.replace(/(?<=[a-z0-9])[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);
}

function pythonDownload({ mesh, surface }: MeshStep): string[] {
    const lines = mesh.lines === undefined ? '' : `, lines=${literal(mesh.lines)}`;
    const file = literal(`surface.${mesh.format}`) + (mesh.draco === false ? ', draco=False' : '') + lines;
    if (surface instanceof ScriptVariable) return [`${surface.name}.wait()`, `${surface.name}.export(${file})`];
    const found = `surface = next(each for each in session.surfaces() if each.id == ${literal(surface)})`;
    return [found, 'surface.wait()', `surface.export(${file})`];
}

function keywordArgument([name, value]: [string, unknown]): string {
    const plain = /^[A-Za-z_][A-Za-z0-9_]*$/.test(name) && !keywords.has(name);
    return plain ? `${name}=${literal(value)}` : `**{${literal(name)}: ${literal(value)}}`;
}

/** A value as Python spells it. Strings of JSON are strings of Python. */
function literal(value: unknown): string {
    if (value instanceof ScriptVariable) return value.name;
    if (value === null || value === undefined) return 'None';
    if (typeof value === 'boolean') return value ? 'True' : 'False';
    if (typeof value === 'number') return String(value);
    if (typeof value === 'string') return JSON.stringify(value);
    if (Array.isArray(value)) return `[${value.map(literal).join(', ')}]`;
    const members = Object.entries(value).filter(([, member]) => member !== undefined);
    return `{${members.map(([name, member]) => `${JSON.stringify(name)}: ${literal(member)}`).join(', ')}}`;
}

/** With jq where an id has to be passed on (protocol/api/README.md, "A tour with curl"). */
export function curlScript(place: ScriptPlace, all: readonly ScriptStep[]): string {
    const steps = callsOf(all);
    const lines = [
        '# This script does not contain your token: put it in the environment variable WAKESURF_TOKEN first.',
        `server=${quoted(place.server)}`,
        'get() { curl -sS --fail-with-body -H "Authorization: Bearer ${WAKESURF_TOKEN-}" "$@"; }',
    ];
    if (steps.some((step) => !('mesh' in step))) {
        lines.push(`rpc() { get "$server/rpc" -H 'Content-Type: application/json' -d "$1"; }`);
    }
    if (steps.some((step) => !('mesh' in step) && step.variable !== undefined)) {
        lines.push(`id_of() { jq -er --arg noun "$1" '.result[$noun] // error(.error.message)'; }`);
    }
    for (const step of all) lines.push(...curlLines(place, step));
    return `${lines.join('\n')}\n`;
}

function curlLines(place: ScriptPlace, step: ScriptStep): string[] {
    if ('mesh' in step) return [curlDownload(place, step)];
    if (!('there' in step)) return [curlCall(place, step)];
    const mesh = { format: 'vtp' } as const;
    const made = [...step.otherwise, { mesh, surface: new ScriptVariable('surface') }].flatMap((each) => curlLines(place, each));
    return [
        '# The surface that is there, once it is final; if it is not there any more, the same again.',
        `${curlDownload(place, { mesh, surface: step.there })} || {`,
        ...made.map((line) => `    ${line}`),
        '}',
    ];
}

function curlCall(place: ScriptPlace, { method, params, variable }: CallStep): string {
    const text = message(method, ofSession(method) ? { session: place.session, ...params } : params);
    if (variable === undefined) return `rpc ${text}; echo`;
    return `${variable}=$(rpc ${text} | id_of ${nounOf(method)}) && echo "${variable}: $${variable}"`;
}

/** One word of the shell: JSON in single quotes, and the variables that hold ids in double ones. */
function message(method: string, params: object): string {
    let word = '';
    let json = `{"jsonrpc":"2.0","id":1,"method":${JSON.stringify(method)},"params":{`;
    const given = Object.entries(params).filter(([, value]) => value !== undefined);
    for (const [i, [name, value]] of given.entries()) {
        json += `${i === 0 ? '' : ','}${JSON.stringify(name)}:`;
        if (value instanceof ScriptVariable) {
            word += `${quoted(`${json}"`)}"$${value.name}"`;
            json = '"';
        } else json += JSON.stringify(value);
    }
    return word + quoted(`${json}}}`);
}

function curlDownload({ session }: ScriptPlace, { mesh, surface }: MeshStep): string {
    const before = `/api/v1/sessions/${encodeURIComponent(session)}/surfaces/`;
    const id = surface instanceof ScriptVariable ? `"$${surface.name}"` : quoted(encodeURIComponent(surface));
    return `get "$server"${quoted(before)}${id}${quoted(`/${meshPath(mesh)}`)} -o surface.${mesh.format}`;
}

/** In single quotes a shell reads nothing but the end of them. */
export function quoted(text: string): string {
    return `'${text.replaceAll("'", `'\\''`)}'`;
}
