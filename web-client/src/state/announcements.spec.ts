import { describe, expect, it } from 'vitest';
import { Announcements, isolated } from './announcements.ts';

describe('what is said over the picture', () => {
    it('keeps what is said of one thing while another works again', () => {
        const problems = new Announcements();
        problems.say('rake r1', 'someone else drags it');
        problems.tell('probe', new Error('the time is outside'));
        problems.solved('rake r2');
        problems.solved('probe');
        expect([...problems.all.value]).toEqual([['rake r1', 'someone else drags it']]);
        problems.solved('rake r1');
        expect(problems.all.value.size).toBe(0);
    });

    it('has the newest words about a thing, and changes only where they do', () => {
        const problems = new Announcements();
        let changes = 0;
        problems.all.subscribe(() => ++changes);
        problems.say('clock', 'first');
        problems.say('clock', 'second');
        problems.say('clock', 'second');
        problems.solved('nothing of the kind');
        expect([...problems.all.value.values()]).toEqual(['second']);
        expect(changes).toBe(3); // as it was at first, and two changes
    });

    it('offers what can be done about a thing until something else is said of it', () => {
        const notices = new Announcements();
        const done: string[] = [];
        notices.say('dataset', 'another one is shown here', { label: 'Open it', act: () => done.push('opened') });
        notices.remedyOf('dataset')?.act();
        expect(done).toEqual(['opened']);
        notices.say('dataset', 'it is shown now');
        expect(notices.remedyOf('dataset')).toBeUndefined();
    });
});

describe('old news', () => {
    it('goes with the next act of its kind, and what is still true stays', () => {
        const announcements = new Announcements();
        announcements.sayUntil('edit', 'seeds', 'A rake has 2 to 4096 seeds.');
        announcements.sayUntil('press', 'locked', 'This link is for viewing.');
        announcements.say('durability', 'Edits are not on the disk.');
        announcements.passed('edit');
        expect([...announcements.all.value.keys()]).toEqual(['locked', 'durability']);
        announcements.passed('press');
        announcements.passed('edit');
        expect([...announcements.all.value.keys()]).toEqual(['durability']);
    });

    it('is news again when it is said again, and lasts where it is said to last', () => {
        const announcements = new Announcements();
        announcements.sayUntil('edit', 'seeds', 'one');
        announcements.passed('edit');
        announcements.sayUntil('edit', 'seeds', 'one');
        expect(announcements.all.value.get('seeds')).toBe('one');
        announcements.say('seeds', 'two');
        announcements.passed('edit');
        expect(announcements.all.value.get('seeds')).toBe('two');
    });
});

it('names that turn the direction of writing are kept apart from what is beside them, and others are as they are', () => {
    for (const name of ['', 'wake 2', 'Köln, 東京', '<b>"\'&']) expect(isolated(name)).toBe(name);
    expect(isolated('\u05d0\u05d1 1')).toBe('\u2068\u05d0\u05d1 1\u2069');
    expect(isolated('a\u202eb\u2069\u2067c')).toBe('\u2068abc\u2069');
});
