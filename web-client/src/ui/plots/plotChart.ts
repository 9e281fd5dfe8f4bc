// The lines of a plot, drawn by uPlot. Dragging across enlarges that part, a double click shows all again.
import { css, html, type PropertyDeclarations, type TemplateResult, unsafeCSS } from 'lit';
import UPlot from 'uplot';
import uplotStyles from 'uplot/dist/uPlot.min.css?inline';
import type { Ticks } from '../../scene/base/numbers.ts';
import { titleOf, type Plot } from '../../session/plots/plot.ts';
import { axesOf, lineColours, type PlotAxis, rangeOf, ticksAcross, ticksUp, withShared } from '../../session/plots/plotAxes.ts';
import { SignalElement } from '../base/signalElement.ts';

/** A shorter one is a click. */
const dragPx = 4;
const font = '12px system-ui, sans-serif';

/** Where the pointer is along the lower axis: the number of a value; null: beside the lines. */
export class PlotPointed extends CustomEvent<number | null> {
    static readonly type = 'plot-pointed';

    constructor(index: number | null) {
        super(PlotPointed.type, { detail: index });
    }
}

/** A place along the lower axis is chosen. */
export class PlotChosen extends CustomEvent<number> {
    static readonly type = 'plot-chosen';

    constructor(value: number) {
        super(PlotChosen.type, { detail: value });
    }
}

export class PlotChart extends SignalElement {
    static override properties: PropertyDeclarations = {
        plot: { attribute: false },
        now: { attribute: false },
        choosable: { attribute: false },
    };
    declare plot: Plot;
    /** A line is drawn there; null: none. */
    declare now: number | null;
    /** A click chooses a place. */
    declare choosable: boolean;
    private chart: UPlot | null = null;
    /** What a chart cannot change afterwards. */
    private made = '';
    private drawn: Plot | null = null;
    private axes: PlotAxis[] = [];
    private readonly resized = new ResizeObserver(() => this.fit());

    static override styles = [
        unsafeCSS(uplotStyles),
        css`
            :host {
                display: block;
                position: relative;
                overflow: hidden;
            }
            #chart {
                position: absolute;
                inset: 0;
            }
            :host([choosable]) .u-over {
                cursor: ew-resize;
            }
            .u-select {
                background: color-mix(in srgb, var(--accent) 18%, transparent);
            }
            .u-cursor-x {
                border-color: var(--quiet);
            }
        `,
    ];

    override render(): TemplateResult {
        return html`<div id="chart"></div>`;
    }

