// Someone else in a session, over a WebSocket of its own: a test in the place of a page.
import { expect } from 'vitest';
import WebSocket from 'ws';
import { type Participant, subprotocol, type Vec3 } from '../../../web-client/src/protocol/messages.ts';
import type { ServerProcess } from './server_process.ts';

interface Message {
    id?: number;
    method?: string;
    params?: { participants: Partial<Participant>[] };
    error?: unknown;
}

export class Guest {
    private readonly socket: WebSocket;
    /** What the page has told of what it drags. */
    readonly told: ({ rake: string; points?: Vec3[] } | null)[] = [];
    private readonly answers = new Map<number, (answer: { error?: unknown }) => void>();
    private calls = 0;

    private constructor(socket: WebSocket) {
        this.socket = socket;
        socket.on('message', (data, binary) => {
            if (binary) return;
            const message = JSON.parse((data as Buffer).toString()) as Message;
            if (message.method === 'presence.patched') {
                for (const { dragging } of message.params!.participants) if (dragging !== undefined) this.told.push(dragging);
            }
            this.answers.get(message.id ?? 0)?.(message);
        });
    }

    static async join(server: ServerProcess, session: string, as: { name: string; colour: string }): Promise<Guest> {
        const address = new URL('/ws', server.link);
        address.protocol = 'ws:';
        const socket = new WebSocket(address, subprotocol, { headers: { Authorization: `Bearer ${server.token}` } });
        await new Promise((resolve, reject) => socket.once('open', resolve).once('error', reject));
        const guest = new Guest(socket);
        await guest.call('session.join', { session, ...as });
        return guest;
    }

    async call(method: string, params: object): Promise<void> {
        const id = ++this.calls;
        this.socket.send(JSON.stringify({ jsonrpc: '2.0', id, method, params }));
        const { error } = await new Promise<{ error?: unknown }>((resolve) => this.answers.set(id, resolve));
        expect(error).toBeUndefined();
    }

    leave(): void {
        this.socket.terminate();
    }
}
