// Sessions as files: fetched to be saved, and sent to be made again. Over HTTP, because a message to the server is short.
import type { SessionImported } from '../../protocol/messages.ts';
import { faultOf } from '../../connection/httpFault.ts';

/** What the server takes at most; refused here already, lest it is sent for nothing. */
const largestMiB = 24;

/** Error: in words. @param base address of the server, as urlState.ts has it */
export async function fetchSessionFile(base: string, session: string): Promise<Blob> {
    const reply = await fetch(new URL(`api/v1/sessions/${encodeURIComponent(session)}/session.json`, base));
    if (!reply.ok) throw await faultOf(reply);
    return reply.blob();
}

/** Error: in words. */
export async function sendSessionFile(base: string, file: Blob): Promise<SessionImported> {
    if (file.size > largestMiB << 20) {
        throw new Error(
            `This file is ${Math.ceil(file.size / (1 << 20))} MiB; a session file is at most ${largestMiB} MiB. Choose the file of an exported session.`,
        );
    }
    const headers = { 'Content-Type': 'application/json' };
    const reply = await fetch(new URL('api/v1/sessions', base), { method: 'POST', headers, body: file });
    if (!reply.ok) throw await faultOf(reply);
    return (await reply.json()) as SessionImported;
}
