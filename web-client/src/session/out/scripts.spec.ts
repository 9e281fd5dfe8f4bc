import { execFileSync } from 'node:child_process';
import { describe, expect, it } from 'vitest';
import { type CallStep, curlScript, pythonScript, quoted, type ScriptStep, ScriptVariable } from './scripts.ts';

const place = { server: 'http://127.0.0.1:8080/some/prefix', session: 'main' };
/** Everything that a language might take for the end of a text. */
const nasty = `it's "q" $HOME \`ls\` \\n \\ ! %s {x} \n second line \u{1f30a} é \u0000 \u2028`;

const made: ScriptStep[] = [
    {
        method: 'rake.set',
        params: {
            kind: 'line',
            points: [
                [0, -1.5, 1e-7],
                [0, 1.5, 2],
            ],
            seeds: 24,
            name: nasty,
            colour: undefined,
        },
        variable: 'rake',
    },
    {
        method: 'surface.set',
        params: { rake: new ScriptVariable('rake'), dataset: "d'1", kind: 'path', from: 8.5, to: 12, direction: 'both' },
        variable: 'surface',
    },
    { mesh: { format: 'vtp' }, surface: new ScriptVariable('surface') },
];

/** Runs a script with a stand-in for the client that notes what it is asked for. */
function pythonCalls(script: string): unknown[] {
    const noted = `
import json, sys, types
calls = []
class Noted:
    def __init__(self, path, id="kept"): self._path, self.id = path, id
    def __getattr__(self, name): return Noted(self._path + [name])
    def __call__(self, *args, **named):
        calls.append([".".join(self._path), [a.id if isinstance(a, Noted) else a for a in args], named])
        return Noted([])
    def __getitem__(self, name): return name
    def __str__(self): return ""
sys.modules["wakesurf"] = types.SimpleNamespace(Client=Noted(["Client"]))
exec(compile(sys.stdin.read(), "script", "exec"))
print(json.dumps(calls))`;
    const out = execFileSync('python3', ['-c', noted], { input: script, encoding: 'utf8' });
    return JSON.parse(out.trim().split('\n').at(-1)!) as unknown[];
}

/** Runs a script in a shell whose curl prints its arguments and answers with an id, or fails where they say
 *  "gone". */
function curlArguments(script: string): string[][] {
    const shell = `curl() { for a in "$@"; do printf '%s\\0' "$a" >&2; done; printf '\\1' >&2; [[ $* != *gone* ]] && echo '{"result":{"rake":"r7","surface":"s8"}}'; }
${script}`;
    const out = execFileSync('bash', ['-c', `{ ${shell}\n} 2>&1 >/dev/null`], { encoding: 'utf8' });
    return out
        .split('\u0001')
        .slice(0, -1)
        .map((call) => call.split('\u0000').slice(0, -1));
}

function sent(call: string[]): Record<string, unknown> {
    return (JSON.parse(call[call.indexOf('-d') + 1]!) as { params: Record<string, unknown> }).params;
}

