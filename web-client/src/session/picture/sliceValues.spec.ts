import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { lateMs } from '../base/lateWaits.ts';
import { type SliceWish, pathOf, SliceValues } from './sliceValues.ts';

const wish = (z: number): SliceWish => ({ dataset: 'flow', origin: [0, 0, z], normal: [0, 0, 1], field: 'p', time: 1 });

function rasterBytes(): ArrayBuffer {
    const bytes = new ArrayBuffer(114);
    const view = new DataView(bytes);
    [0x57, 0x53, 0x4c, 1].forEach((byte, i) => view.setUint8(i, byte));
    [1, 1, 1].forEach((count, i) => view.setUint32(4 + 4 * i, count, true));
    return bytes;
}

/** A server that answers when the test says so. */
class Server {
    readonly open: { path: string; signal: AbortSignal; answer: (reply: Response) => void }[] = [];
    readonly asked: string[] = [];
    readonly arrived: number[] = [];
    readonly faults: (string | null)[] = [];
    readonly late: boolean[] = [];
    readonly values = new SliceValues({
        fetch: (path, { signal }) => this.fetch(path, signal!),
        fullSamples: () => 800,
        arrived: (_, __, { origin }) => this.arrived.push(origin[2]),
        told: (_, fault) => this.faults.push(fault),
        late: (_, late) => this.late.push(late),
        now: () => 0,
    });

    async answer(reply = new Response(rasterBytes())): Promise<void> {
        this.open.shift()!.answer(reply);
        await vi.advanceTimersByTimeAsync(0);
    }

    private fetch(path: string, signal: AbortSignal): Promise<Response> {
        const query = new URLSearchParams(path.split('?')[1]);
        this.asked.push(
            `${query.get('plane')!.split(',')[2]!.split(':')[0]} ${Number(query.get('samples')) < 800 ? 'coarse' : 'fine'}`,
        );
        return new Promise((answer, reject) => {
            const each = { path, signal, answer };
            this.open.push(each);
            signal.addEventListener('abort', () => {
                this.open.splice(this.open.indexOf(each), 1);
                reject(new DOMException('gone', 'AbortError'));
            });
        });
    }
}

describe('the values of a slice', () => {
    beforeEach(() => void vi.useFakeTimers());
    afterEach(() => void vi.useRealTimers());

    it('are asked for by an address that says all of it', () => {
        expect(pathOf({ ...wish(0.5), field: 'p rgh' }, 640)).toBe(
            'api/v1/datasets/flow/slice.bin?plane=0%2C0%2C0.5%3A0%2C0%2C1&field=p+rgh&samples=640&time=1',
        );
    });

    it('are late after ten seconds, and can be asked for again', async () => {
        const server = new Server();
        server.values.want('c1', wish(0));
        await vi.advanceTimersByTimeAsync(lateMs - 1);
        expect(server.late).toEqual([]);
        await vi.advanceTimersByTimeAsync(1);
        expect([server.late, server.asked]).toEqual([[true], ['0 coarse']]);
        server.values.retry('c1');
        await vi.advanceTimersByTimeAsync(0);
        expect([server.late, server.asked, server.faults]).toEqual([[true, false], ['0 coarse', '0 coarse'], []]);
        await server.answer();
        expect([server.arrived, server.late]).toEqual([[0], [true, false]]);
    });

    it('come coarsely at once, and as fine as the screen when the plane rests', async () => {
        const server = new Server();
        server.values.want('c1', wish(0));
        expect(server.asked).toEqual(['0 coarse']);
        await server.answer();
        expect(server.asked).toEqual(['0 coarse']);
        await vi.advanceTimersByTimeAsync(200);
        expect(server.values.unfinished).toBe(true);
        await server.answer();
        expect(server.values.unfinished).toBe(false);
        await vi.advanceTimersByTimeAsync(1000);
        expect(server.asked).toEqual(['0 coarse', '0 fine']);
        expect(server.arrived).toEqual([0, 0]);
        expect(server.faults).toEqual([null, null]);
    });

    it('of a plane that is dragged are those of its newest place, never more than one on the way', async () => {
        const server = new Server();
        for (const z of [1, 2, 3, 4]) server.values.want('c1', wish(z));
        expect(server.open.length).toBe(1);
        await server.answer();
        expect(server.asked).toEqual(['1 coarse', '4 coarse']);
        await server.answer();
        expect(server.arrived).toEqual([1, 4]);
    });

    it('that are fine and out of date are cancelled', async () => {
        const server = new Server();
        server.values.want('c1', wish(1));
        await server.answer();
        await vi.advanceTimersByTimeAsync(200);
        const [fine] = server.open;
        server.values.want('c1', wish(2));
        expect(fine!.signal.aborted).toBe(true);
        await vi.advanceTimersByTimeAsync(0);
        expect(server.asked).toEqual(['1 coarse', '1 fine', '2 coarse']);
        expect(server.faults).toEqual([null]);
    });

    it('that cannot be had are not asked for again and again, and the server says why', async () => {
        const server = new Server();
        server.values.want('c1', wish(9));
        const fault = JSON.stringify({ error: { message: 'the plane misses the domain by 4', hint: '' } });
        await server.answer(new Response(fault, { status: 400 }));
        await vi.advanceTimersByTimeAsync(1000);
        expect(server.asked).toEqual(['9 coarse']);
        expect(server.faults[0]).toContain('misses the domain');
        server.values.again();
        expect(server.asked.length).toBe(2);
    });

    it('of a slice that is gone are cancelled and not shown', async () => {
        const server = new Server();
        server.values.want('c1', wish(1));
        server.values.remove('c1');
        await vi.advanceTimersByTimeAsync(1000);
        expect(server.open).toEqual([]);
        expect(server.arrived).toEqual([]);
    });
});
