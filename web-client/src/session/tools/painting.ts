// The brush of the painter: what it touches is revealed or hidden in the picture, or names a part to hide.
import { PaintTool } from '../../scene/surface/paintTool.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { ScreenPoint } from '../../scene/base/view.ts';
import type { ViewState } from '../../state/viewState.ts';

const clickRadiusPx = 6;

export function connectPainting(view: ViewState, scene: FlowScene): void {
    const isPart = (): boolean => view.brush.value.does === 'hidePart';
    const radius = (): number => (isPart() ? clickRadiusPx : view.brush.value.radiusPx);
    const paint = (at: ScreenPoint): void => {
        if (isPart()) {
            hidePart(view, scene, at);
            return;
        }
        const radiusPx = radius();
        const { size, hits } = scene.pickGrid(at, radiusPx, { throughPaint: true });
        scene.surfaces.paint({ size, hits, radiusPx }, view.brush.value.does === 'reveal');
        scene.loop.request();
    };
    scene.pointerTools.add(
        new PaintTool({
            radiusPx: () => (view.tool.value === 'paint' ? radius() : null),
            paint,
            overlay: scene.labels,
        }),
    );
}

function hidePart(view: ViewState, scene: FlowScene, at: ScreenPoint): void {
    const hit = scene.pick(at);
    if (hit === null || hit.surface === null) return;
    const { hiddenParts } = view.lookOf(hit.surface);
    view.changeLook(hit.surface, { hiddenParts: [...hiddenParts, [hit.s, hit.t]] });
}
