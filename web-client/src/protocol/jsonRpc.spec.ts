import { describe, expect, it } from 'vitest';
import { encodeNotification, encodeRequest, parseIncoming, RpcError } from './jsonRpc.ts';

describe('jsonRpc', () => {
    it('writes requests and notifications as JSON-RPC 2.0', () => {
        expect(JSON.parse(encodeRequest(7, 'rake.set', { seeds: 2 }))).toEqual({
            jsonrpc: '2.0',
            id: 7,
            method: 'rake.set',
            params: { seeds: 2 },
        });
        expect(JSON.parse(encodeNotification('frame.ack', {}))).not.toHaveProperty('id');
    });

    it('tells results, errors and notifications apart', () => {
        expect(parseIncoming('{"jsonrpc":"2.0","id":1,"result":null}')).toEqual({
            type: 'result',
            id: 1,
            result: null,
        });
        const error = { code: -32012, message: 'outside', data: { kind: 'outside', hint: 'move' } };
        expect(parseIncoming(JSON.stringify({ jsonrpc: '2.0', id: 1, error }))).toEqual({
            type: 'error',
            id: 1,
            error,
        });
        expect(parseIncoming('{"jsonrpc":"2.0","id":null,"error":{"code":1,"message":"x"}}')).toEqual({
            type: 'error',
            id: null,
            error: { code: 1, message: 'x' },
        });
        expect(parseIncoming('{"jsonrpc":"2.0","method":"server.notice"}')).toEqual({
            type: 'notification',
            method: 'server.notice',
            params: {},
        });
    });

    it.each(['', 'x', '[]', 'null', '{}', '{"jsonrpc":"2.0"}', '{"jsonrpc":"1.0","id":1,"result":1}'])(
        'takes %s for nothing',
        (text) => expect(parseIncoming(text)).toBeNull(),
    );

    it('keeps kind and hint of an error', () => {
        const error = new RpcError({ code: 5, message: 'm', data: { kind: 'k', hint: 'h' } });
        expect([error.code, error.message, error.kind, error.hint]).toEqual([5, 'm', 'k', 'h']);
        expect(new RpcError({ code: 5, message: 'm', data: 3 }).hint).toBe('');
    });
});
