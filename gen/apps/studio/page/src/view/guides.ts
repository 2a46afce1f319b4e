import { BufferAttribute, BufferGeometry, Group, Line, LineBasicMaterial, LineSegments, Vector3, type PerspectiveCamera } from "three";
import { wayOf } from "../keyframes";
import type { Header, Vec3 } from "./header";
import { Marks, type ToPixel } from "./marks";

/** A path that can be dragged: its keys, each with the JSON pointer of its vector. */
export interface Path {
  what: "food" | "camera";
  pointer: string;
  keys: { t: number; at: Vec3; shape?: unknown; pointer: string }[];
}

/** A key that one can take hold of. */
export interface Handle {
  what: Path["what"];
  pointer: string;
  at: Vector3;
}

const COLORS = { food: 0xffa63d, camera: 0x6aa5ff, foot: 0xffffff };
const PIECES = 16;
/** More feet than these are a carpet that hides what stands on them. */
const MOST_FEET = 200;

const lines = (color: number, opacity: number): LineBasicMaterial => new LineBasicMaterial({ color, transparent: true, opacity, depthTest: false });

/** Lines and handles that are no part of the picture: paths with their keys, the preset's camera, the ring under what is
 *  dragged. */
export class Guides extends Group {
  private handles: Handle[] = [];
  private paths = new Marks();
  private way = new Marks();
  private feet = new Marks();
  private film: LineSegments;
  private ring: Line;
  private list: Path[] = [];
  private cameraShown = true;

  constructor() {
    super();
    this.film = new LineSegments(new BufferGeometry(), lines(COLORS.camera, 0.9));
    this.film.geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * 20), 3));
    const circle = Float32Array.from({ length: 3 * 49 }, (_, i) => [Math.cos((Math.floor(i / 3) / 48) * 2 * Math.PI), 0, Math.sin((Math.floor(i / 3) / 48) * 2 * Math.PI)][i % 3]!);
    this.ring = new Line(new BufferGeometry().setAttribute("position", new BufferAttribute(circle, 3)), lines(0xffffff, 0.9));
    this.ring.visible = false;
    for (const one of [this.film, this.ring]) one.frustumCulled = false;
    this.add(this.film, this.way, this.paths, this.feet, this.ring);
  }

  setPaths(list: Path[]): void {
    this.list = list;
    this.paths.clear();
    this.handles = [];
    for (const { what, keys } of list) {
      this.paths.line(wayOf(keys.map(({ t, at, shape }) => [t, at, shape]), PIECES), COLORS[what], 0.8);
      for (const { at, pointer } of keys) {
        this.handles.push({ what, pointer, at: new Vector3(...at) });
        this.paths.handle(this.handles.at(-1)!.at, COLORS[what]);
      }
    }
  }

  /** The way of the preset's camera over the film; empty: none is shown. */
  setWay(places: Vec3[]): void {
    this.way.clear();
    if (places.length) this.way.line(places.flat(), COLORS.camera, 0.8);
  }

  /** What can be moved over the ground is taken hold of at its foot. */
  setFeet(list: Vec3[]): void {
    this.feet.clear();
    for (const at of list.slice(0, MOST_FEET)) this.feet.handle(new Vector3(...at), COLORS.foot);
  }

  /** The foot that is drawn nearest to a pixel, as its number in the list; -1: none is near. */
  footAt(x: number, y: number, toPixel: ToPixel): number {
    return this.feet.nearest(x, y, toPixel);
  }

  /** Moves one key until the paths are set anew. */
  moveKey(pointer: string, at: Vec3): void {
    this.setPaths(this.list.map((path) => ({ ...path, keys: path.keys.map((key) => (key.pointer === pointer ? { ...key, at } : key)) })));
  }

  /** The pyramid of the preset's camera. */
  setCamera(header: Header, at: Vec3 = header.camera.at): void {
    const { to, angle } = header.camera;
    const eye = new Vector3(...at);
    const ahead = new Vector3(...to).sub(eye);
    const reach = 0.12 * ahead.length();
    ahead.normalize();
    const right = new Vector3().crossVectors(ahead, new Vector3(0, 1, 0));
    if (right.length() < 1e-3) right.set(1, 0, 0);
    right.normalize();
    const up = new Vector3().crossVectors(right, ahead);
    const half = Math.tan((angle * Math.PI) / 360) * reach;
    const tall = (half * header.film.size[1]) / header.film.size[0];
    const corner = (x: number, y: number): Vector3 => eye.clone().addScaledVector(ahead, reach).addScaledVector(right, x * half).addScaledVector(up, y * tall);
    const [a, b, c, d] = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)] as [Vector3, Vector3, Vector3, Vector3];
    const list = [eye, a, eye, b, eye, c, eye, d, a, b, b, c, c, d, d, a, corner(-0.4, 1.1), corner(0, 1.6), corner(0, 1.6), corner(0.4, 1.1)];
    const position = this.film.geometry.getAttribute("position") as BufferAttribute;
    list.forEach((v, i) => position.setXYZ(i, v.x, v.y, v.z));
    position.needsUpdate = true;
  }

  /** The middle of the camera's pyramid, to click on. */
  cameraAt(): Vector3 {
    const position = this.film.geometry.getAttribute("position") as BufferAttribute;
    return new Vector3().fromBufferAttribute(position, 0).lerp(new Vector3().fromBufferAttribute(position, 8).lerp(new Vector3().fromBufferAttribute(position, 12), 0.5), 0.6);
  }

  showCamera(on: boolean): void {
    this.cameraShown = on;
  }
  get cameraSeen(): boolean {
    return this.film.visible;
  }

  /** The ring on the ground below what is dragged; null: none. */
  showRing(at: Vector3 | null, radius = 1): void {
    this.ring.visible = at !== null;
    if (at) this.ring.position.copy(at);
    this.ring.scale.setScalar(radius);
  }

  /** The key that is drawn nearest to a pixel, if any is near. */
  handleAt(x: number, y: number, toPixel: ToPixel): Handle | null {
    return this.handles[this.paths.nearest(x, y, toPixel)] ?? null;
  }

  /** Handles are of one size on the screen; the preset's camera is not seen from where it stands itself. `pixel`: metres
   *  that a pixel covers a metre away. */
  scaleTo(camera: PerspectiveCamera, pixel: number): void {
    const position = this.film.geometry.getAttribute("position") as BufferAttribute;
    const away = camera.position.distanceTo(apex.fromBufferAttribute(position, 0));
    this.film.visible = this.cameraShown && away > 1.5 * apex.distanceTo(base.fromBufferAttribute(position, 1));
    this.paths.scaleTo(camera, pixel);
    this.feet.scaleTo(camera, pixel);
    this.updateMatrixWorld();
  }

  dispose(): void {
    for (const marks of [this.paths, this.way, this.feet]) marks.clear();
    for (const one of [this.film, this.ring]) {
      one.geometry.dispose();
      (one.material as LineBasicMaterial).dispose();
    }
  }
}

const apex = new Vector3();
const base = new Vector3();
