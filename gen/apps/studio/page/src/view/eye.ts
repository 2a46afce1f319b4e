import { MathUtils, PerspectiveCamera, Sphere, Vector3, type Box3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Header, Vec3 } from "./header";

/** How much of the window the film's frame takes from where the preset's camera stands: all of it is seen, with some air. */
const FRAME = 0.94;
const FLIGHT = 450; // ms

/** Where a person looks from: round a point, or through the preset's camera. */
export class Eye {
  readonly camera = new PerspectiveCamera(40, 1, 0.05, 2000);
  readonly controls: OrbitControls;
  /** Whether it looks through the preset's camera. */
  through = false;
  /** Whether a person has moved it since it stood where the preset's camera does. */
  moved = false;
  private film: Header["camera"] = { at: [0, 1, 5], to: [0, 0, 0], angle: 50, way: [] };
  private filmAspect = 1.6;
  private width = 1;
  private height = 1;
  private flight: { begin: number; at: Vector3; to: Vector3; fov: number } | null = null;

  constructor(
    canvas: HTMLCanvasElement,
    private changed: () => void,
    private left: () => void,
  ) {
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.12;
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", changed);
    this.controls.addEventListener("start", () => this.leave());
  }

  /** What the preset says; `first`: stand there. */
  follow(header: Header, first: boolean): void {
    this.film = header.camera;
    this.filmAspect = header.film.size[0] / header.film.size[1];
    if (first || (this.through && !this.flight)) this.stand();
    this.lens();
  }

  resize(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.camera.aspect = this.width / this.height;
    this.camera.fov = this.fov();
    this.lens();
  }

  /** `atOnce`: without flying there. */
  lookThrough(on: boolean, atOnce: boolean): void {
    if (on === this.through) return;
    this.through = on;
    const { camera, controls } = this;
    const still = atOnce || matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.flight = { begin: performance.now() - (still ? FLIGHT : 0), at: camera.position.clone(), to: controls.target.clone(), fov: camera.fov };
    this.changed();
  }

  /** A step on its way; whether there is more to come. */
  step(): boolean {
    if (!this.flight) return this.controls.update();
    const { begin, at, to, fov } = this.flight;
    const t = MathUtils.smoothstep(performance.now() - begin, 0, FLIGHT);
    if (this.through) {
      this.camera.position.lerpVectors(at, filmAt.set(...this.film.at), t);
      this.controls.target.lerpVectors(to, filmTo.set(...this.film.to), t);
    }
    this.camera.fov = MathUtils.lerp(fov, this.fov(), t);
    this.lens();
    this.controls.update();
    if (t >= 1) this.flight = null;
    return true;
  }

  /** Turns, goes or comes nearer by keys; whether the key meant something. */
  key(event: KeyboardEvent): boolean {
    const { controls } = this;
    const [x, y] = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [0, 0];
    if (event.key === "+" || event.key === "=") zoom(this.camera, controls.target, 0.85);
    else if (event.key === "-") zoom(this.camera, controls.target, 1 / 0.85);
    else if (event.key === "Home") this.stand();
    else if (!x && !y) return false;
    else if (event.shiftKey) slide(this.camera, controls.target, x!, y!);
    else turn(this.camera, controls.target, 0.08 * x!, 0.06 * y!);
    this.leave();
    this.changed();
    return true;
  }

  /** Looks at a box so that all of it is in the window, from where it looks now or from that side. */
  lookAt(box: Box3, from?: Vec3): void {
    this.leave();
    this.rest();
    const { camera, controls } = this;
    this.flight = null;
    camera.fov = this.fov();
    if (from) arm.set(...from);
    else arm.copy(camera.position).sub(controls.target);
    if (arm.lengthSq() === 0) arm.set(0, 0.3, 1);
    box.getBoundingSphere(ball);
    const half = Math.min(Math.tan(MathUtils.degToRad(camera.fov) / 2), Math.tan(MathUtils.degToRad(camera.fov) / 2) * camera.aspect);
    const away = (1.1 * Math.max(ball.radius, 0.005)) / Math.sin(Math.atan(half));
    controls.target.copy(ball.center);
    camera.position.copy(ball.center).addScaledVector(arm.normalize(), away);
    this.lens();
    controls.update();
    this.changed();
  }

