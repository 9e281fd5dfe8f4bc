// Keeps what lies on a body in sight before the body: in depth alone, the body is drawn a little further from
// the eye than it is. Its outline stays where it is.
import type { MeshLambertMaterial } from 'three';

/** Is a part of the domain's diagonal: as deep as the flat quads of a surface reach into what is round. */
export const bodyPush = 1 / 500;

/** Belongs to a vertex shader, to be called when gl_Position is set. */
export const pushBackGlsl = `
uniform float push;

void pushBack(vec4 inView) {
    vec3 away = isOrthographic ? vec3(0.0, 0.0, -1.0) : normalize(inView.xyz);
    vec4 further = projectionMatrix * vec4(inView.xyz + away * push, 1.0);
    gl_Position.z = further.z / further.w * gl_Position.w;
}`;

/** @param push in units of length */
export function pushBack(material: MeshLambertMaterial, push: { value: number }): void {
    material.onBeforeCompile = (shader) => {
        shader.uniforms['push'] = push;
        shader.vertexShader = shader.vertexShader
            .replace('void main() {', `${pushBackGlsl}\nvoid main() {`)
            .replace('#include <project_vertex>', '#include <project_vertex>\n\tpushBack(mvPosition);');
    };
}
