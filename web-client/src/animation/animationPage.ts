// The page of an animation: one file, opened from a disk, that asks nobody for anything. What it shows was written by
// `wakesurf surface -o FILE.html`; names in it may be a stranger's, so that all words go in as text.
import createDecoderModule from 'draco3d/draco_decoder_nodejs.js';
import wasm from 'draco3d/draco_decoder.wasm?url&inline';
import { DracoPoints } from '../protocol/dracoPoints.ts';
import { FlowScene } from '../scene/scene.ts';
import { probeGraphics } from '../scene/graphics.ts';
import { placeNumber, resolutionOf } from '../scene/base/numbers.ts';
import { plainStyle } from '../scene/surface/surfaceStyle.ts';
import { decodeObstacle } from '../worker/obstacle.ts';
import { type AnimationDescription, type AnimationFile, bytesOf, readAnimation } from './animationFile.ts';
import { type ColourChoice, colourChoices, wishOf } from './animationLook.ts';
import { AnimationSteps } from './animationSteps.ts';
import { Legend } from './legend.ts';
import { Player } from './player.ts';

const noWebGl2 =
    'This browser does not offer WebGL2, which the animation needs. Open the file in a current browser, and allow hardware or ' +
    'software rendering in its settings.';
const surface = 'surface';
const plain: ColourChoice = { title: '', style: { ...plainStyle, source: 'constant', scalar: '' } };

function part<Kind extends HTMLElement>(id: string, kind: new () => Kind): Kind {
    const found = document.getElementById(id);
    if (!(found instanceof kind)) throw new Error(`the page has no ${id}`);
    return found;
}

function textOf(id: string): string {
    return document.getElementById(id)?.textContent.trim() ?? '';
}

function fail(message: string): void {
    const words = part('failure', HTMLElement);
    words.textContent = message;
    words.hidden = false;
}

async function start(): Promise<void> {
    const graphics = probeGraphics();
    if (graphics === null) return fail(noWebGl2);
    const file = readAnimation(textOf('description'), textOf('frames'));
    // All of it is in typed arrays now.
    document.getElementById('frames')?.remove();
    const module = await createDecoderModule({ wasmBinary: bytesOf(wasm.slice(wasm.indexOf(',') + 1)).buffer });
    const scene = new FlowScene({ canvas: part('picture', HTMLCanvasElement), labels: part('labels', HTMLElement), graphics });
    const points = new DracoPoints(module);
    show(file, new AnimationSteps(file, points), scene);
    const body = textOf('body');
    const shape = body === '' ? null : decodeObstacle(bytesOf(body), points, file.description.lattice);
    if (shape !== null) scene.body.set(shape);
}

function show({ description }: AnimationFile, steps: AnimationSteps, scene: FlowScene): void {
    const { times, timeUnit } = description;
    describe(description);
    const dark = matchMedia('(prefers-color-scheme: dark)');
    const followTheme = (): void => scene.setTheme(dark.matches ? 'dark' : 'light');
    dark.addEventListener('change', followTheme);
    followTheme();
    scene.setUnit(description.lengthUnit);
    scene.setDomain([...description.bounds]);

    const slider = part('step', HTMLInputElement);
    const time = part('time', HTMLElement);
    const away = part('away', HTMLElement);
    const play = part('play', HTMLButtonElement);
    const [first, last] = [times[0]!, times.at(-1)!];
    const resolution = resolutionOf(Math.min(first, last), Math.max(first, last), Math.abs(last - first) / times.length);
    const timeOf = (step: number): string =>
        `t = ${placeNumber(times[step]!, resolution)}${timeUnit === '' ? '' : ` ${timeUnit}`}`;
    slider.max = String(steps.count - 1);

    const choices = colourChoices(description);
    let wish = wishOf((choices[0] ?? plain).style);
    let isDrawn = true;
    const player = new Player({
        steps,
        now: () => performance.now(),
        onStep: (step) => {
            isDrawn = false;
            scene.setSurface(surface, steps.take(wish));
            scene.whenDrawn(() => (isDrawn = true));
            slider.value = String(step);
            slider.setAttribute('aria-valuetext', timeOf(step));
            time.textContent = timeOf(step);
        },
        onAway: (count) => (away.textContent = count > 0 ? `${count} steps to read` : ''),
        onPlaying: (playing) => {
            play.textContent = playing ? 'Pause' : 'Play';
            play.dataset['playing'] = String(playing);
        },
    });

    const legend = new Legend(part('legend', HTMLElement), choices);
    const colour = (choice: ColourChoice): void => {
        wish = wishOf(choice.style);
        scene.surfaces.setStyle(surface, choice.style);
        legend.show(choice);
        // The values of the state that is shown.
        if (steps.current >= 0) scene.setSurface(surface, steps.take(wish));
        scene.loop.request();
    };
    legend.onChoice(colour);
    colour(choices[0] ?? plain);

    const toggle = (): void => (player.playing ? player.pause() : player.play());
    play.addEventListener('click', toggle);
    slider.addEventListener('input', () => player.goTo(Number(slider.value)));
    const speed = part('speed', HTMLSelectElement);
    speed.addEventListener('change', () => (player.speed = Number(speed.value)));
    addEventListener('keydown', (event) => {
        if (event.target !== document.body && event.target !== scene.renderer.domElement) return;
        const jump: Record<string, number> = {
            ArrowLeft: player.step - 1,
            ArrowRight: player.step + 1,
            Home: 0,
            End: steps.count - 1,
        };
        const to = jump[event.key];
        if (event.key === ' ') toggle();
        else if (to !== undefined) player.goTo(to);
        else return;
        event.preventDefault();
    });

    const frame = (): void => {
        try {
            if (isDrawn || document.hidden) player.frame();
        } catch (error) {
            fail(`This file is damaged: ${error instanceof Error ? error.message : String(error)}`);
            return;
        }
        requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) player.goTo(steps.count - 1);
    else player.play();
    const shown = (): number => Number(slider.value);
    const goTo = (step: number): void => player.goTo(step);
    const bodyVertices = (): number => scene.body.geometry?.getAttribute('position').count ?? 0;
    Object.assign(window, { wakesurfAnimation: { count: steps.count, step: shown, goTo, bodyVertices } });
}

function describe({ title, facts }: AnimationDescription): void {
    document.title = title;
    part('title', HTMLElement).textContent = title;
    const list = part('facts', HTMLElement);
    for (const fact of facts) {
        const item = document.createElement('li');
        item.textContent = fact;
        list.append(item);
    }
}

start().catch((error: unknown) => fail(error instanceof Error ? error.message : String(error)));
