import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, ShaderMaterial } from 'three';

// Light from the north-west, 45 degrees up, as on printed maps and in src/io/output/relief.cpp.
export const toLight = [-0.5, 0.5, Math.SQRT1_2];

/** Brightness of the ground at a cell: 0 turned away from the light, 1 towards it. */
function shadeAt(ground, column, row) {
  const z = (c, r) => {
    const k = Math.min(Math.max(r, 0), ground.rows - 1) * ground.columns +
      Math.min(Math.max(c, 0), ground.columns - 1);
    return ground.filled[k];
  };
  const east = (z(column + 1, row) - z(column - 1, row)) / (2 * ground.dx);
  const north = (z(column, row - 1) - z(column, row + 1)) / (2 * ground.dy);
  const size = Math.hypot(east, north, 1);
  return 0.5 + (0.5 * (-east * toLight[0] - north * toLight[1] + toLight[2])) / size;
}

/** Triangles cut from north-west to south-east, as the program cuts the ground. */
function surfaceGeometry(ground) {
  const { columns, rows, heights } = ground;
  const position = new Float32Array(3 * columns * rows);
  const shade = new Float32Array(columns * rows);
  const index = [];
  for (let row = 0, k = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column, ++k) {
      position.set([ground.x(column), ground.y(row), ground.filled[k]], 3 * k);
      shade[k] = shadeAt(ground, column, row);
      if (row + 1 === rows || column + 1 === columns) continue;
      const nw = k, ne = k + 1, sw = k + columns, se = sw + 1;
      const has = (cell) => !Number.isNaN(heights[cell]);
      if (!has(nw) || !has(se)) continue;
      if (has(sw)) index.push(nw, sw, se);
      if (has(ne)) index.push(nw, se, ne);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(position, 3));
  geometry.setAttribute('shade', new BufferAttribute(shade, 1));
  geometry.setIndex(new BufferAttribute(new Uint32Array(index), 1));
  return geometry;
}

/** Walls down from the rim of the map, so that it looks like a block that was cut out. */
function rimGeometry(ground) {
  const { columns, rows } = ground;
  const base = ground.low - 0.03 * Math.max(ground.high - ground.low, ground.dx * 10);
  const position = [], shade = [], index = [];
  const wall = (cells, brightness) => {
    for (let i = 0; i < cells.length; ++i) {
      const [column, row] = cells[i];
      const z = ground.heights[row * columns + column];
      const first = position.length / 3;
      const top = Number.isNaN(z) ? base : z;
      position.push(ground.x(column), ground.y(row), top, ground.x(column), ground.y(row), base);
      shade.push(brightness, brightness);
      if (i > 0) index.push(first - 2, first - 1, first, first, first - 1, first + 1);
    }
  };
  const across = Array.from({ length: columns }, (_, c) => c);
  const down = Array.from({ length: rows }, (_, r) => r);
  wall(across.map((c) => [c, 0]), 0.66);
  wall(across.map((c) => [c, rows - 1]), 0.58);
  wall(down.map((r) => [0, r]), 0.7);
  wall(down.map((r) => [columns - 1, r]), 0.54);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(position), 3));
  geometry.setAttribute('shade', new BufferAttribute(new Float32Array(shade), 1));
  geometry.setIndex(index);
  return geometry;
}

const vertexShader = `
attribute float shade;
varying float brightness;
varying float elevation;
void main() {
  brightness = shade;
  elevation = position.z;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

// Grey as on the maps, a trace of warm so that the blue of the flow stands out.
const fragmentShader = `
uniform float contour;
varying float brightness;
varying float elevation;
void main() {
  float grey = (60.0 + 195.0 * brightness) / 255.0;
  vec3 colour = grey * vec3(0.97, 0.955, 0.925);
  if (contour > 0.0) {
    float lines = elevation / contour;
    float width = fwidth(lines);
    float line = 1.0 - smoothstep(0.6, 1.4, abs(fract(lines - 0.5) - 0.5) / max(width, 1e-6));
    float heavy = mod(floor(lines + 0.5), 5.0) < 0.5 ? 0.42 : 0.2;
    colour *= 1.0 - heavy * line * (1.0 - smoothstep(0.15, 0.5, width));
  }
  gl_FragColor = vec4(colour, 1.0);
}`;

/** Distance of contour lines, about 30 over the map. */
export function contourStep(ground) {
  const wanted = (ground.high - ground.low) / 30;
  return [0.1, 0.5, 1, 2, 5, 10, 20, 50, 100].find((step) => step >= wanted) ?? 200;
}

/** The ground as a hillshade with contour lines. */
export function makeTerrain(ground) {
  const material = (contour) => new ShaderMaterial({
    vertexShader, fragmentShader, uniforms: { contour: { value: contour } }, side: DoubleSide,
  });
  const surface = new Mesh(surfaceGeometry(ground), material(contourStep(ground)));
  const rim = new Mesh(rimGeometry(ground), material(0));
  surface.frustumCulled = rim.frustumCulled = false;
  return { surface, rim };
}
