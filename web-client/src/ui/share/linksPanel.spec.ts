// @vitest-environment happy-dom
import { signal } from '@preact/signals-core';
import { beforeEach, describe, expect, it } from 'vitest';
import type { ShareLink } from '../../protocol/messages.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './linksPanel.ts';

const week = 7 * 24 * 3600;
let bench: PageBench;
let panel: ShownPanel;
let shares: ShareLink[];
let copies: number;

function shareOf(grant: string, change: Partial<ShareLink> = {}): ShareLink {
    return { grant, role: 'editor', madeBy: { name: 'Ada', participant: 'p' }, ...change } as ShareLink;
}

beforeEach(async () => {
    bench = new PageBench();
    shares = [];
    bench.answers['session.shares'] = () => ({ shares });
    bench.answers['session.share'] = ({ expiresIn = week }) => {
        const expires = expiresIn === null ? undefined : 1_700_000_000 + Number(expiresIn);
        shares = [...shares, shareOf(`grant-${shares.length}`, expires === undefined ? {} : { expires })];
        return { grant: 'g', link: '/#session=s&token=t', ...(expires === undefined ? {} : { expires }) };
    };
    bench.answers['session.unshare'] = ({ grant, children }) => {
        shares = shares.filter((each) => each.grant !== grant && children !== true);
        return {};
    };
    const { state, worker, tries: calls } = bench;
    const views = { link: () => 'http://localhost/#session=s&state=seen' };
    copies = 0;
    const ownCopy = { possible: signal(true), begin: () => void ++copies };
    panel = await ShownPanel.of('wakesurf-links', { state, worker, calls, views, ownCopy });
});

describe('a link', () => {
    it('holds for 7 days where nothing else is chosen, which is said where it is made, and names who made it', async () => {
        expect(panel.text).toContain('A link is valid for 7 days unless you choose another time');
        await panel.press('Make a link');
        expect(bench.asked('session.share')).toEqual([{ role: 'editor' }]);
        expect(panel.get('#share-link').value).toContain('token=t&state=seen');
        expect(panel.within('li').text).toContain('made by Ada');

        await panel.enter('#share-lifetime', 'How long the link is valid', 4);
        await panel.press('Make a link');
        expect(bench.asked('session.share').at(-1)).toEqual({ role: 'editor', expiresIn: null });
        expect(panel.all('li').map(({ textContent }) => textContent?.includes('until it is revoked'))).toEqual([false, true]);
    });

    it('that has made others is taken back with them or without', async () => {
        for (const [answer, asked] of [
            ['Only this one', { grant: 'parent' }],
            ['Both', { grant: 'parent', children: true }],
        ] as const) {
            shares = [shareOf('parent', { children: 1 })];
            // The list is asked for again with every look at it.
            panel = await ShownPanel.of(
                'wakesurf-links',
                document.querySelector<HTMLElement & { model: object }>('wakesurf-links')!.model,
            );
            const item = panel.within('li');
            expect(item.text).toContain('1 link or copy was made by people who used it');
            await item.press('Revoke');
            expect(item.text).toContain('Revoke what those people made as well?');
            await item.press(answer);
            expect(bench.asked('session.unshare').at(-1)).toEqual(asked);
            expect(panel.all('li')).toEqual([]);
        }
    });

    it('is made by those who may invite alone', async () => {
        bench.state.role.value = 'editor';
        await rested();
        expect(panel.text).toContain('Only people who can invite can make links');
        expect(panel.all('button', 'Make a link')).toEqual([]);
    });
});

describe('a copy of the session', () => {
    it('can be had by everyone', async () => {
        for (const role of ['host', 'editor', 'viewer'] as const) {
            bench.state.role.value = role;
            await rested();
            await panel.press('Continue in a copy');
        }
        expect(copies).toBe(3);
    });
});
