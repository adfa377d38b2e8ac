import {
  BufferAttribute, BufferGeometry, DoubleSide, EdgesGeometry, Group, LineBasicMaterial,
  LineSegments, Mesh, ShaderMaterial,
} from 'three';

import { bytesOf } from './load_script.js';
import { toLight } from './terrain.js';

const vertexShader = `
varying vec3 facing;
void main() {
  facing = normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const fragmentShader = `
uniform vec3 light;
varying vec3 facing;
void main() {
  float towards = dot(normalize(facing), light) * (gl_FrontFacing ? 1.0 : -1.0);
  vec3 colour = vec3(0.80, 0.33, 0.25) * (0.72 + 0.34 * towards);
  gl_FragColor = vec4(colour, 1.0);
}`;

/** Where the name of a solid stands, over its middle at its top, and half its size in plan, m. */
function anchorOf(corners) {
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  let top = -Infinity;
  for (let i = 0; i < corners.length; i += 3) {
    for (const k of [0, 1]) {
      low[k] = Math.min(low[k], corners[i + k]);
      high[k] = Math.max(high[k], corners[i + k]);
    }
    top = Math.max(top, corners[i + 2]);
  }
  return {
    at: [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, top],
    size: Math.hypot(high[0] - low[0], high[1] - low[1]) / 2,
  };
}

/** Dams and buildings of a scene, lit, with their edges; and where their names stand. */
export function makeSolids(solids) {
  const group = new Group();
  const anchors = [];
  const material = new ShaderMaterial({
    vertexShader, fragmentShader, side: DoubleSide, uniforms: { light: { value: toLight } },
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  });
  const edge = new LineBasicMaterial({ color: 0x4a120b });
  for (const solid of solids) {
    const corners = new Float32Array(bytesOf(solid.corners).buffer);
    if (corners.length === 0) continue;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(corners, 3));
    geometry.computeVertexNormals();
    group.add(new Mesh(geometry, material));
    group.add(new LineSegments(new EdgesGeometry(geometry, 25), edge));
    if (solid.name) anchors.push({ name: solid.name, kind: 'solid', ...anchorOf(corners) });
  }
  return { group, anchors };
}
