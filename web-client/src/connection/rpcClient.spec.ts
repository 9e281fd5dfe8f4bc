import { describe, expect, it } from 'vitest';
import { parseIncoming, RpcError } from '../protocol/jsonRpc.ts';
import { type MethodName, UnreadableAnswer } from '../protocol/messages.ts';
import { emptySnapshot, sampleRake, sampleStatistics } from '../testing/records.ts';
import { DisconnectedError, RpcClient } from './rpcClient.ts';

function answer(client: RpcClient, text: string): void {
    const incoming = parseIncoming(text);
    if (incoming !== null) client.receive(incoming);
}

describe('RpcClient', () => {
    it('hands each caller its own answer, in whatever order they come', async () => {
        const client = new RpcClient(() => true);
        const first = client.call('surface.delete', { surface: 'a' });
        const second = client.call('surface.delete', { surface: 'b' });
        answer(client, '{"jsonrpc":"2.0","id":2,"result":{"seq":2}}');
        answer(client, '{"jsonrpc":"2.0","id":1,"result":{"seq":1}}');
        expect([await first, await second]).toEqual([{ seq: 1 }, { seq: 2 }]);
    });

    it('rejects with the error of the server', async () => {
        const client = new RpcClient(() => true);
        const call = client.call('server.info', {});
        answer(client, '{"jsonrpc":"2.0","id":1,"error":{"code":-32001,"message":"no"}}');
        await expect(call).rejects.toThrow(RpcError);
    });

    it('fails everything pending when the connection is lost, and calls without one', async () => {
        let connected = true;
        const client = new RpcClient(() => connected);
        const call = client.call('server.info', {});
        connected = false;
        client.disconnected();
        await expect(call).rejects.toThrow(DisconnectedError);
        await expect(client.call('server.info', {})).rejects.toThrow(DisconnectedError);
    });

    it('cancels a call that is open, by its own number, and none that is answered', async () => {
        const sent: string[] = [];
        const client = new RpcClient((text) => sent.push(text) > 0);
        const [first, second] = [new AbortController(), new AbortController()];
        void client.call('server.info', {}, first.signal);
        const other = client.call('server.ping', {}, second.signal);
        first.abort();
        expect(JSON.parse(sent[2]!)).toEqual({ jsonrpc: '2.0', method: '$/cancelRequest', params: { id: 1 } });
        answer(client, '{"jsonrpc":"2.0","id":2,"result":{}}');
        await other;
        second.abort();
        expect(sent).toHaveLength(3);
    });

    it('takes answers with members that it does not know', async () => {
        const client = new RpcClient(() => true);
        const call = client.call('time.pause', {});
        const clock = { time: null, playing: false, speed: 1, loop: false, from: null, to: null, zone: 'UTC' };
        answer(client, JSON.stringify({ jsonrpc: '2.0', id: 1, result: { clock, newer: true } }));
        expect(await call).toEqual({ clock, newer: true });
    });

    it('refuses answers that are not what the method answers, in words that name it and the member', async () => {
        const client = new RpcClient(() => true);
        const refused = async (method: MethodName, result: unknown): Promise<string> => {
            const call = client.call(method, {});
            client.receive({ type: 'result', id: ++calls, result });
            const error: unknown = await call.catch((why: unknown) => why);
            expect(error).toBeInstanceOf(UnreadableAnswer);
            return (error as UnreadableAnswer).message;
        };
        let calls = 0;
        const words = (fault: string): string => `This page cannot read what the server sent: ${fault}. Reload the page.`;
        const snapshot = { ...emptySnapshot('a'), rakes: [sampleRake(), { ...sampleRake(), seeds: 2.5 }] };
        const joined = { you: 'p1', role: 'host', resumeToken: 'x', seq: 1, participants: [], resumed: false };
        expect(await refused('session.join', { ...joined, snapshot })).toBe(
            words('in the answer to session.join, snapshot.rakes[1].seeds is not a whole number'),
        );
        expect(await refused('session.join', joined)).toBe(words('in the answer to session.join, snapshot is missing'));
        expect(await refused('surface.stats', { ...sampleStatistics(), kind: 'steam' })).toBe(
            words('in the answer to surface.stats, kind is not one of stream, path, streak, time, level'),
        );
        expect(await refused('dataset.list', [])).toBe(words('the answer to dataset.list is not an object'));
    });

    it('ignores answers that no one waits for', () => {
        const client = new RpcClient(() => true);
        expect(() => answer(client, '{"jsonrpc":"2.0","id":9,"result":1}')).not.toThrow();
    });
});