describe('a script for Python', () => {
    it('says what the steps say, whatever characters are in them', () => {
        const calls = pythonCalls(pythonScript(place, made));
        expect(calls).toEqual([
            ['Client', [place.server], {}],
            ['session', ['main'], {}],
            [
                'rake',
                [],
                {
                    line: [
                        [0, -1.5, 1e-7],
                        [0, 1.5, 2],
                    ],
                    seeds: 24,
                    name: nasty,
                },
            ],
            ['surface', ['kept', 'path'], { dataset: "d'1", from_: 8.5, to: 12, direction: 'both' }],
            ['wait', [], {}],
            ['export', ['surface.vtp'], {}],
        ]);
    });

    it('of a surface that is there makes nothing, waits for it, and fetches it', () => {
        const [rake, surface] = made as [CallStep, CallStep];
        const steps: ScriptStep[] = [{ there: 's8', otherwise: [rake, surface] }];
        const script = pythonScript(place, steps);
        expect(
            script
                .split('\n')
                .filter((line) => /session\.(rake|surface)\(/.test(line))
                .every((line) => line.startsWith('    ')),
        ).toBe(true);
        expect(
            script
                .trim()
                .split('\n')
                .slice(-3)
                .map((line) => line.split('  #')[0]),
        ).toEqual(['print(surface.wait()["quads"], "quads")', 'mesh = surface.mesh()', 'surface.export("surface.vtp")']);
        const there = curlArguments(curlScript(place, steps));
        expect(there).toHaveLength(1);
        expect(there[0]).toContain(`${place.server}/api/v1/sessions/main/surfaces/s8/mesh.vtp`);
        const gone = curlArguments(curlScript(place, [{ there: 'gone', otherwise: [rake, surface] }]));
        expect(gone.map((call) => call.find((each) => each.startsWith(place.server)))).toEqual([
            `${place.server}/api/v1/sessions/main/surfaces/gone/mesh.vtp`,
            `${place.server}/rpc`,
            `${place.server}/rpc`,
            `${place.server}/api/v1/sessions/main/surfaces/s8/mesh.vtp`,
        ]);
        expect(sent(gone[2]!)).toMatchObject({ rake: 'r7' });
    });

    it('exports a .glb for programs without Draco', () => {
        const steps: ScriptStep[] = [{ mesh: { format: 'glb', draco: false }, surface: new ScriptVariable('surface') }];
        const script = `surface = session.surfaces()\n${pythonScript(place, steps)}`;
        expect(script).toContain('surface.export("surface.glb", draco=False)');
    });

    it('calls what the client has no method for by its name, and spells what Python keeps for itself', () => {
        const steps: ScriptStep[] = [
            { method: 'time.play', params: { speed: 0.5, loop: true, from: 1, to: 2 } },
            { method: 'time.set', params: { time: null } },
            { method: 'bookmark.set', params: { name: 'x', view: { on: true, at: [1, null] } } },
            { method: 'dataset.describe', params: { dataset: 'd' } },
            { method: 'session.share', params: { role: 'viewer', expiresIn: 60 } },
        ];
        expect(pythonCalls(pythonScript(place, steps)).slice(2)).toEqual([
            ['play', [], { speed: 0.5, loop: true, from: 1, to: 2 }],
            ['set_time', [null], {}],
            ['call', ['bookmark.set'], { name: 'x', view: { on: true, at: [1, null] } }],
            ['call', ['dataset.describe'], { dataset: 'd' }],
            ['share', ['viewer', 60], {}],
        ]);
    });
});

describe('a script for curl', () => {
    it('sends what the steps say, and the ids that came back', () => {
        const calls = curlArguments(curlScript(place, made));
        expect(calls).toHaveLength(3);
        expect(calls[0]).toContain(`${place.server}/rpc`);
        expect(sent(calls[0]!)).toEqual({
            session: 'main',
            ...{
                kind: 'line',
                points: [
                    [0, -1.5, 1e-7],
                    [0, 1.5, 2],
                ],
                seeds: 24,
                name: nasty,
            },
        });
        expect(sent(calls[1]!)).toMatchObject({ rake: 'r7', dataset: "d'1", kind: 'path' });
        expect(calls[2]).toContain(`${place.server}/api/v1/sessions/main/surfaces/s8/mesh.vtp`);
    });

    it('asks for a .glb for programs without Draco', () => {
        const steps: ScriptStep[] = [{ mesh: { format: 'glb', draco: false }, surface: 's8' }];
        const [asked] = curlArguments(curlScript(place, steps));
        expect(asked).toContain(`${place.server}/api/v1/sessions/main/surfaces/s8/mesh.glb?draco=false`);
        expect(asked).toContain('surface.glb');
    });

    it('quotes any text as one word', () => {
        const text = nasty.replace('\0', '');
        const word = execFileSync('bash', ['-c', `printf %s ${quoted(text)}`], { encoding: 'utf8' });
        expect(word).toBe(text);
    });
});
