// What the colours mean: a choice of values, a bar, numbers.
import { placeNumbers, resolutionOf } from '../scene/base/numbers.ts';
import { colourTable, tableSize } from '../scene/surface/colourMap.ts';
import type { AnimatedValue } from './animationFile.ts';

export class Legend {
    private readonly choice = document.createElement('select');
    private readonly bar = document.createElement('canvas');
    private readonly low = document.createElement('span');
    private readonly high = document.createElement('span');

    constructor(element: HTMLElement, values: readonly AnimatedValue[]) {
        values.forEach(({ title }, i) => this.choice.append(new Option(title, String(i))));
        this.choice.setAttribute('aria-label', 'Colours show');
        [this.bar.width, this.bar.height] = [tableSize, 1];
        const numbers = document.createElement('div');
        numbers.append(this.low, this.high);
        element.append(this.choice, this.bar, numbers);
        element.hidden = values.length === 0;
        this.values = values;
    }

    private readonly values: readonly AnimatedValue[];

    onChoice(chosen: (value: AnimatedValue | null) => void): void {
        this.choice.addEventListener('change', () => chosen(this.values[Number(this.choice.value)] ?? null));
    }

    show(value: AnimatedValue | null): void {
        if (value === null) return;
        const [least, greatest] = value.range;
        const most = Math.max(Math.abs(least), Math.abs(greatest));
        const range = value.signed ? [-most, most] : [least, greatest];
        const [low, high] = placeNumbers(range, resolutionOf(range[0]!, range[1]!));
        this.low.textContent = low ?? '';
        this.high.textContent = high ?? '';
        const pixels = new Uint8ClampedArray(colourTable(value.signed ? 'coolToWarm' : 'viridis').buffer);
        this.bar.getContext('2d')?.putImageData(new ImageData(pixels, tableSize, 1), 0, 0);
    }
}
