// How this browser draws: dark or light, as the user has chosen or as the system is; how pictures that stand still are drawn; and a word
// when the system takes the graphics away.
import { effect, signal, type Signal } from '@preact/signals-core';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import { keep, recall } from '../../state/browserMemory.ts';
import type { ViewState } from '../../state/viewState.ts';

const themeKey = 'theme';

export function showTheme(view: ViewState, scene: Pick<FlowScene, 'setTheme'>): void {
    const preference = matchMedia('(prefers-color-scheme: light)');
    const systemIsLight = signal(preference.matches);
    preference.addEventListener('change', () => (systemIsLight.value = preference.matches));
    const before = recall(themeKey);
    if (before === 'dark' || before === 'light') view.theme.value = before;
    effect(() => {
        const chosen = view.theme.value;
        const shown = chosen === 'system' ? (systemIsLight.value ? 'light' : 'dark') : chosen;
        document.documentElement.style.colorScheme = shown;
        scene.setTheme(shown);
        keep(themeKey, chosen);
    });
}

/**
 * Shaded where things are near each other, and in exact order, at first where that costs nothing to speak of: software
 * rendering takes up to a second for one.
 */
export function showStillPictures(
    view: Pick<ViewState, 'contactShade' | 'exactWhenStill'>,
    scene: Pick<FlowScene, 'setContactShade' | 'setExactWhenStill'>,
    { software }: { software: boolean },
): void {
    keepChoice('exactOrder', view.exactWhenStill, !software, (on) => scene.setExactWhenStill(on));
    keepChoice('contactShade', view.contactShade, true, (on) => scene.setContactShade(on));
}

function keepChoice(name: string, choice: Signal<boolean>, usual: boolean, show: (on: boolean) => void): void {
    const before = recall(name);
    const first = before === null ? usual : before === 'on';
    choice.value = first;
    effect(() => {
        const on = choice.value;
        show(on);
        // What no user has chosen may be otherwise with other graphics.
        if (on !== first || before !== null) keep(name, on ? 'on' : 'off');
    });
}

const graphicsNotice = 'graphics';

/** As after a standby or a fault of a driver: the picture is black until the graphics come back. */
export function announceLostGraphics(
    { notices }: Pick<AppState, 'notices'>,
    canvas: EventTarget,
    reload = () => location.reload(),
): void {
    canvas.addEventListener('webglcontextlost', () => {
        notices.say(
            graphicsNotice,
            'The system has reset the graphics. The picture comes back by itself; if it does not, reload the page.',
            {
                label: 'Reload',
                act: reload,
            },
        );
    });
    canvas.addEventListener('webglcontextrestored', () => notices.solved(graphicsNotice));
}
