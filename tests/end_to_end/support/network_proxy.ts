// A network between page and server that can be cut and mended (connections end at once, and new ones are refused) and be slow:
// what Chromium's own throttling cannot do to WebSockets.
import { connect, createServer, type AddressInfo, type Server, type Socket } from 'node:net';

export class NetworkProxy {
    readonly port: number;
    private readonly server: Server;
    private readonly sockets = new Set<Socket>();
    private target = 0;
    private whole = true;
    private delayMs = 0;

    private constructor(server: Server) {
        this.server = server;
        this.port = (server.address() as AddressInfo).port;
        server.on('connection', (socket) => this.pass(socket));
    }

    static async start(): Promise<NetworkProxy> {
        const server = createServer();
        await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
        return new NetworkProxy(server);
    }

    get origin(): string {
        return `http://127.0.0.1:${this.port}`;
    }

    /** To which port connections go from now on. */
    lead(target: number): void {
        this.target = target;
    }

    cut(): void {
        this.whole = false;
        for (const socket of this.sockets) socket.destroy();
    }

    mend(): void {
        this.whole = true;
    }

    /** Everything takes so much longer in each direction from now on. */
    delay(milliseconds: number): void {
        this.delayMs = milliseconds;
    }

    stop(): void {
        this.cut();
        this.server.close();
    }

    private pass(fromPage: Socket): void {
        if (!this.whole) {
            fromPage.destroy();
            return;
        }
        const toServer = connect(this.target, '127.0.0.1');
        for (const [socket, other] of [
            [fromPage, toServer],
            [toServer, fromPage],
        ] as const) {
            this.sockets.add(socket);
            socket.setNoDelay(true);
            // In order: timers of one length end in the order they were begun in.
            socket.on('data', (bytes) => setTimeout(() => other.write(bytes), this.delayMs));
            socket.on('end', () => setTimeout(() => other.end(), this.delayMs));
            socket.on('error', () => other.destroy());
            socket.on('close', () => {
                this.sockets.delete(socket);
                other.destroy();
            });
        }
    }
}
