// Ends this browser's login: the server forgets the cookie, and closes what came by it.
import { faultOf } from './httpFault.ts';

/** Error: in words. @param baseUrl address of the server, with a slash at the end */
export async function logOut(baseUrl: string): Promise<void> {
    let reply: Response;
    try {
        reply = await fetch(new URL('api/v1/logout', baseUrl), {
            method: 'POST',
            headers: { 'Content-Type': 'application/json' },
            body: JSON.stringify({ path: new URL(baseUrl).pathname }),
        });
    } catch {
        throw new Error('The server cannot be reached, so you are still logged in. Try again when there is a connection.');
    }
    if (!reply.ok) throw new Error(`You are still logged in. ${(await faultOf(reply)).message}`);
}
