// Sessions as files: fetched to be saved, and sent to be made again. Over HTTP, because a message to the
// server is short.
import type { SessionImported } from '../../protocol/messages.ts';
import { faultOf } from '../../connection/httpFault.ts';
import type { OwnServer } from '../../connection/ownServer.ts';

/** Limits a file, in bytes, to what the server takes; refused here already, lest it is sent for nothing. */
const largestMiB = 24;

type Asked = Pick<OwnServer, 'fetch'>;

/** Error: in words. */
export async function fetchSessionFile(server: Asked, session: string): Promise<Blob> {
    const reply = await server.fetch(`api/v1/sessions/${encodeURIComponent(session)}/session.json`);
    if (!reply.ok) throw await faultOf(reply);
    return reply.blob();
}

/** Error: in words. */
export async function sendSessionFile(server: Asked, file: Blob): Promise<SessionImported> {
    if (file.size > largestMiB << 20) {
        throw new Error(
            `This file is ${Math.ceil(file.size / (1 << 20))} MiB; a session file is at most ${largestMiB} MiB. Choose the file of an exported session.`,
        );
    }
    const headers = { 'Content-Type': 'application/json' };
    const reply = await server.fetch('api/v1/sessions', { method: 'POST', headers, body: file });
    if (!reply.ok) throw await faultOf(reply);
    return (await reply.json()) as SessionImported;
}

/** The picture of a session, or null where it has none any more. */
export async function fetchThumbnail(server: Asked, session: string): Promise<Blob | null> {
    const reply = await server.fetch(`api/v1/sessions/${encodeURIComponent(session)}/thumbnail`);
    return reply.ok ? reply.blob() : null;
}
