// The model on the viewer's canvas: a GLB, drawn when something changes, turned by mouse, finger and keys.
import {
  Box3,
  Group,
  LoadingManager,
  Mesh,
  PerspectiveCamera,
  Scene,
  Sphere,
  Spherical,
  TextureLoader,
  Vector3,
  WebGLRenderer,
} from 'three';
import type { Material, Object3D } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { Failure } from '../failure.ts';
import { studioLight } from './light.ts';

/** What is shown: of the whole scene, metres. */
export interface Facts {
  triangles: number;
  size: [number, number, number];
}

/** Vertical angle of view in degrees; where the first view stands, as the page's own (web/ui/views.cpp). */
const kFov = 30,
  kHomeYaw = 0.55,
  kHomePitch = 0.22;
/** Room round the model, as a share of its radius. */
const kRoom = 1.05;
/** Once round takes so many seconds. */
const kRoundSeconds = 24;
/** Browsers on phones have three pixels to one of CSS: two are enough. */
const kMostRatio = 2;
/** Never straight from above or below: there left and right have no meaning. */
const kSteepest = 0.02;

/** Loads nothing by address: what a model shows is in its own file. */
function ownFileOnly(): LoadingManager {
  const manager = new LoadingManager();
  manager.setURLModifier((url) => (/^(blob|data):/.test(url) ? url : 'data:,'));
  return manager;
}

/** The name of the model in a GLB of ours; empty for others. */
function titleOf(json: unknown): string {
  const { extensions } = json as { extensions?: { SPINELOFT_project?: { document?: { name?: unknown } } } };
  const name = extensions?.SPINELOFT_project?.document?.name;
  return typeof name === 'string' ? name : '';
}

function trianglesOf(object: Object3D): number {
  let count = 0;
  object.traverse((one) => {
    if (!(one instanceof Mesh)) return;
    const { index, attributes } = one.geometry;
    count += (index ? index.count : attributes['position'].count) / 3;
  });
  return count;
}

function dispose(object: Object3D): void {
  object.traverse((one) => {
    if (!(one instanceof Mesh)) return;
    one.geometry.dispose();
    for (const material of [one.material].flat() as Material[]) {
      (material as Material & { map?: { dispose(): void } | null }).map?.dispose();
      material.dispose();
    }
  });
}

export class Stage {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(kFov, 1, 0.01, 100);
  private readonly controls: OrbitControls;
  private model: Group | null = null;
  private readonly ball = new Sphere(new Vector3(), 1);
  private frame = 0;
  private before = 0;

