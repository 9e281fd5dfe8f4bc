// A reverse proxy as people put before several programs: each is below a prefix of its own, which it takes away.
import { createServer, type IncomingMessage, request, type Server } from 'node:http';
import type { AddressInfo, Socket } from 'node:net';

interface Behind {
    prefix: string;
    port: number;
}

export class PrefixProxy {
    private readonly server: Server;
    private readonly behind: Behind[] = [];
    private readonly sockets = new Set<Socket>();

    private constructor(server: Server) {
        this.server = server;
        server.on('connection', (socket) => {
            this.sockets.add(socket);
            socket.on('error', () => undefined).on('close', () => this.sockets.delete(socket));
        });
        server.on('request', (incoming, outgoing) => {
            const passed = this.pass(incoming);
            if (passed === null) return void outgoing.writeHead(404).end();
            passed.on('response', (answer) => {
                outgoing.writeHead(answer.statusCode!, answer.rawHeaders);
                answer.pipe(outgoing);
            });
            passed.on('error', () => outgoing.destroy());
            incoming.pipe(passed);
        });
        server.on('upgrade', (incoming, socket: Socket) => {
            const passed = this.pass(incoming);
            if (passed === null) return void socket.destroy();
            passed.on('upgrade', (answer, upstream, head) => {
                const lines = [`HTTP/1.1 ${answer.statusCode} ${answer.statusMessage}`];
                for (let i = 0; i < answer.rawHeaders.length; i += 2) {
                    lines.push(`${answer.rawHeaders[i]}: ${answer.rawHeaders[i + 1]}`);
                }
                socket.write(`${lines.join('\r\n')}\r\n\r\n`);
                socket.write(head);
                upstream.on('error', () => socket.destroy()).on('close', () => socket.destroy());
                socket.on('close', () => upstream.destroy());
                socket.pipe(upstream).pipe(socket);
            });
            passed.on('response', () => socket.destroy());
            passed.on('error', () => socket.destroy());
            passed.end();
        });
    }

    static async start(): Promise<PrefixProxy> {
        const server = createServer();
        await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
        return new PrefixProxy(server);
    }

    /** A name that is no machine's own: what comes by it comes from elsewhere, for the server. */
    get origin(): string {
        return `http://lab.localhost:${(this.server.address() as AddressInfo).port}`;
    }

    lead(prefix: string, port: number): void {
        this.behind.push({ prefix, port });
    }

    stop(): void {
        this.server.close();
        for (const socket of this.sockets) socket.destroy();
    }

    private pass(incoming: IncomingMessage): ReturnType<typeof request> | null {
        const { url = '', method, headers } = incoming;
        const found = this.behind.find(({ prefix }) => url.startsWith(prefix));
        if (found === undefined) return null;
        const { prefix, port } = found;
        const path = `/${url.slice(prefix.length)}`;
        return request({ host: '127.0.0.1', port, path, method, headers });
    }
}
