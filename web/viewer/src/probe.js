import { Raycaster, Vector2, Vector3 } from 'three';

/** Where a ray meets the ground, in the scene's frame; null if it does not. */
function groundUnder(stage, { pane, left, width }, x, y) {
  const caster = new Raycaster();
  caster.setFromCamera(
    new Vector2((2 * (x - left)) / width - 1, 1 - (2 * y) / stage.height), stage.camera);
  const inverse = pane.matrix.clone().invert();
  const origin = caster.ray.origin.clone().applyMatrix4(inverse);
  const towards = caster.ray.origin.clone().add(caster.ray.direction).applyMatrix4(inverse).sub(origin);
  const { ground } = pane.run;
  const point = new Vector3();
  const at = (t) => point.copy(towards).multiplyScalar(t).add(origin);
  const isBelow = (t) => {
    const p = at(t);
    return ground.has(p.x, p.y) && p.z < ground.height(p.x, p.y);
  };
  // Steps of half a cell in plan from where the ray comes down to the highest ground.
  const steep = Math.hypot(towards.x, towards.y);
  const step = Math.min(ground.dx, ground.dy) / 2 / Math.max(steep, 0.05);
  let t = towards.z < 0 ? Math.max(0, (ground.high - origin.z) / towards.z) : 0;
  for (let k = 0; k < 20000; ++k, t += step) {
    if (!isBelow(t)) {
      if (at(t).z < ground.low) return null;
      continue;
    }
    let [above, below] = [t - step, t];
    for (let i = 0; i < 20; ++i) {
      const middle = (above + below) / 2;
      if (isBelow(middle)) below = middle; else above = middle;
    }
    const p = at(below);
    return [p.x, p.y, ground.height(p.x, p.y)];
  }
  return null;
}

/** The particle that is seen at a place of the picture, as its number; -1 if there is none. */
function particleAt(stage, view, x, y, behind) {
  const { particles, run } = view.pane;
  const e = stage.clip(view.pane).elements;
  const value = new Float64Array(6);
  const { size } = stage.picture(view.pane, view.width);
  let best = -1, nearest = behind;
  for (let i = 0; i < particles.count; ++i) {
    const [px, py, h] = particles.read(i, value);
    const pz = run.ground.height(px, py) + h;
    const w = e[3] * px + e[7] * py + e[11] * pz + e[15];
    if (w <= 0 || w >= nearest) continue;
    const dx = view.left + ((e[0] * px + e[4] * py + e[8] * pz + e[12]) / w + 1) * (view.width / 2) - x;
    const dy = (1 - (e[1] * px + e[5] * py + e[9] * pz + e[13]) / w) * (stage.height / 2) - y;
    const radius = Math.max(4, size / w / 2);
    if (dx * dx + dy * dy > radius * radius) continue;
    best = i;
    nearest = w;
  }
  return best;
}

/** The place that a click means, x and y in the scene's frame; null beside the ground. */
export function pick(stage, x, y) {
  const view = stage.viewAt(x);
  const ground = groundUnder(stage, view, x, y);
  const size = view.pane.particles.material.uniforms.size.value;
  const behind = ground ? stage.project(view, ground).depth + 2 * size : Infinity;
  const i = particleAt(stage, view, x, y, behind);
  if (i < 0 && !ground) return null;
  const [px, py] = i < 0 ? ground : view.pane.particles.read(i, new Float64Array(6));
  return { view, x: px, y: py };
}

/**
 * What is at a place of a pane's scene now: the ground, and of the particles within one spacing in
 * plan the uppermost.
 */
export function valuesAt(pane, x, y) {
  const { particles, run } = pane;
  const value = new Float64Array(6);
  const reach = run.scene.spacing;
  let found = null;
  for (let i = 0; i < particles.count; ++i) {
    particles.read(i, value);
    if (Math.abs(value[0] - x) > reach || Math.abs(value[1] - y) > reach) continue;
    if (Math.hypot(value[0] - x, value[1] - y) > reach) continue;
    if (!found || value[2] > found.height)
      found = { height: value[2], depth: value[3], speed: value[4], pressure: value[5] };
  }
  return { ground: run.ground.has(x, y) ? run.ground.height(x, y) : null, flow: found };
}
