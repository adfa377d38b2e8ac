import {
  BufferAttribute, BufferGeometry, DataTexture, DynamicDrawUsage, FloatType, GLSL3, InterleavedBuffer,
  InterleavedBufferAttribute, NearestFilter, Points, RedFormat, ShaderMaterial, Vector2, Vector3,
  Vector4,
} from 'three';

import { viridis } from './colours.js';
import { Foremost } from './foremost.js';

const fields = 6; // x, y, height over the ground, depth, speed, pressure

const vertexShader = `
in vec3 placeA; in vec3 valueA;
in vec3 placeB; in vec3 valueB;
uniform vec3 placeLow[2]; uniform vec3 placeSpan[2];
uniform vec3 valueLow[2]; uniform vec3 valueSpan[2];
uniform float share;
uniform highp sampler2D ground;
uniform vec4 grid;
uniform ivec2 lastCell;
uniform vec3 quantity;
uniform float top;
uniform vec3 colours[9];
uniform float size;
uniform vec2 pixels;
out vec3 colour;
out float radius;

float groundAt(vec2 p) {
  vec2 at = clamp(vec2(p.x - grid.x, grid.y - p.y) * grid.zw, vec2(0.0), vec2(lastCell));
  ivec2 cell = min(ivec2(at), lastCell - 1);
  vec2 f = at - vec2(cell);
  float nw = texelFetch(ground, cell, 0).r;
  float ne = texelFetch(ground, cell + ivec2(1, 0), 0).r;
  float sw = texelFetch(ground, cell + ivec2(0, 1), 0).r;
  float se = texelFetch(ground, cell + ivec2(1, 1), 0).r;
  return mix(mix(nw, ne, f.x), mix(sw, se, f.x), f.y);
}

void main() {
  vec3 place = mix(placeLow[0] + placeSpan[0] * placeA, placeLow[1] + placeSpan[1] * placeB, share);
  vec3 values = mix(valueLow[0] + valueSpan[0] * valueA, valueLow[1] + valueSpan[1] * valueB, share);
  float fraction = clamp(dot(values, quantity) / top, 0.0, 1.0) * 8.0;
  int step = min(int(fraction), 7);
  colour = mix(colours[step], colours[step + 1], fraction - float(step));
  vec4 seen = modelViewMatrix * vec4(place.xy, groundAt(place.xy) + place.z, 1.0);
  float distance = length(seen.xyz);
  radius = clamp(size * pixels.x / -seen.z, pixels.y, 60.0);
  gl_PointSize = radius;
  // Nearer by most of a radius, so that the ground cuts no disc in half.
  gl_Position = projectionMatrix * vec4(seen.xyz * (1.0 - min(0.4 * size / distance, 0.5)), 1.0);
}`;

// A ball where there is room for one, else a dot.
const fragmentShader = `
precision mediump float;
in vec3 colour;
in float radius;
out vec4 pixel;
void main() {
  if (radius < 3.5) { pixel = vec4(colour, 1.0); return; }
  vec2 d = gl_PointCoord * 2.0 - 1.0;
  float r = dot(d, d);
  if (r > 1.0) discard;
  float light = 0.80 + 0.26 * dot(vec3(d, sqrt(1.0 - r)), vec3(-0.45, -0.55, 0.70));
  pixel = vec4(colour * light, 1.0);
}`;

function groundTexture(ground) {
  const texture = new DataTexture(ground.filled, ground.columns, ground.rows, RedFormat, FloatType);
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}

