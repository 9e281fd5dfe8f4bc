// A script for a shell that does what a panel shows, with curl, and jq where an id has to be passed on
// (protocol/api/README.md, "A tour with curl").
import {
    type CallStep,
    callsOf,
    KeptId,
    meshPath,
    type MeshStep,
    nounOf,
    ofSession,
    type ScriptPlace,
    type ScriptStep,
} from './scriptStep.ts';

export function curlScript(place: ScriptPlace, all: readonly ScriptStep[]): string {
    const steps = callsOf(all);
    const lines = [
        '# This script does not contain your token: put it in the environment variable WAKESURF_TOKEN first.',
        `server=${quoted(place.server)}`,
        'get() { curl -sS --fail-with-body -H "Authorization: Bearer ${WAKESURF_TOKEN-}" "$@"; }',
    ];
    if (steps.some((step) => !('mesh' in step))) {
        lines.push(`rpc() { get "$server/net/methods" -H 'Content-Type: application/json' -d "$1"; }`);
    }
    if (steps.some((step) => !('mesh' in step) && step.keep !== undefined)) {
        lines.push(`id_of() { jq -er --arg noun "$1" '.result[$noun] // error(.error.message)'; }`);
    }
    for (const step of all) lines.push(...written(place, step));
    return `${lines.join('\n')}\n`;
}

function written(place: ScriptPlace, step: ScriptStep): string[] {
    if ('mesh' in step) return [download(place, step)];
    if (!('there' in step)) return [call(place, step)];
    const mesh = { format: 'vtp' } as const;
    const made = [...step.otherwise, { mesh, surface: new KeptId('surface') }].flatMap((each) => written(place, each));
    return [
        '# The surface that is there, once it is final; if it is not there any more, the same again.',
        `${download(place, { mesh, surface: step.there })} || {`,
        ...made.map((line) => `    ${line}`),
        '}',
    ];
}

function call(place: ScriptPlace, { method, params, keep }: CallStep): string {
    const text = message(method, ofSession(method) ? { session: place.session, ...params } : params);
    if (keep === undefined) return `rpc ${text}; echo`;
    return `${keep}=$(rpc ${text} | id_of ${nounOf(method)}) && echo "${keep}: $${keep}"`;
}

/** One word of the shell: JSON in single quotes, and the variables that hold ids in double ones. */
function message(method: string, params: object): string {
    let word = '';
    let json = `{"jsonrpc":"2.0","id":1,"method":${JSON.stringify(method)},"params":{`;
    const given = Object.entries(params).filter(([, value]) => value !== undefined);
    for (const [i, [name, value]] of given.entries()) {
        json += `${i === 0 ? '' : ','}${JSON.stringify(name)}:`;
        if (value instanceof KeptId) {
            word += `${quoted(`${json}"`)}"$${value.name}"`;
            json = '"';
        } else json += JSON.stringify(value);
    }
    return word + quoted(`${json}}}`);
}

function download({ session }: ScriptPlace, { mesh, surface }: MeshStep): string {
    const before = `/api/v1/sessions/${encodeURIComponent(session)}/surfaces/`;
    const id = surface instanceof KeptId ? `"$${surface.name}"` : quoted(encodeURIComponent(surface));
    return `get "$server"${quoted(before)}${id}${quoted(`/${meshPath(mesh)}`)} -o surface.${mesh.format}`;
}

/** In single quotes a shell reads nothing but the end of them. */
export function quoted(text: string): string {
    return `'${text.replaceAll("'", `'\\''`)}'`;
}
