// A script for Python that does what a panel shows, with the client that the server gives away
// (python).
import {
    type CallStep,
    KeptId,
    type MeshStep,
    nounOf,
    ofSession,
    type ScriptPlace,
    type ScriptStep,
    type SurfaceStep,
} from './scriptStep.ts';

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
    for (const step of steps) lines.push(...written(step));
    return `${lines.join('\n')}\n`;
}

function written(step: ScriptStep): string[] {
    if ('mesh' in step) return download(step);
    return 'there' in step ? surfaceThere(step) : call(step);
}

/** No user who looks at the session finds a second one in it. */
function surfaceThere({ there, otherwise }: SurfaceStep): string[] {
    return [
        `surface = next((each for each in session.surfaces() if each.id == ${literal(there)}), None)`,
        'if surface is None:  # deleted since: made again',
        ...otherwise.flatMap(call).map((line) => `    ${line}`),
        'print(surface.wait()["quads"], "quads")',
        'mesh = surface.mesh()  # numpy: mesh.points, mesh["speed"]',
        'surface.export("surface.vtp")  # for ParaView; also .glb, .ply, .obj',
    ];
}

function call(step: CallStep): string[] {
    const params = Object.entries(step.params).filter(([, value]) => value !== undefined);
    const { method, keep } = step;
    const special = idiom(method, new Map(params));
    if (special !== null) return [keep === undefined ? special : `${keep} = ${special}`];
    const on = ofSession(method) ? 'session' : 'server';
    const text = `${on}.call(${[literal(method), ...params.map(keywordArgument)].join(', ')})`;
    return [keep === undefined ? `print(${text})` : `${keep} = ${text}[${literal(nounOf(method))}]`];
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
            if (params.has('surface') || !params.has('rake')) return null;
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

function download({ mesh, surface }: MeshStep): string[] {
    const lines = mesh.lines === undefined ? '' : `, lines=${literal(mesh.lines)}`;
    const file = literal(`surface.${mesh.format}`) + (mesh.draco === false ? ', draco=False' : '') + lines;
    if (surface instanceof KeptId) return [`${surface.name}.wait()`, `${surface.name}.export(${file})`];
    const found = `surface = next(each for each in session.surfaces() if each.id == ${literal(surface)})`;
    return [found, 'surface.wait()', `surface.export(${file})`];
}

function keywordArgument([name, value]: [string, unknown]): string {
    const plain = /^[A-Za-z_][A-Za-z0-9_]*$/.test(name) && !keywords.has(name);
    return plain ? `${name}=${literal(value)}` : `**{${literal(name)}: ${literal(value)}}`;
}

/** A value as Python spells it. Strings of JSON are strings of Python. */
function literal(value: unknown): string {
    if (value instanceof KeptId) return value.name;
    if (value === null || value === undefined) return 'None';
    if (typeof value === 'boolean') return value ? 'True' : 'False';
    if (typeof value === 'number') return String(value);
    if (typeof value === 'string') return JSON.stringify(value);
    if (Array.isArray(value)) return `[${value.map(literal).join(', ')}]`;
    const members = Object.entries(value).filter(([, member]) => member !== undefined);
    return `{${members.map(([name, member]) => `${JSON.stringify(name)}: ${literal(member)}`).join(', ')}}`;
}
