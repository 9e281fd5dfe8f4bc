// Names that others have written: of data, fields, sessions, rakes, views and people. On the page they are text, and what
// they do to the direction of writing ends with them.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { finalSurface, newContext, openPage } from './support/browser_page.ts';
import { Guest } from './support/guest.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

const element = `<img src=x onerror=owned=1><b id=owned>"'&amp;`;
/** Letters that are written from right to left, and a digit, which follows what is before it. */
const turning = '\u202e\u05d0\u05d1\u05d2 1';
/** @param what  tells them apart */
function hostile(what: string, more = ''): string {
    return `${what}${element}${more}${turning}`;
}

const [data, store] = [temporaryFolder(), temporaryFolder()];
let server: ServerProcess;
let guest: Guest;
let page: Page;

/** Names of data may have what calls refuse. */
const field = hostile('field', 'long'.repeat(20));
const dataset = hostile('data', `\u001b[31m\n${'long'.repeat(20)}`);

function escaped(text: string): string {
    return text.replace(/[&<>"\n]/g, (sign) => `&#${sign.charCodeAt(0)};`);
}

beforeAll(async () => {
    const file = join(data.path, `${dataset}.vti`);
    const array = (name: string, components: number, value: string): string =>
        `<DataArray type="Float32" Name="${escaped(name)}" NumberOfComponents="${components}" format="ascii">${value.repeat(125)}</DataArray>`;
    writeFileSync(
        file,
        `<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian"><ImageData WholeExtent="0 4 0 4 0 4" Origin="0 0 0"
Spacing="1 1 1"><Piece Extent="0 4 0 4 0 4"><PointData>${array('U', 3, '1 0 0 ')}${array(field, 1, '2 ')}</PointData></Piece></ImageData></VTKFile>`,
    );
    server = await ServerProcess.start({ data: file, store: store.path });
    await server.imported();
    const link = await server.newSession(hostile('session'));
    const session = new URLSearchParams(new URL(link).hash.slice(1)).get('session')!;
    const { datasets } = (await server.call('dataset.list', {})) as { datasets: { dataset: string }[] };
    const points = [
        [0.5, 1, 2],
        [0.5, 3, 2],
    ];
    const made = await server.call('rake.set', { session, kind: 'line', points, seeds: 8, name: hostile('rake') });
    await server.call('surface.set', {
        session,
        rake: made['rake'],
        dataset: datasets[0]!.dataset,
        kind: 'stream',
        to: 2,
        separation: 0.5,
    });
    const camera = { position: [2, 2, 9], target: [2, 2, 2], up: [0, 1, 0] };
    await server.call('bookmark.set', { session, name: hostile('view'), time: 0, view: { camera } });
    await server.call('annotation.set', { session, text: hostile('note'), position: [2, 2, 2] });
    guest = await Guest.join(server, session, { name: hostile('person'), colour: '#ff8800' });
    page = await openPage(await newContext(await testBrowser(), { width: 1100, height: 800 }), link);
    await finalSurface(page);
});

afterAll(async () => {
    guest.leave();
    await closePages();
    await server.stop();
    for (const { remove } of [data, store]) remove();
});

interface Shown {
    /** Which of the names are seen. */
    seen: string[];
    /** Texts in which something beside a name is not on its own side of it. */
    turned: string[];
    elements: number;
    scripts: number;
}

/** Looks at all that is on the page now. */
function look(): Promise<Shown> {
    return page.evaluate(() => {
        const found = { seen: [] as string[], turned: [] as string[], elements: 0, scripts: 'owned' in window ? 1 : 0 };
        const blocks = new Map<Element, Text[]>();
        const visit = (root: Document | ShadowRoot): void => {
            found.elements += root.querySelectorAll('#owned, img[src=x]').length;
            const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
            for (let text = walker.nextNode() as Text | null; text !== null; text = walker.nextNode() as Text | null) {
                let block = text.parentElement;
                while (block !== null && getComputedStyle(block).display === 'inline' && block.parentElement !== null) {
                    block = block.parentElement;
                }
                if (block === null || block.tagName === 'STYLE') continue;
                blocks.set(block, [...(blocks.get(block) ?? []), text]);
            }
            for (const each of root.querySelectorAll('*')) if (each.shadowRoot !== null) visit(each.shadowRoot);
        };
        visit(document);
        for (const [, texts] of blocks) {
            const signs = texts.flatMap((text) =>
                [...text.data].map((sign, i) => {
                    const range = document.createRange();
                    range.setStart(text, i);
                    range.setEnd(text, i + 1);
                    return { sign, box: range.getBoundingClientRect() };
                }),
            );
            const all = signs.map(({ sign }) => sign).join('');
            const [start, last] = [all.search(/\w+<img/), all.indexOf('\u05d2 1') + 2];
            if (start < 0) continue;
            found.seen.push(all.slice(start));
            if (last < start) continue; // cut short
            const beside = (
                at: number,
                onItsSide: (box: DOMRect, name: DOMRect) => boolean,
                from: number,
                to: number,
            ): boolean => {
                const name = signs[at]!.box;
                const line = signs
                    .slice(from, to)
                    .filter(({ box, sign }) => sign.trim() !== '' && Math.abs(box.top - name.top) < 3);
                return line.every(({ box }) => onItsSide(box, name));
            };
            const isBefore = beside(start, (box, name) => box.right <= name.left + 1, 0, start);
            const isAfter = beside(last, (box, name) => box.left >= name.right - 1, last + 1, signs.length);
            if (!isBefore || !isAfter) found.turned.push(all);
        }
        return found;
    });
}

describe('names that others have written', () => {
    it('make no elements and turn nothing beside them, in any tab and in the list of sessions', async () => {
        const all: Shown[] = [await look()];
        for (const tab of await page.getByRole('tab').all()) {
            await tab.click();
            for (const folded of await page.locator('details').all()) {
                await folded.evaluate((details: HTMLDetailsElement) => (details.open = true));
            }
            await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
            all.push(await look());
        }
        await page.getByRole('complementary').getByRole('button', { name: 'Sessions', exact: true }).click();
        await page.getByRole('list', { name: 'Sessions on this server' }).waitFor();
        all.push(await look());
        const seen = new Set(all.flatMap((each) => each.seen));

        for (const what of ['data', 'field', 'session', 'rake', 'view', 'note', 'person']) {
            expect(
                [...seen].some((text) => text.startsWith(`${what}<img`)),
                what,
            ).toBe(true);
        }
        expect(all.map(({ elements, scripts }) => elements + scripts).every((count) => count === 0)).toBe(true);
        expect([...new Set(all.flatMap((each) => each.turned))]).toEqual([]);
    });
});
