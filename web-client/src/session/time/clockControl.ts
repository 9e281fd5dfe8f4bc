// The session's clock, which all participants share: play, pause, and the newest place of the slider.
import { EditWindow } from '../../connection/editWindow.ts';
import type { ParamsOf } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { tellUnlessCut } from '../base/lostConnection.ts';

export interface ClockControlOptions {
    state: AppState;
    worker: Pick<WorkerClient, 'call'>;
    requestFrame: () => void;
}

export class ClockControl {
    private readonly options: ClockControlOptions;
    private readonly window: EditWindow<number | null>;

    constructor(options: ClockControlOptions) {
        this.options = options;
        this.window = new EditWindow({
            send: (time) => this.send(() => options.worker.call('time.set', { time })),
            requestFlush: options.requestFrame,
            onChange: () => undefined,
        });
    }

    /** Called at the start of every frame. */
    flush(): void {
        this.window.flush();
    }

    /** Of the times of one frame only the newest is sent. The control follows at once. */
    set(time: number | null): void {
        const { clock } = this.options.state;
        if (clock.value !== null) clock.value = { ...clock.value, time };
        this.window.submit(time);
    }

    async play(how: ParamsOf<'time.play'>): Promise<void> {
        await this.send(() => this.options.worker.call('time.play', how));
    }

    async pause(): Promise<void> {
        await this.send(() => this.options.worker.call('time.pause', {}));
    }

    private async send(call: () => Promise<unknown>): Promise<void> {
        const { problems } = this.options.state;
        try {
            await call();
            problems.solved('clock');
        } catch (error) {
            tellUnlessCut(problems, 'clock', error);
        }
    }
}
