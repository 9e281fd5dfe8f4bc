import { describe, expect, it } from 'vitest';
import { parseIncoming, RpcError } from '../protocol/jsonRpc.ts';
import { DisconnectedError, RpcClient } from './rpcClient.ts';

function answer(client: RpcClient, text: string): void {
    const incoming = parseIncoming(text);
    if (incoming !== null) client.receive(incoming);
}

describe('RpcClient', () => {
    it('hands each caller its own answer, in whatever order they come', async () => {
        const client = new RpcClient(() => true);
        const first = client.call('session.create', {});
        const second = client.call('session.create', {});
        answer(client, '{"jsonrpc":"2.0","id":2,"result":{"session":"b"}}');
        answer(client, '{"jsonrpc":"2.0","id":1,"result":{"session":"a"}}');
        expect([await first, await second]).toEqual([{ session: 'a' }, { session: 'b' }]);
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
        const other = client.call('server.info', {}, second.signal);
        first.abort();
        expect(JSON.parse(sent[2]!)).toEqual({ jsonrpc: '2.0', method: '$/cancelRequest', params: { id: 1 } });
        answer(client, '{"jsonrpc":"2.0","id":2,"result":{}}');
        await other;
        second.abort();
        expect(sent).toHaveLength(3);
    });

    it('ignores answers that no one waits for', () => {
        const client = new RpcClient(() => true);
        expect(() => answer(client, '{"jsonrpc":"2.0","id":9,"result":1}')).not.toThrow();
    });
});