/** The flow at one time, between two frames of a run. */
export class Particles {
  constructor(run) {
    this.run = run;
    const { ground, scene } = run;
    this.shown = { first: null, second: null, share: 0 };
    this.pair = { first: null, second: null, places: [null, null] };
    this.material = new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader,
      uniforms: {
        placeLow: { value: [new Vector3(), new Vector3()] },
        placeSpan: { value: [new Vector3(), new Vector3()] },
        valueLow: { value: [new Vector3(), new Vector3()] },
        valueSpan: { value: [new Vector3(), new Vector3()] },
        share: { value: 0 },
        ground: { value: groundTexture(ground) },
        grid: { value: new Vector4(ground.x(0), ground.y(0), 1 / ground.dx, 1 / ground.dy) },
        lastCell: { value: [ground.columns - 1, ground.rows - 1] },
        quantity: { value: new Vector3(1, 0, 0) },
        top: { value: 1 },
        colours: { value: viridis.map((c) => new Vector3(...c.map((v) => v / 255))) },
        size: { value: scene.spacing },
        pixels: { value: new Vector2(1, 2) },
      },
    });
    this.points = new Points(new BufferGeometry(), this.material);
    this.points.frustumCulled = false;
  }

  /** Shows the flow between two frames of Run.around(); false while one of them is loaded. */
  show({ first, second, share }) {
    if (!first || !second) return false;
    if (this.pair.first !== first || this.pair.second !== second) this.#take(first, second);
    this.shown = { first, second, share };
    this.material.uniforms.share.value = share;
    return true;
  }

  /** Leaves out the particles behind others; see Foremost. */
  leaveOutHidden(matrix, picture) {
    if (this.count === 0) return;
    this.foremost ??= new Foremost();
    const numbers = this.foremost.of(this, matrix, picture);
    const { geometry } = this.points;
    if (!geometry.index || geometry.index.count < this.count) {
      geometry.setIndex(new BufferAttribute(new Uint32Array(this.count), 1));
      geometry.index.setUsage(DynamicDrawUsage);
    }
    geometry.index.array.set(numbers);
    geometry.index.clearUpdateRanges();
    geometry.index.addUpdateRange(0, numbers.length);
    geometry.index.needsUpdate = true;
    geometry.setDrawRange(0, numbers.length);
  }

  get count() {
    return this.pair.places[0] ? this.pair.places[0].length / fields : 0;
  }

  /** Place, height over the ground and values of particle i: x, y, height, depth, speed, pressure. */
  read(i, out) {
    const { first, second, share } = this.shown;
    const [a, b] = this.pair.places;
    for (let k = 0; k < fields; ++k) {
      const from = first.low[k] + ((first.high[k] - first.low[k]) * a[fields * i + k]) / 65535;
      const to = second.low[k] + ((second.high[k] - second.low[k]) * b[fields * i + k]) / 65535;
      out[k] = from + share * (to - from);
    }
    return out;
  }

  #take(first, second) {
    this.pair = { first, second, places: commonParticles(first, second) };
    const { uniforms } = this.material;
    [first, second].forEach((frame, k) => {
      const span = frame.low.map((low, f) => frame.high[f] - low);
      uniforms.placeLow.value[k].set(...frame.low.slice(0, 3));
      uniforms.placeSpan.value[k].set(...span.slice(0, 3));
      uniforms.valueLow.value[k].set(...frame.low.slice(3));
      uniforms.valueSpan.value[k].set(...span.slice(3));
    });
    const { points } = this;
    points.geometry.dispose();
    points.geometry = new BufferGeometry();
    ['A', 'B'].forEach((end, k) => {
      const buffer = new InterleavedBuffer(this.pair.places[k], fields);
      buffer.setUsage(DynamicDrawUsage);
      const part = (offset) => new InterleavedBufferAttribute(buffer, 3, offset, true);
      points.geometry.setAttribute(`place${end}`, part(0));
      points.geometry.setAttribute(`value${end}`, part(3));
    });
    points.geometry.setDrawRange(0, this.count);
  }
}

/** Values of the particles that both frames have, in one order. */
function commonParticles(first, second) {
  if (first === second) return [first.values, second.values];
  if (!first.ids && !second.ids) {
    const size = fields * Math.min(first.count, second.count);
    return [first.values.subarray(0, size), second.values.subarray(0, size)];
  }
  const id = (frame, i) => (frame.ids ? frame.ids[i] : i);
  const a = new Uint16Array(fields * Math.min(first.count, second.count)), b = a.slice();
  let count = 0;
  for (let i = 0, j = 0; i < first.count && j < second.count;) {
    const difference = id(first, i) - id(second, j);
    if (difference === 0) {
      a.set(first.values.subarray(fields * i, fields * (i + 1)), fields * count);
      b.set(second.values.subarray(fields * j, fields * (j + 1)), fields * count);
      ++count;
    }
    if (difference <= 0) ++i;
    if (difference >= 0) ++j;
  }
  return [a.subarray(0, fields * count), b.subarray(0, fields * count)];
}
