import {
  Color, DepthTexture, GLSL3, Group, Mesh, OrthographicCamera, PlaneGeometry, Scene, ShaderMaterial,
  UnsignedIntType, WebGLRenderTarget,
} from 'three';

import { makeLines } from './lines.js';
import { Particles } from './particles.js';
import { makeSolids } from './solids.js';
import { makeTerrain } from './terrain.js';

const background = new Color(0xdfe7ee);

/**
 * One run as it is drawn. What stands still (ground, solids, lines) is drawn into a picture with its
 * depths when the camera has moved, and that picture is laid under the particles of each time.
 */
export class Pane {
  constructor(run, centre) {
    this.run = run;
    this.terrain = makeTerrain(run.ground);
    this.solids = makeSolids(run.scene.solids);
    this.lines = makeLines(run.scene.lines, run.ground);
    this.particles = new Particles(run);
    this.still = new Scene();
    this.still.background = background;
    this.moving = new Scene();
    this.roots = [this.still, this.moving].map((scene) => {
      const root = new Group();
      root.position.set(-centre[0], -centre[1], 0);
      const scaled = new Group();
      scaled.add(root);
      scene.add(scaled);
      return { scaled, root };
    });
    this.base = centre[2];
    this.roots[0].root.add(this.terrain.surface, this.terrain.rim, this.solids.group, this.lines.group);
    this.roots[1].root.add(this.particles.points);
    this.setExaggeration(1);
    this.isStale = true;
    this.#makeCopy();
  }

  /** Heights count from the base, so that the picture stays where it is. */
  setExaggeration(factor) {
    for (const { scaled, root } of this.roots) {
      scaled.scale.z = factor;
      root.position.z = -this.base;
    }
    this.isStale = true;
  }

  /** From the scene's frame to what the camera sees. */
  get matrix() {
    const { root } = this.roots[1];
    root.updateWorldMatrix(true, false);
    return root.matrixWorld;
  }

  setSize(width, height, samples) {
    if (this.target?.width === width && this.target.height === height) return;
    this.target?.dispose();
    this.target = new WebGLRenderTarget(width, height, { samples });
    this.target.depthTexture = new DepthTexture(width, height, UnsignedIntType);
    this.copy.uniforms.picture.value = this.target.texture;
    this.copy.uniforms.depths.value = this.target.depthTexture;
    this.lines.setSize(width, height);
    this.isStale = true;
  }

  /** Draws the picture of what stands still, if need be. */
  prepare(renderer, camera) {
    if (!this.isStale) return;
    renderer.setRenderTarget(this.target);
    renderer.clear();
    renderer.render(this.still, camera);
    renderer.setRenderTarget(null);
    this.isStale = false;
  }

  /** Draws into the viewport of the renderer. */
  draw(renderer, camera) {
    renderer.render(this.flat, this.flatCamera);
    renderer.render(this.moving, camera);
  }

  #makeCopy() {
    this.copy = new ShaderMaterial({
      glslVersion: GLSL3,
      uniforms: { picture: { value: null }, depths: { value: null } },
      vertexShader: 'out vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }',
      fragmentShader: `
        uniform sampler2D picture; uniform highp sampler2D depths; in vec2 at; out vec4 pixel;
        void main() {
          pixel = vec4(texture(picture, at).rgb, 1.0);
          gl_FragDepth = texture(depths, at).r;
        }`,
    });
    const quad = new Mesh(new PlaneGeometry(2, 2), this.copy);
    quad.frustumCulled = false;
    this.flat = new Scene();
    this.flat.add(quad);
    this.flatCamera = new OrthographicCamera(-1, 1, 1, -1, 0, 1);
  }
}
