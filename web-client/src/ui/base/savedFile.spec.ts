// @vitest-environment happy-dom
import { afterEach, expect, it, vi } from 'vitest';
import { savedFiles, settled } from '../../testing/fakes.ts';
import { SavedFile } from './savedFile.ts';

afterEach(() => {
    vi.restoreAllMocks();
});

it('a file is saved once it is there, unless its user has given it up', async () => {
    const saved = savedFiles();
    const file = new SavedFile();
    const asked: { answer: (file: Blob | null) => void; signal: AbortSignal }[] = [];
    const get = (signal: AbortSignal): Promise<Blob | null> => new Promise((answer) => asked.push({ answer, signal }));
    void file.save('one.csv', get);
    expect(file.isAwaited).toBe(true);
    file.cancel();
    expect([file.isAwaited, asked[0]!.signal.aborted]).toEqual([false, true]);
    void file.save('two.csv', get);
    asked[0]!.answer(new Blob(['late']));
    asked[1]!.answer(new Blob(['2']));
    await settled();
    expect([file.isAwaited, saved.map(({ name }) => name)]).toEqual([false, ['two.csv']]);
    void file.save('none.csv', get);
    asked[2]!.answer(null);
    await settled();
    expect([file.isAwaited, saved.length]).toEqual([false, 1]);
});