    override connectedCallback(): void {
        super.connectedCallback();
        this.resized.observe(this);
    }

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        this.resized.disconnect();
        this.chart?.destroy();
        this.chart = null;
    }

    protected override updated(): void {
        this.axes = axesOf(this.plot);
        this.toggleAttribute('choosable', this.choosable);
        const { x, series } = this.plot;
        const form = JSON.stringify([titleOf(x), this.axes.map(({ group, title, series: of }) => [group, title, of])]);
        const data = [x, ...series].map(({ values }) => values.map((value) => (Number.isNaN(value) ? null : value)));
        if (this.chart === null || form !== this.made) {
            this.chart?.destroy();
            this.made = form;
            this.chart = new UPlot(
                this.options(),
                data as UPlot.AlignedData,
                this.renderRoot.querySelector<HTMLElement>('#chart')!,
            );
        } else if (this.plot === this.drawn) {
            // The clock has moved, no more.
            this.chart.redraw(false);
        } else {
            const whole = !this.isEnlarged(this.chart);
            this.chart.setData(data as UPlot.AlignedData, whole);
            if (!whole) this.chart.redraw();
        }
        this.drawn = this.plot;
    }

    /** What a person has enlarged stays so while values come. */
    private isEnlarged({ scales, data }: UPlot): boolean {
        const { min, max } = scales['x'] ?? {};
        return (min ?? -Infinity) > (data[0][0] ?? -Infinity) || (max ?? Infinity) < (data[0].at(-1) ?? Infinity);
    }

    private fit(): void {
        if (this.clientWidth > 0) this.chart?.setSize({ width: this.clientWidth, height: this.clientHeight });
    }

    private options(): UPlot.Options {
        const { color } = getComputedStyle(this);
        const lower = this.axis({ scale: 'x', title: titleOf(this.plot.x), side: 2, ticks: ticksAcross, colour: color });
        const upright = this.axes.map((axis, i) =>
            this.axis({
                scale: axis.group,
                title: axis.title,
                side: i === 0 ? 3 : 1,
                ticks: ticksUp,
                colour: color,
                grid: i === 0,
            }),
        );
        return {
            ...{ width: Math.max(this.clientWidth, 100), height: Math.max(this.clientHeight, 60), legend: { show: false } },
            padding: [10, this.axes.length > 1 ? 4 : 16, 0, 0],
            cursor: { y: false, drag: { x: true, y: false, dist: dragPx }, points: { size: 7 } },
            scales: {
                x: { time: false, range: (_, low, high) => (low === high ? [low - 1, high + 1] : [low, high]) },
                ...Object.fromEntries(
                    this.axes.map(({ group }, i) => [
                        group,
                        { range: () => [...(this.axes[i]?.range ?? [0, 1])] as [number, number] },
                    ]),
                ),
            },
            axes: [lower, ...upright],
            series: [{}, ...this.plot.series.map(({ name, group }, i) => this.line(name, group, i))],
            hooks: {
                setCursor: [
                    ({ cursor: { idx, left = -1 } }) => this.dispatchEvent(new PlotPointed(left < 0 ? null : (idx ?? null))),
                ],
                draw: [(chart) => this.drawNow(chart, color)],
                ready: [(chart) => this.listen(chart)],
            },
        };
    }

    private line(name: string, group: string, index: number): UPlot.Series {
        // A value alone has no line: uPlot draws it as a point where there is room.
        return { label: name, scale: group, stroke: lineColours[index % lineColours.length]!, width: 2, spanGaps: false };
    }

    private axis(of: {
        scale: string;
        title: string;
        side: 1 | 2 | 3;
        ticks: (low: number, high: number, pixels: number) => Ticks;
        colour: string;
        grid?: boolean;
    }): UPlot.Axis {
        const lower = of.side === 2;
        const faint = of.colour.replace(/^rgb\((.*)\)$/, 'rgba($1, 0.14)');
        // Numbers and title are from one and the same list, as the part that is seen asks for.
        const ticksOf = (chart: UPlot, low: number, high: number): Ticks => {
            const { width, height } = chart.over.getBoundingClientRect();
            return of.ticks(low, high, lower ? width || this.clientWidth : height || this.clientHeight);
        };
        const seen = (chart: UPlot): [number, number] => {
            const { min, max } = chart.scales[of.scale] ?? {};
            return [min ?? 0, max ?? 1];
        };
        return {
            ...{ scale: of.scale, side: of.side, stroke: of.colour, font, labelFont: font, labelGap: 0 },
            ...{ label: of.title, labelSize: 18, size: lower ? 26 : 52, gap: 4 },
            grid: { show: of.grid ?? true, stroke: faint, width: 1 },
            ticks: { stroke: faint, size: 5 },
            splits: (chart, index, low, high) => {
                const ticks = ticksOf(chart, low, high);
                const axis = chart.axes[index];
                if (axis !== undefined) axis.label = withShared(of.title, ticks);
                return ticks.ticks.map(({ value }) => value);
            },
            values: (chart, splits) => {
                const { ticks } = ticksOf(chart, ...seen(chart));
                return splits.map((_, i) => ticks[i]?.label ?? '');
            },
        };
    }

    private drawNow(chart: UPlot, colour: string): void {
        if (this.now === null) return;
        const [low, high] = rangeOf(this.plot.x.values) ?? [0, 0];
        if (this.now < low || this.now > high) return;
        const { ctx, bbox } = chart;
        const x = Math.round(chart.valToPos(this.now, 'x', true)) + 0.5;
        if (x < bbox.left || x > bbox.left + bbox.width) return;
        ctx.save();
        ctx.strokeStyle = colour;
        ctx.lineWidth = 1.5 * UPlot.pxRatio;
        ctx.beginPath();
        ctx.moveTo(x, bbox.top);
        ctx.lineTo(x, bbox.top + bbox.height);
        ctx.stroke();
        ctx.restore();
    }

    private listen(chart: UPlot): void {
        let pressedAt = 0;
        chart.over.addEventListener('mousedown', ({ clientX }) => (pressedAt = clientX));
        chart.over.addEventListener('click', ({ clientX, offsetX }) => {
            // A drag enlarges.
            if (!this.choosable || Math.abs(clientX - pressedAt) >= dragPx) return;
            this.dispatchEvent(new PlotChosen(chart.posToVal(offsetX, 'x')));
        });
    }
}

customElements.define('wakesurf-plot-chart', PlotChart);
