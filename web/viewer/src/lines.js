import { Group } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

// As on the maps (src/io/output/map_line.cpp). Dashes in metres, times the size of a cell.
const styles = {
  section: { color: 0x1f2933, linewidth: 2.5, dash: 0 },
  path: { color: 0x1f2933, linewidth: 1.5, dash: 3 },
  zone: { color: 0x0b5cad, linewidth: 2, dash: 0 },
  edit: { color: 0xb35900, linewidth: 2, dash: 2 },
};

/** Points along a line, a cell or less apart, on the ground; in pieces where there is no ground. */
function drape(points, ground) {
  const segments = [];
  const step = Math.min(ground.dx, ground.dy);
  let before = null;
  for (let i = 1; i < points.length; ++i) {
    const [[x0, y0], [x1, y1]] = [points[i - 1], points[i]];
    const parts = Math.min(Math.max(Math.ceil(Math.hypot(x1 - x0, y1 - y0) / step), 1), 2000);
    for (let k = i === 1 ? 0 : 1; k <= parts; ++k) {
      const x = x0 + ((x1 - x0) * k) / parts, y = y0 + ((y1 - y0) * k) / parts;
      const point = ground.has(x, y) ? [x, y, ground.height(x, y)] : null;
      if (before && point) segments.push(...before, ...point);
      before = point;
    }
  }
  return segments;
}

/** Path, sections and zones laid on the ground; and where their names stand. */
export function makeLines(lines, ground) {
  const group = new Group();
  const anchors = [];
  const materials = [];
  const cell = Math.max(ground.dx, (ground.east - ground.west) / 300);
  for (const { kind, name, points } of lines) {
    const { color, linewidth, dash } = styles[kind] ?? styles.path;
    const segments = drape(points, ground);
    if (segments.length === 0) continue;
    // Drawn nearer than the ground that it lies on.
    const material = new LineMaterial({
      color, linewidth, dashed: dash > 0, dashSize: 2 * dash * cell, gapSize: dash * cell,
      polygonOffset: true, polygonOffsetFactor: -6, polygonOffsetUnits: -40,
    });
    materials.push(material);
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(segments);
    const line = new LineSegments2(geometry, material);
    line.computeLineDistances();
    line.frustumCulled = false;
    group.add(line);
    if (name) anchors.push({ name, kind, at: segments.slice(0, 3) });
  }
  return { group, anchors, setSize: (w, h) => materials.forEach((m) => m.resolution.set(w, h)) };
}