  /** `turned` is called when the turning starts or stops. Throws where the browser cannot draw in 3D. */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly turned: (on: boolean) => void,
  ) {
    this.renderer = new WebGLRenderer({ canvas, alpha: true, antialias: true });
    this.scene.environment = studioLight(this.renderer);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enablePan = false;
    this.controls.minPolarAngle = kSteepest;
    this.controls.maxPolarAngle = Math.PI - kSteepest;
    this.controls.autoRotateSpeed = 60 / kRoundSeconds;
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('start', () => this.spin(false));
    new ResizeObserver(() => this.fit()).observe(canvas);
    document.addEventListener('visibilitychange', () => this.draw());
    canvas.addEventListener('webglcontextrestored', () => this.draw());
    canvas.addEventListener('keydown', (event) => this.press(event));
  }

  /** A wheel and a finger that go over it move the page around it: only who has chosen the model zooms it. */
  set isGuest(isGuest: boolean) {
    if (!isGuest) return;
    const choose = () => {
      this.controls.enableZoom = document.activeElement === this.canvas;
    };
    this.canvas.addEventListener('focus', choose);
    this.canvas.addEventListener('blur', choose);
    this.canvas.style.touchAction = 'pan-y';
    choose();
  }

  /** Shows the model of a GLB in place of the one before. Rejects when it is none; then the one before stays. */
  async show(glb: ArrayBuffer): Promise<Facts & { title: string }> {
    const loader = new GLTFLoader(ownFileOnly());
    // Pictures as elements: a page without the right to fetch its own blobs shows them, too.
    loader.register((parser) => {
      parser.textureLoader = new TextureLoader(ownFileOnly());
      return { name: 'pictures' };
    });
    const { scene, parser } = await loader.parseAsync(glb, '');
    const box = new Box3().setFromObject(scene, true);
    if (box.isEmpty())
      throw new Failure('NothingToExport', 'There is nothing to show yet. Draw a line through something first.');
    if (this.model) {
      this.scene.remove(this.model);
      dispose(this.model);
    }
    this.model = scene;
    this.scene.add(scene);
    box.getBoundingSphere(this.ball);
    this.home();
    return { triangles: trianglesOf(scene), size: box.getSize(new Vector3()).toArray(), title: titleOf(parser.json) };
  }

  /** The first view: a little from the right and from above. */
  home(): void {
    this.fit();
    this.look(kHomeYaw, kHomePitch);
  }

  /** From there, in radians: yaw to the right of the front, pitch above it. */
  look(yaw: number, pitch: number): void {
    const { center, radius } = this.ball;
    const away = this.distance(radius);
    this.controls.target.copy(center);
    this.controls.minDistance = radius * 0.3;
    this.controls.maxDistance = away * 4;
    this.place(new Spherical(away, Math.PI / 2 - pitch, yaw));
  }

  /** Turns the view by radians, and zooms by a factor. */
  move(yaw: number, pitch: number, zoom = 1): void {
    const at = new Spherical().setFromVector3(this.camera.position.clone().sub(this.controls.target));
    const { minDistance, maxDistance } = this.controls;
    this.place(
      new Spherical(
        Math.min(maxDistance, Math.max(minDistance, at.radius / zoom)),
        Math.min(Math.PI - kSteepest, Math.max(kSteepest, at.phi - pitch)),
        at.theta + yaw,
      ),
    );
  }

  get isTurning(): boolean {
    return this.controls.autoRotate;
  }

  spin(on: boolean): void {
    if (this.controls.autoRotate === on) return;
    this.controls.autoRotate = on;
    this.before = performance.now();
    this.turned(on);
    this.draw();
  }

  private place(at: Spherical): void {
    this.camera.position.setFromSpherical(at).add(this.controls.target);
    this.controls.update(0);
    this.draw();
  }

  /** From where a ball of this radius fills the view. */
  private distance(radius: number): number {
    const half = ((kFov / 2) * Math.PI) / 180;
    const narrow = Math.atan(Math.tan(half) * Math.min(1, this.camera.aspect));
    return (radius * kRoom) / Math.sin(narrow);
  }

  private fit(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio || 1, kMostRatio));
    this.renderer.setSize(width, height, false);
    const before = this.distance(1);
    this.camera.aspect = width / height;
    const { radius } = this.ball;
    this.camera.near = radius / 50;
    this.camera.far = radius * 100;
    this.camera.updateProjectionMatrix();
    this.move(0, 0, before / this.distance(1));
    this.draw();
  }

  /** One frame is drawn soon; while the model turns, one after the other. */
  private draw(): void {
    if (this.frame !== 0 || document.hidden) return;
    this.frame = requestAnimationFrame((now) => {
      this.frame = 0;
      if (this.isTurning) {
        this.controls.update(Math.min(0.1, (now - this.before) / 1000));
        this.before = now;
      }
      // The light stays with the viewer, as in the page.
      this.scene.environmentRotation.y = this.controls.getAzimuthalAngle();
      this.renderer.render(this.scene, this.camera);
      if (this.isTurning) this.draw();
    });
  }

  private press(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = Math.PI / 12;
    const acts: Record<string, () => void> = {
      ArrowLeft: () => this.move(-step, 0),
      ArrowRight: () => this.move(step, 0),
      ArrowUp: () => this.move(0, step),
      ArrowDown: () => this.move(0, -step),
      '+': () => this.move(0, 0, 1.2),
      '=': () => this.move(0, 0, 1.2),
      '-': () => this.move(0, 0, 1 / 1.2),
      h: () => this.home(),
      H: () => this.home(),
      ' ': () => this.spin(!this.isTurning),
    };
    const act = acts[event.key];
    if (!act) return;
    event.preventDefault();
    if (event.key !== ' ') this.spin(false);
    act();
  }
}
