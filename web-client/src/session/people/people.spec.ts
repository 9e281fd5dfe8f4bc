import { describe, expect, it } from 'vitest';
import type { CameraPlace, Participant, Vec3 } from '../../protocol/messages.ts';
import type { CameraPose } from '../../scene/camera/cameraControls.ts';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { People } from './people.ts';

const ada: Participant = { participant: 'p1', name: 'Ada', colour: '#0072b2', role: 'host', connected: true };
const ben: Participant = { participant: 'p2', name: 'Ben', colour: '#e69f00', role: 'editor', connected: true };

function bench(participants: Participant[]) {
    const state = new AppState();
    const view = new ViewState();
    const told: object[] = [];
    const due: (() => void)[] = [];
    const placed: CameraPose[] = [];
    const pose: CameraPose = { position: [0, 0, 9], target: [0, 0, 0], orthographic: false };
    const people = new People({
        ...{ state, view, requestFrame: () => undefined },
        worker: { notify: (_, presence) => told.push(presence) },
        controls: { pose, fov: 30, follow: (to) => placed.push(to) },
        later: (action) => {
            due.push(action);
            return () => undefined;
        },
    });
    people.joined({ participants, you: 'p1' });
    const rest = (): void => due.splice(0).forEach((action) => action());
    return { state, view, people, told, placed, rest };
}

const pointer = (x: number): { pointer: Vec3 } => ({ pointer: [x, 0, 0] });

describe('People', () => {
    it('tells nothing while no one else is there, and the camera as soon as someone comes', () => {
        const { people, told } = bench([ada]);
        people.tell(pointer(1));
        expect(told).toEqual([]);
        people.patched([ben], []);
        expect(told).toEqual([expect.objectContaining({ camera: expect.anything() as object })]);
    });

    it('tells the newest at most once in a while, and nothing twice', () => {
        const { people, told, rest } = bench([ada, ben]);
        rest();
        told.length = 0;
        for (const x of [1, 2, 3]) people.tell(pointer(x));
        expect(told).toEqual([pointer(1)]);
        rest();
        expect(told).toEqual([pointer(1), pointer(3)]);
        rest();
        people.tell(pointer(3));
        expect(told).toHaveLength(2);
    });

    it('keeps what others did not change, and forgets who left', () => {
        const { people, state } = bench([ada, ben]);
        people.patched([{ participant: 'p2', pointer: [1, 2, 3] }], []);
        people.patched([{ participant: 'p2', selected: 'r1' }], []);
        expect(state.participants.value.get('p2')).toMatchObject({ name: 'Ben', pointer: [1, 2, 3], selected: 'r1' });
        people.patched([], ['p2']);
        expect([...state.participants.value.keys()]).toEqual(['p1']);
    });

    it('looks as the followed one does until the camera is taken or they leave', () => {
        const { people, view, placed } = bench([ada, ben]);
        const camera = (x: number): CameraPlace => ({ position: [x, 0, 0], target: [0, 0, 0], up: [0, 0, 1], fov: 30 });
        people.patched([{ participant: 'p2', camera: camera(5) }], []);
        expect(placed).toEqual([]);
        people.startFollowing('p2');
        people.patched([{ participant: 'p2', camera: camera(6) }], []);
        expect(placed.map(({ position }) => position[0])).toEqual([5, 6]);
        people.takeCamera();
        people.patched([{ participant: 'p2', camera: camera(7) }], []);
        expect(placed).toHaveLength(2);
        people.startFollowing('p2');
        people.patched([], ['p2']);
        expect(view.following.value).toBeNull();
    });
});
