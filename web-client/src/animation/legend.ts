// What the colours mean: a choice of values, a bar, numbers.
import { placeNumbers, resolutionOf } from '../scene/base/numbers.ts';
import { colourTable, drawnRange, scaleOf, tableSize } from '../scene/surface/colourMap.ts';
import type { ColourChoice } from './animationLook.ts';

export class Legend {
    private readonly choice = document.createElement('select');
    private readonly bar = document.createElement('canvas');
    private readonly numbers = document.createElement('div');
    private readonly low = document.createElement('span');
    private readonly high = document.createElement('span');
    private readonly choices: readonly ColourChoice[];

    constructor(element: HTMLElement, choices: readonly ColourChoice[]) {
        choices.forEach(({ title }, i) => this.choice.append(new Option(title, String(i))));
        this.choice.setAttribute('aria-label', 'Colours show');
        [this.bar.width, this.bar.height] = [tableSize, 1];
        this.numbers.append(this.low, this.high);
        element.append(this.choice, this.bar, this.numbers);
        element.hidden = choices.length === 0;
        this.choices = choices;
    }

    onChoice(chosen: (choice: ColourChoice) => void): void {
        this.choice.addEventListener('change', () => {
            const choice = this.choices[Number(this.choice.value)];
            if (choice !== undefined) chosen(choice);
        });
    }

    show({ style: { source, range: wanted, map, inverted, centre, ...style } }: ColourChoice): void {
        this.bar.hidden = this.numbers.hidden = source === 'constant';
        const range = drawnRange(wanted ?? [0, 1], scaleOf(style), centre);
        const [low, high] = placeNumbers(range, resolutionOf(range[0], range[1]));
        this.low.textContent = low ?? '';
        this.high.textContent = high ?? '';
        const pixels = new Uint8ClampedArray(colourTable(map, inverted, style.bands).buffer);
        this.bar.getContext('2d')?.putImageData(new ImageData(pixels, tableSize, 1), 0, 0);
    }
}
