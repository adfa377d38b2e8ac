import { LinearSRGBColorSpace, PerspectiveCamera, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

import { Pane } from './pane.js';

const opening = 32; // degrees, from top to bottom of the picture

/** Whether the graphics are computed by the processor. */
function isSoftware(gl) {
  const details = gl.getExtension('WEBGL_debug_renderer_info');
  const name = gl.getParameter(details ? details.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

/** Camera, renderer and the panes of one run or two. */
export class Stage {
  constructor(holder, runs) {
    this.renderer = new WebGLRenderer({ antialias: false, powerPreference: 'high-performance' });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.autoClear = false;
    this.isSlow = isSoftware(this.renderer.getContext());
    this.canvas = this.renderer.domElement;
    this.holder = holder;
    holder.append(this.canvas);
    const { ground } = runs[0];
    this.centre = [...ground.centre, ground.low];
    this.shift = new Vector3(...this.centre);
    this.panes = runs.map((run) => {
      // Runs of one place may have another origin.
      const [dx, dy] = [0, 1].map((k) => run.scene.origin[k] - runs[0].scene.origin[k]);
      return new Pane(run, [this.centre[0] - dx, this.centre[1] - dy, this.centre[2]]);
    });
    this.camera = new PerspectiveCamera(opening, 1, 1, 1e5);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.maxPolarAngle = 1.5;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener('change', () => this.cameraMoved());
    this.mode = 'first';
    this.swipe = 0.5;
    this.drawn = 0;
    this.isDue = true;
    this.onDraw = () => {};
    new ResizeObserver(() => this.resize()).observe(holder);
    this.resize();
  }

  cameraMoved() {
    for (const pane of this.panes) pane.isStale = true;
    this.isDue = true;
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.holder;
    if (width === 0 || height === 0) return;
    this.width = width;
    this.height = height;
    this.ratio = this.isSlow ? 1 : Math.min(window.devicePixelRatio, 2);
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height);
    this.#fitCamera();
  }

  setMode(mode) {
    this.mode = mode;
    this.#fitCamera();
  }

  setExaggeration(factor) {
    this.exaggeration = factor;
    for (const pane of this.panes) pane.setExaggeration(factor);
    this.isDue = true;
  }

  /** The panes to draw with the part of the picture (px) that each has and that of it which shows. */
  get views() {
    const { width, height, panes: [first, second] } = this;
    const whole = { left: 0, width, from: 0, to: width };
    const split = Math.round(width * this.swipe);
    const half = Math.floor(width / 2);
    switch (second ? this.mode : 'first') {
      case 'second':
        return [{ pane: second, ...whole }];
      case 'both':
        return [
          { pane: first, left: 0, width: half, from: 0, to: half },
          { pane: second, left: width - half, width: half, from: width - half, to: width },
        ];
      case 'swipe':
        return [
          { pane: first, ...whole, to: split },
          { pane: second, ...whole, from: split },
        ];
      default:
        return [{ pane: first, ...whole, height }];
    }
  }

  /** The view at a place of the picture, px. */
  viewAt(x) {
    return this.views.find(({ from, to }) => x >= from && x < to) ?? this.views[0];
  }

  draw() {
    this.isDue = false;
    const { renderer, camera, height, ratio } = this;
    const views = this.views;
    for (const { pane, width } of views) {
      pane.setSize(Math.round(width * ratio), Math.round(height * ratio), this.isSlow ? 0 : 4);
      pane.particles.material.uniforms.pixels.value.set(
        (camera.projectionMatrix.elements[5] * height * ratio) / 2, 3 * ratio);
      pane.prepare(renderer, camera);
      if (this.isSlow) pane.particles.leaveOutHidden(this.clip(pane), this.picture(pane, width));
    }
    renderer.setScissorTest(true);
    for (const { pane, left, width, from, to } of views) {
      renderer.setViewport(left, 0, width, height);
      renderer.setScissor(from, 0, to - from, height);
      pane.draw(renderer, camera);
    }
    renderer.setScissorTest(false);
    ++this.drawn;
    this.onDraw();
  }

  /** From the scene's frame of a pane to clip space. */
  clip(pane) {
    return this.camera.projectionMatrix.clone()
      .multiply(this.camera.matrixWorldInverse).multiply(pane.matrix);
  }

  /** Size of the picture (px) and of a particle on it, in px at a distance of 1 m. */
  picture(pane, width) {
    const { size } = pane.particles.material.uniforms;
    const scale = (this.camera.projectionMatrix.elements[5] * this.height) / 2;
    return { width, height: this.height, size: size.value * scale };
  }

  /** Where a point of the first scene's frame is on the picture of a view, px; null behind the camera. */
  project({ pane, left, width }, [x, y, z]) {
    const point = new Vector3(x, y, z).applyMatrix4(pane.matrix);
    const depth = point.clone().applyMatrix4(this.camera.matrixWorldInverse).z;
    if (depth > -this.camera.near) return null;
    point.project(this.camera);
    return { x: left + ((point.x + 1) / 2) * width, y: ((1 - point.y) / 2) * this.height, depth: -depth };
  }

  /**
   * Looks at points (scene's frame) from the nearest place that holds them all, towards an azimuth
   * (degrees from north) and down. `free` is the part of the picture that nothing lies over: shares
   * of its height above and below.
   */
  look(points, azimuth, down, free = { above: 0.2, below: 0.17 }) {
    const a = (azimuth * Math.PI) / 180, d = (down * Math.PI) / 180;
    const forward = new Vector3(Math.sin(a) * Math.cos(d), Math.cos(a) * Math.cos(d), -Math.sin(d));
    const right = new Vector3(Math.cos(a), -Math.sin(a), 0);
    const up = new Vector3().crossVectors(right, forward);
    const tall = Math.tan((this.camera.fov * Math.PI) / 360), wide = tall * this.camera.aspect;
    const seen = points.map(([x, y, z]) => {
      const p = new Vector3(x - this.centre[0], y - this.centre[1],
        (this.exaggeration ?? 1) * (z - this.centre[2]));
      return [p.dot(right), p.dot(up), p.dot(forward)];
    });
    // Between the planes through the camera that bound the free part, one pair at a time.
    const fit = (axis, low, high) => {
      const least = Math.min(...seen.map((p) => p[axis] - low * p[2]));
      const most = Math.max(...seen.map((p) => p[axis] - high * p[2]));
      const depth = (least - most) / (high - low); // of the camera, along forward
      return { depth, at: least + low * depth };
    };
    const across = fit(0, -0.92 * wide, 0.92 * wide);
    const upright = fit(1, -tall * (1 - 2 * free.below), tall * (1 - 2 * free.above));
    const depth = Math.min(across.depth, upright.depth);
    const middle = (axis, low, high) => {
      const least = Math.min(...seen.map((p) => p[axis] - low * (p[2] - depth)));
      const most = Math.max(...seen.map((p) => p[axis] - high * (p[2] - depth)));
      return (least + most) / 2;
    };
    const x = middle(0, -0.92 * wide, 0.92 * wide);
    const y = middle(1, -tall * (1 - 2 * free.below), tall * (1 - 2 * free.above));
    const place = new Vector3().addScaledVector(right, x).addScaledVector(up, y)
      .addScaledVector(forward, depth);
    const away = seen.reduce((sum, p) => sum + p[2] - depth, 0) / seen.length;
    this.camera.position.copy(place);
    this.controls.target.copy(place).addScaledVector(forward, away);
    this.#fitCamera();
    this.controls.update();
    this.cameraMoved();
  }

  #fitCamera() {
    const width = this.mode === 'both' && this.panes[1] ? this.width / 2 : this.width;
    const { ground } = this.panes[0].run;
    const size = Math.hypot(ground.east - ground.west, ground.north - ground.south, ground.high - ground.low);
    this.camera.aspect = width / this.height;
    this.camera.fov = opening;
    this.camera.near = size / 2000;
    this.camera.far = size * 20;
    this.camera.updateProjectionMatrix();
    this.cameraMoved();
  }
}
