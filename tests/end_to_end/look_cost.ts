// What looks cost in the software renderer, where a surface fills the picture: processor time of the process that draws, medians in
// milliseconds of pictures drawn in turns, and how many times that of the plain look, or of the plain body, that is. Prints one line of JSON.
import { launchBrowser } from './support/browser_page.ts';
import { openBundledPage } from './support/bundled_page.ts';
import type { FlatFlow } from './support/looks_page.ts';

const flow: FlatFlow = { corner: [0, 0, 0], size: 10, waves: 0.02, speed: [0.5, 1.5], angle: [-0.7, 0.9] };
const looks = {
    plain: { source: 'scalar' as const },
    texture: { source: 'scalar' as const, texture: true },
    moving: { source: 'scalar' as const, texture: true, textureMoves: 'withTime' as const },
};
const bodies = { body: 'none', bodyTexture: 'standing', bodyMoving: 'flowing' } as const;
const names = [...Object.keys(looks), ...Object.keys(bodies)];
const [rounds, together] = [9, 8];

const browser = await launchBrowser();
try {
    const { page, close } = await openBundledPage(browser, 'looks_page.ts', { width: 1300, height: 900 });
    const system = await browser.newBrowserCDPSession();
    const spentMs = async (): Promise<number> => {
        const { processInfo } = await system.send('SystemInfo.getProcessInfo');
        return 1000 * processInfo.find(({ type }) => type === 'GPU')!.cpuTime;
    };
    const [width, height] = [1300, 900];
    await page.waitForFunction(() => window.lookBench !== undefined);
    const pictures = await Promise.all([
        ...Object.values(looks).map((look) =>
            page.evaluateHandle(([where, style]) => window.lookBench!.ready(where, style), [flow, look] as const),
        ),
        ...Object.values(bodies).map((texture) =>
            page.evaluateHandle(([where, of]) => window.lookBench!.readyBody(where, of), [flow, texture] as const),
        ),
    ]);
    const draw = async (picture: (typeof pictures)[number], times: number): Promise<number> => {
        const before = await spentMs();
        await picture.evaluate((drawn, count) => drawn(count), times);
        return ((await spentMs()) - before) / times;
    };
    for (const picture of pictures) await draw(picture, 2);
    const spent: number[][] = pictures.map(() => []);
    for (let round = 0; round < rounds; ++round) {
        for (const [i, picture] of pictures.entries()) spent[i]!.push(await draw(picture, together));
    }
    await close();
    const medians = spent.map((each) => each.sort((a, b) => a - b)[rounds >> 1]!);
    const byLook = (figures: number[], digits: number): Record<string, number> =>
        Object.fromEntries(names.map((name, i) => [name, Number(figures[i]!.toFixed(digits))] as const));
    const plainBody = names.indexOf('body');
    const times = medians.map((each, i) => each / medians[i < plainBody ? 0 : plainBody]!);
    console.log(
        JSON.stringify({ name: 'browser-looks', width, height, processorMs: byLook(medians, 1), times: byLook(times, 2) }),
    );
} finally {
    await browser.close();
}
