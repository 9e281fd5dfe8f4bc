// Dark or light, as the user has chosen or as the system is: for the page and for the picture.
import { effect, signal } from '@preact/signals-core';
import type { FlowScene } from '../../scene/scene.ts';
import { keep, recall } from '../../state/browserMemory.ts';
import type { ViewState } from '../../state/viewState.ts';

const kept = 'theme';

export function showTheme(view: ViewState, scene: Pick<FlowScene, 'setTheme'>): void {
    const preference = matchMedia('(prefers-color-scheme: light)');
    const systemIsLight = signal(preference.matches);
    preference.addEventListener('change', () => (systemIsLight.value = preference.matches));
    const before = recall(kept);
    if (before === 'dark' || before === 'light') view.theme.value = before;
    effect(() => {
        const chosen = view.theme.value;
        const shown = chosen === 'system' ? (systemIsLight.value ? 'light' : 'dark') : chosen;
        document.documentElement.style.colorScheme = shown;
        scene.setTheme(shown);
        keep(kept, chosen);
    });
}
