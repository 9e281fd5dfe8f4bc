// Says so when the system takes the graphics away from the page, as after a standby or a fault of a driver:
// the picture is black until they come back.
import type { AppState } from '../../state/appState.ts';

const about = 'graphics';

export function tellLostGraphics(
    { notices }: Pick<AppState, 'notices'>,
    canvas: EventTarget,
    reload = () => location.reload(),
): void {
    canvas.addEventListener('webglcontextlost', () => {
        notices.say(
            about,
            'The system has reset the graphics. The picture comes back by itself; if it does not, reload the page.',
            {
                label: 'Reload',
                act: reload,
            },
        );
    });
    canvas.addEventListener('webglcontextrestored', () => notices.solved(about));
}
