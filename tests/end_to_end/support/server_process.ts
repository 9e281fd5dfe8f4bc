// The real server as a process of its own, on a port that it chooses or that it is given again.
import { type ChildProcess, spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { projectRoot } from './project_root.ts';

export interface ServerOptions {
    port?: number;
    tokenFile?: string;
    /** Folder that sessions are kept in. */
    state?: string;
    /** A further page address that may connect. */
    origin?: string;
    /** Instead of the bundled data. */
    data?: string;
    /** Further datasets. */
    more?: readonly string[];
    /** Of the server, as "160MiB"; by itself a part of the machine's. */
    memory?: string;
    /** Kept between servers of one test, so that only the first imports. */
    store: string;
}

export class ServerProcess {
    /** The link of the first line on standard output, token included. */
    readonly link: string;
    private readonly child: ChildProcess;

    private constructor(child: ChildProcess, link: string) {
        this.child = child;
        this.link = link;
    }

    static async start({
        port = 0,
        tokenFile,
        state,
        origin,
        memory,
        data,
        more = [],
        store,
    }: ServerOptions): Promise<ServerProcess> {
        const binary = process.env['WAKESURF_BINARY'] ?? join(projectRoot, 'build/release/bin/wakesurf');
        const optional = Object.entries({ '--token-file': tokenFile, '--state': state, '--origin': origin, '--memory': memory });
        const given = optional.flatMap(([name, value]) => (value === undefined ? [] : [name, value]));
        const child = spawn(
            binary,
            [
                'serve',
                data ?? process.env['WAKESURF_DATA'] ?? join(projectRoot, 'data/sqcyl/sqcyl.pvd'),
                ...more,
                ...['--listen', `127.0.0.1:${port}`, '--store', store],
                ...['--web', join(projectRoot, 'web-client/dist'), ...given],
            ],
            { stdio: ['ignore', 'pipe', 'pipe'] },
        );
        let log = '';
        child.on('error', (error) => (log += `${error.message}; build it, or set WAKESURF_BINARY`));
        child.stderr.on('data', (text: Buffer) => (log += text.toString()));
        for await (const line of createInterface({ input: child.stdout })) {
            const link = /^wakesurf: (\S+)$/.exec(line)?.[1];
            if (link === undefined) throw new Error(`unexpected first line: ${line}\n${log}`);
            return new ServerProcess(child, link);
        }
        throw new Error(`${binary} ended before it listened:\n${log}`);
    }

    get port(): number {
        return Number(new URL(this.link).port);
    }

    get token(): string {
        return new URLSearchParams(new URL(this.link).hash.slice(1)).get('token') ?? '';
    }

    /** One call over HTTP: a client of its own, that shares no code with the page. */
    async call(method: string, params: object): Promise<Record<string, unknown>> {
        const response = await fetch(new URL('/rpc', this.link), {
            method: 'POST',
            headers: {
                Authorization: `Bearer ${this.token}`,
                'Content-Type': 'application/json',
            },
            body: JSON.stringify({ jsonrpc: '2.0', id: 1, method, params }),
        });
        const reply = (await response.json()) as { result?: object; error?: unknown };
        if (reply.result === undefined) {
            throw new Error(`${method}: ${JSON.stringify(reply.error)}`);
        }
        return reply.result as Record<string, unknown>;
    }

    /** Waits until the first dataset is there as a whole: a surface that is built before grows with it. */
    async imported(): Promise<void> {
        const { datasets } = (await this.call('dataset.list', {})) as { datasets: { dataset: string }[] };
        await this.call('dataset.open', { dataset: datasets[0]!.dataset });
    }

    /** A link to an empty session, made for it: a visit makes none. */
    async newSession(name?: string): Promise<string> {
        const { session } = await this.call('session.create', name === undefined ? {} : { name });
        return `${this.link}&session=${String(session)}`;
    }

    /** A link to a session that begins with the stream surface that is suggested for the first dataset. */
    async streamSession(name?: string): Promise<string> {
        const link = await this.newSession(name);
        const session = new URLSearchParams(new URL(link).hash.slice(1)).get('session')!;
        const { datasets } = (await this.call('dataset.list', {})) as { datasets: { dataset: string }[] };
        const { dataset } = datasets[0]!;
        const found = (await this.call('dataset.suggest', { dataset })) as {
            rake: object;
            surfaces: ({ kind: string } & object)[];
        };
        const { rake } = await this.call('rake.set', { session, ...found.rake, name: 'Rake 1', default: true });
        const surface = found.surfaces.find(({ kind }) => kind === 'stream');
        await this.call('surface.set', { session, rake, dataset, ...surface, default: true });
        return link;
    }

    /** Ends the process and waits until its port is free. */
    async stop(signal: 'SIGTERM' | 'SIGKILL' = 'SIGTERM'): Promise<void> {
        if (this.child.exitCode !== null || this.child.signalCode !== null) return;
        const ended = new Promise((resolve) => this.child.once('exit', resolve));
        this.child.kill(signal);
        await ended;
    }
}

let bundled: string | null = null;

/** The store of the bundled data for all files of tests that do not look at imports: it is imported once. It goes with the process. */
export function bundledStore(): string {
    if (bundled === null) {
        const { path, remove } = temporaryFolder();
        bundled = path;
        process.once('exit', remove);
    }
    return bundled;
}

/** A new folder and its removal. */
export function temporaryFolder(): { path: string; remove: () => void } {
    const path = mkdtempSync(join(tmpdir(), 'wakesurf-'));
    return { path, remove: () => rmSync(path, { recursive: true, force: true }) };
}
