// The session's clock, which all participants share: play, pause, and the newest place of the slider.
import { EditWindow } from '../../connection/editWindow.ts';
import type { ClockRecord, ParamsOf } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { isDisconnected, announceUnlessDisconnected } from '../base/calls.ts';

export interface ClockControlOptions {
    state: AppState;
    worker: Pick<WorkerClient, 'call'>;
    requestFrame: () => void;
}

export class ClockControl {
    private readonly options: ClockControlOptions;
    private readonly window: EditWindow<number | null>;
    /** What this page has set, ahead of the server, and what the server had told before. */
    private ahead: ClockRecord | null = null;
    private announced: ClockRecord | null = null;

    constructor(options: ClockControlOptions) {
        this.options = options;
        this.window = new EditWindow({
            send: async (time) => {
                if (!(await this.send(() => options.worker.call('time.set', { time })))) this.goBack();
            },
            requestFlush: options.requestFrame,
            onChange: () => undefined,
        });
    }

    /** Called at the start of every frame. */
    flush(): void {
        this.window.flush();
    }

    /** Sets the time: of the times of one frame only the newest is sent. The control follows at once. */
    set(time: number | null): void {
        const { clock } = this.options.state;
        if (clock.value !== null) {
            if (clock.value !== this.ahead) this.announced = clock.value;
            this.ahead = { ...clock.value, time };
            clock.value = this.ahead;
        }
        this.window.submit(time);
    }

    async play(how: ParamsOf<'time.play'>): Promise<void> {
        await this.send(() => this.options.worker.call('time.play', how));
    }

    async pause(): Promise<void> {
        await this.send(() => this.options.worker.call('time.pause', {}));
    }

    /** Takes back what is refused: other users do not see it. */
    private goBack(): void {
        const { clock } = this.options.state;
        if (clock.value === this.ahead && this.announced !== null) clock.value = this.announced;
    }

    /** False where it was not taken. */
    private async send(call: () => Promise<unknown>): Promise<boolean> {
        const { problems } = this.options.state;
        try {
            await call();
            problems.solved('clock');
            return true;
        } catch (error) {
            announceUnlessDisconnected(problems, 'clock', error);
            return isDisconnected(error);
        }
    }
}