  /** Looks from a place at another. */
  goTo(at: Vec3, to: Vec3): void {
    this.leave();
    this.rest();
    this.flight = null;
    this.camera.position.set(...at);
    this.controls.target.set(...to);
    this.camera.fov = this.fov();
    this.lens();
    this.controls.update();
    this.changed();
  }

  /** Looks as another eye does. */
  lookAs(other: Eye): void {
    this.moved = true;
    this.flight = null;
    this.camera.copy(other.camera);
    this.controls.target.copy(other.controls.target);
    this.rest();
  }

  /** Stands where the preset's camera does. */
  home(): void {
    this.stand();
    this.lens();
    this.changed();
  }

  /** The film's frame in the window: left, top, width and height in pixels. */
  frame(): [number, number, number, number] {
    const width = FRAME * Math.min(this.width, this.height * this.filmAspect);
    const height = width / this.filmAspect;
    return [(this.width - width) / 2, (this.height - height) / 2, width, height];
  }

  /** The preset's camera alone, for a picture of the film's aspect. */
  filmCamera(): PerspectiveCamera {
    const { film } = this;
    const fov = 2 * Math.atan(Math.tan(MathUtils.degToRad(film.angle) / 2) / this.filmAspect);
    const camera = new PerspectiveCamera(MathUtils.radToDeg(fov), this.filmAspect, this.camera.near, this.camera.far);
    camera.position.set(...film.at);
    upright(camera, film);
    camera.lookAt(...film.to);
    camera.updateMatrixWorld();
    return camera;
  }

  at(): Vec3 {
    return this.camera.position.toArray();
  }
  to(): Vec3 {
    return this.controls.target.toArray();
  }
  dispose(): void {
    this.controls.dispose();
  }

  private leave(): void {
    this.moved = true;
    if (!this.through) return;
    this.lookThrough(false, false);
    this.left();
  }
  private stand(): void {
    this.rest();
    this.moved = false;
    this.camera.position.set(...this.film.at);
    this.controls.target.set(...this.film.to);
    this.camera.fov = this.fov();
    this.controls.update();
  }
  /** Ends what is left of a turn: it would go on from the next place. */
  private rest(): void {
    this.controls.enableDamping = false;
    this.controls.update();
    this.controls.enableDamping = true;
  }
  /** So that the film's frame is all in the window. */
  private fov(): number {
    const [, , width] = this.frame();
    return MathUtils.radToDeg(2 * Math.atan((Math.tan(MathUtils.degToRad(this.film.angle) / 2) * this.height) / width));
  }
  private lens(): void {
    const away = Math.max(this.camera.position.distanceTo(this.controls.target), 1e-3);
    this.camera.near = Math.min(0.05, 0.02 * away);
    this.camera.far = Math.max(600, 20 * away);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }
}

const filmAt = new Vector3();
const filmTo = new Vector3();
const arm = new Vector3();
const aside = new Vector3();
const ball = new Sphere();

/** A camera that looks straight down has no up but north. */
function upright(camera: PerspectiveCamera, film: Header["camera"]): void {
  arm.set(...film.to).sub(filmAt.set(...film.at)).normalize();
  camera.up.set(0, 1, 0);
  if (Math.abs(arm.y) > 0.999) camera.up.set(0, 0, -1);
}
function zoom(camera: PerspectiveCamera, target: Vector3, by: number): void {
  camera.position.sub(target).multiplyScalar(by).add(target);
}
function slide(camera: PerspectiveCamera, target: Vector3, x: number, y: number): void {
  const step = 0.05 * camera.position.distanceTo(target);
  aside.setFromMatrixColumn(camera.matrixWorld, 0).multiplyScalar(-x * step);
  aside.addScaledVector(arm.setFromMatrixColumn(camera.matrixWorld, 1), y * step);
  camera.position.add(aside);
  target.add(aside);
}
function turn(camera: PerspectiveCamera, target: Vector3, across: number, up: number): void {
  arm.copy(camera.position).sub(target);
  const polar = Math.acos(MathUtils.clamp(arm.y / arm.length(), -1, 1));
  aside.set(arm.z, 0, -arm.x).normalize();
  arm.applyAxisAngle(aside, -MathUtils.clamp(up, 0.05 - Math.PI + polar, polar - 0.05));
  camera.position.copy(arm.applyAxisAngle(camera.up, -across)).add(target);
}
