import { describe, expect, it } from 'vitest';
import type { LinesRecord, RakeRecord, SliceRecord, SurfaceRecord, Vec3 } from '../../protocol/messages.ts';
import { decodeLinkState, encodeLinkState, readFragment, readNewLink, writeFragment } from './urlState.ts';

describe('the fragment of the link', () => {
    it('carries token, session and dataset in', () => {
        expect(readFragment('#token=ab-_c&session=x')).toEqual({
            token: 'ab-_c',
            session: 'x',
            dataset: null,
            state: null,
        });
        expect(readFragment('')).toEqual({ token: null, session: null, dataset: null, state: null });
    });

    it('comes back without a token', () => {
        const { session, dataset } = readFragment('#token=secret&session=a%20b&dataset=d');
        const fragment = writeFragment(session, dataset);
        expect(fragment).not.toContain('secret');
        expect(readFragment(fragment)).toEqual({ token: null, session: 'a b', dataset: 'd', state: null });
        expect(writeFragment(null, null)).toBe('');
    });
});

const rake: RakeRecord = {
    ...{ rake: 'r1', rev: 4, kind: 'line', seeds: 8, name: 'Zulauf – größer', colour: '#0072b2', author: '' },
    ...{
        points: [
            [0, 0.123456789, 0],
            [1, 0, 0],
        ] as Vec3[],
        clipped: false,
        dragging: false,
    },
};
const surface = {
    ...{ surface: 's1', rev: 2, epoch: 9, rake: 'r1', kind: 'streak', dataset: 'd', from: 0, to: 3 },
    ...{ separation: 0.1, fields: ['p'] },
} as SurfaceRecord;
const camera = { position: [1, 2, 3] as Vec3, target: [0, 0, 0] as Vec3, orthographic: true };

describe('a state in a link', () => {
    it('comes back as it was, to six digits and without revisions', () => {
        const text = encodeLinkState({ view: { camera, surface: 's1' }, rakes: [rake], surfaces: [surface] });
        expect(text).toMatch(/^[\w-]+$/);
        const back = decodeLinkState(text);
        expect(back.view).toEqual({ camera, surface: 's1' });
        expect(back.rakes).toMatchObject([
            {
                rake: 'r1',
                name: rake.name,
                rev: 0,
                points: [
                    [0, 0.123457, 0],
                    [1, 0, 0],
                ],
            },
        ]);
        expect(back.surfaces).toMatchObject([{ ...surface, rev: 0, epoch: 0 }]);
    });

    it('has the slices and streamlines of the session, for where the server has forgotten them', () => {
        const slice: SliceRecord = { slice: 'p1', rev: 3, dataset: 'd', origin: [0, 0, 1], normal: [0, 0, 1], field: 'p' };
        const lines = {
            ...{ lines: 'l1', rev: 2, dataset: 'd', kind: 'line', distance: 0, seeds: 7 },
            points: [
                [0, 0, 0],
                [1, 0, 0],
            ],
            ...{ direction: 'both', duration: 0, length: 0, field: 'p' },
        } as unknown as LinesRecord; // of a link that was made before seeds knew patches
        const back = decodeLinkState(encodeLinkState({ view: {}, slices: [slice], lines: [lines] }));
        expect(back.slices).toEqual([{ ...slice, rev: 0 }]);
        expect(back.lines).toEqual([{ ...lines, rev: 0, patches: [] }]);
        const many = Array.from({ length: 60 }, () => lines);
        const fewer = decodeLinkState(encodeLinkState({ view: {}, surfaces: [surface], lines: many }));
        expect([fewer.surfaces.length, fewer.lines.length]).toEqual([1, 0]);
    });

    it('that an older version made goes back in time as it did then', () => {
        const older = { ...surface, direction: 'backward', from: 5, to: 8, releaseUntil: 6 } as SurfaceRecord;
        const back = (record: SurfaceRecord): unknown =>
            decodeLinkState(encodeLinkState({ view: {}, rakes: [], surfaces: [record] })).surfaces[0];
        expect(back(older)).toMatchObject({ direction: 'backward', from: 5, to: 2, releaseUntil: 4 });
        const today = { ...older, to: 2, releaseUntil: 4 } as SurfaceRecord;
        expect(back(today)).toMatchObject({ direction: 'backward', from: 5, to: 2, releaseUntil: 4 });
    });

    it('keeps where things are far from the origin, and how small they are', () => {
        const points: Vec3[] = [
            [512345.125, 5423456.0625, 0.0000212],
            [512745, 5423956.5, 0.00004],
        ];
        const text = encodeLinkState({
            view: { camera },
            rakes: [{ ...rake, points }],
            surfaces: [{ ...surface, to: 1700000300.5 }],
        });
        expect(decodeLinkState(text).rakes[0]?.points).toEqual(points);
        expect(decodeLinkState(text).surfaces[0]?.to).toBe(1700000300.5);
    });

    it('leaves the records out where it would grow too long, and keeps the view', () => {
        const points = Array.from({ length: 500 }, (_, i): Vec3 => [i / 7, i / 11, i / 13]);
        const text = encodeLinkState({ view: { camera }, rakes: [{ ...rake, points }], surfaces: [] });
        expect(text.length).toBeLessThan(6000);
        expect(decodeLinkState(text)).toEqual({ view: { camera }, rakes: [], surfaces: [], slices: [], lines: [] });
    });

    it('keeps masks that can be some, whoever has sent them', () => {
        const masks = { s1: 'CD_-0', s2: 7, s3: '', s4: 'a'.repeat(801), s5: '<b>', s6: null } as unknown as Record<
            string,
            string
        >;
        const text = encodeLinkState({ view: { masks }, rakes: [], surfaces: [] });
        expect(decodeLinkState(text).view.masks).toEqual({ s1: 'CD_-0' });
    });

    it('is nothing where someone has damaged it', () => {
        const nothing = { view: {}, rakes: [], surfaces: [], slices: [], lines: [] };
        for (const text of ['', '!', 'bm9uc2Vuc2U', btoa('7'), btoa('{"v":{"camera":{"position":[1,2]}},"r":[{}],"s":7}')]) {
            expect(decodeLinkState(text)).toEqual(nothing);
        }
    });
});

const token = '0123456789abcdef'.repeat(4);
const read = (text: string): unknown => readNewLink(text, 'session-3');

describe('a link that is pasted', () => {
    it('lets the page in where it leads here, also as the server prints it or as a token alone', () => {
        const wanted = { to: 'here', token };
        expect(read(`http://127.0.0.1:8080/flow/#token=${token}`)).toEqual(wanted);
        expect(read(` wakesurf: http://127.0.0.1:8080/flow/#token=${token}\n`)).toEqual(wanted);
        expect(read(`http://127.0.0.1:8080/flow/#session=session-3&token=${token}`)).toEqual(wanted);
        expect(read(token)).toEqual(wanted);
        // A tunnel to another port, or a prefix that the server does not know of.
        for (const address of ['http://127.0.0.1:8081/flow/', 'http://127.0.0.1:8080/', 'https://node7.lab:8443/']) {
            expect(read(`${address}#token=${token}`)).toEqual(wanted);
        }
    });

    it('opens another session', () => {
        const fragment = `#session=session-4&token=${token}`;
        expect(read(`http://127.0.0.1:8080/flow/${fragment}`)).toEqual({ to: 'session', fragment });
    });

    it('is none without a token, or where it is not of the web', () => {
        const texts = ['', 'hello', 'http://127.0.0.1:8080/flow/', `javascript:alert(1)#token=${token}`, `${token} ${token}`];
        for (const text of texts) expect(read(text), text).toBeNull();
    });
});
