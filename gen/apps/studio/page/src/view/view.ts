import { Box3, Raycaster, Vector2, Vector3, type Matrix4, type Object3D, type Texture } from "three";
import { pictureAddress } from "../api";
import { pngOf } from "../dom";
import { boundsOf, boxOf, SIDES } from "./boxes";
import { Stand } from "./copies";
import { Drawn } from "./drawn";
import { Eye } from "./eye";
import { Guides, type Handle, type Path } from "./guides";
import { Pictures } from "./pictures";
import { setLight } from "./light";
import { round } from "../rounding";
import { merged } from "./merge";
import { Painter } from "./painter";
import { decode } from "./packet";
import { addressOf } from "./pixels";
import { Pointer, type Planting, type PointerTarget } from "./pointer";
import { PartCache } from "./part_cache";
import type { Header, Part, Vec3 } from "./header";
import type { Tool } from "./tool";
import { Trace } from "./trace";

export type { Path } from "./guides";

/** What a person did in the view. */
export interface ViewEvents {
  picked(entry: number | null, also: boolean): void;
  /** A planting is dragged over the ground: its place in the preset's list and where its foot is now. */
  placed(entry: number, placeIndex: number, x: number, z: number, done: boolean): void;
  /** A key of a path is dragged. */
  key(what: "food" | "camera", pointer: string, at: Vec3, done: boolean): void;
  /** The preset's camera was dragged. */
  camera(at: Vec3, to: Vec3): void;
  /** Everything has to be shown anew. */
  forgotten?(): void;
  /** One looks through the preset's camera now, or no more. */
  through?(on: boolean): void;
  /** How much of the picture at rest is there, 0..1; 1 where there is nothing to wait for. */
  refining?(share: number): void;
}

/** What stands for an organism where one clicks: specimens from 1, entries that are sown from here on. */
const SOWN = 0x400000;
const NOBODY: ReadonlySet<number> = new Set();
/** A picture over the surface of organisms, or of the ground; the matrix leads from the world onto it. */
export interface Painted {
  texture: Texture;
  matrix: Matrix4;
  on: number[] | "ground";
}
const PAINT_SHOWN = 0.45;
const QUIET = 180; // ms without a change, and the picture is made finer

/** The live picture of the model. It is drawn when something has changed, and rests otherwise. */
export class View implements PointerTarget {
  private canvas = document.createElement("canvas");
  private frameBox = document.createElement("div");
  private painter: Painter;
  private eyes: Eye;
  private guides = new Guides();
  private pictures: Pictures;
  private cache: PartCache;
  private pointer: Pointer;
  private header: Header | null = null;
  private shown: { part: Part; thing: Drawn | Stand }[] = [];
  tool: Tool | null = null;
  private painted: Painted | null = null;
  private traced = new Trace();
  private selected: number | null = null;
  /** What is marked beside it. */
  private also: ReadonlySet<number> = NOBODY;
  /** Those of the selected organisms whose places the preset gives. */
  private movable: Header["specimens"] = [];
  private wayShown = false;
  private coming = 0;
  /** Whether what comes makes the picture at rest finer. */
  private refining = false;
  private sky = "";
  /** Whether the model was on the screen yet. */
  private seen = false;
  private rest = 0;
  private held = false;
  private waiting: (() => void)[] = [];
  private looked = (): void => {};
  private stop = new AbortController();

  constructor(
    private host: HTMLElement,
    private events: ViewEvents,
  ) {
    this.canvas.tabIndex = 0;
    this.canvas.className = "view-canvas";
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", "The model in 3D. Arrow keys turn it, with Shift they move it, plus and minus come nearer and go away.");
    this.canvas.style.cssText = "display:block;width:100%;height:100%;touch-action:none";
    this.frameBox.style.cssText = "position:absolute;pointer-events:none;box-shadow:0 0 0 4000px rgb(0 0 0/.55);outline:1px solid rgb(255 255 255/.5);display:none";
    if (getComputedStyle(host).position === "static") host.style.position = "relative";
    host.style.overflow = "hidden";
    host.append(this.canvas, this.traced.element, this.frameBox);
    this.painter = new Painter(this.canvas);
    this.painter.over.add(this.guides);
    this.eyes = new Eye(this.canvas, this.changed, () => this.throughChanged());
    this.pictures = new Pictures(pictureAddress, this.pictureCame);
    this.cache = new PartCache({ shared: this.painter.shared, pictures: this.pictures });
    this.pointer = new Pointer(this.canvas, this);
    this.listen();
    this.resize();
    // For tests; that of the first view.
    const told = window as { frond?: object };
    told.frond ??= { mask: this.mask, settled: this.settled };
  }

  /** Shows what the server answered; throws where it is no picture of a model. */
  show(answer: ArrayBuffer): Header {
    const packet = decode(answer);
    // The preset's camera may be known only when all has grown.
    const first = this.header === null || this.header.entries.length === 0 || (this.header.missing.length > 0 && !this.eyes.moved);
    if (this.header) packet.header = merged(this.header, packet.header);
    const kept = this.cache.take(packet);
    this.header = packet.header;
    this.shown = packet.header.parts.flatMap((part, i) => (kept[i]!.thing ? [{ part, thing: kept[i]!.thing }] : []));
    for (const { part, thing } of this.shown) this.identify(part, thing);
    this.markSelected();
    setLight(this.painter.shared, this.header);
    this.lay(this.header.sky);
    this.eyes.follow(this.header, first);
    this.guides.setCamera(this.header);
    this.showWay();
    this.painter.setThings(
      this.shown.map(({ thing }) => thing),
      boundsOf(this.header),
    );
    this.changed();
    return this.header;
  }

  have(): string[] {
    return this.cache.names();
  }

  /** Takes the keys. */
  focus(): void {
    this.canvas.focus();
  }

  /** Shows nothing, until there is another model. */
  clear(): void {
    this.header = null;
    this.shown = [];
    this.markSelected();
    this.seen = false;
    this.painter.setThings([], new Box3());
    this.changed();
  }

  select(entry: number | null, also: ReadonlySet<number> = NOBODY): void {
    if (entry === this.selected && also === this.also) return;
    this.selected = entry;
    this.also = also;
    this.markSelected();
    this.changed();
  }

  /** `way`: the camera's way over the film is shown, too. */
  paths(list: Path[], way = false): void {
    this.guides.setPaths(list);
    this.wayShown = way;
    this.showWay();
    this.changed();
  }

  private showWay(): void {
    this.guides.setWay((this.wayShown && this.header?.camera.way) || []);
  }

  /** Works with a tool, or selects again. */
  use(tool: Tool | null): void {
    if (this.tool) this.painter.over.remove(this.tool.drawn);
    this.trace([]);
    if (tool) this.painter.over.add(tool.drawn);
    this.tool = tool;
    this.scale(tool); // A pointer may press before the next picture is drawn.
    this.canvas.classList.toggle("working", tool !== null);
    this.changed();
  }

  /** Keys pressed in the view are handed on first; where `act` takes one, it does nothing else. */
  onKey(act: (event: KeyboardEvent) => boolean): void {
    this.canvas.addEventListener(
      "keydown",
      (event) => {
        if (!act(event)) return;
        event.preventDefault();
        event.stopImmediatePropagation();
      },
      { signal: this.stop.signal, capture: true },
    );
  }

  /** The height of the ground at x, z; 0 where none is drawn. */
  heightAt(x: number, z: number): number {
    return this.groundUnder(new Raycaster(new Vector3(x, 1e4, z), new Vector3(0, -1, 0)), 0)?.y ?? 0;
  }

  /** Draws a line over the picture, three numbers a point; none takes it away. */
  trace(points: readonly number[]): void {
    this.traced.show(points);
    this.traced.place(this.toPixel);
  }

  /** What a tool draws is another. */
  redraw = (): void => this.changed();

  /** The ray through the middle of the window. */
  middle(): Raycaster {
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(0, 0), this.camera);
    return ray;
  }

  /** What the window shows at rest, as a PNG. */
  async picture(): Promise<Blob> {
    await this.settled();
    // Once more, since the browser takes what was drawn away.
    this.painter.refine(this.camera);
    return pngOf(this.canvas);
  }

  /** Draws what is shown at once as finely as at rest, as the mean of so many pictures. */
  finely(pictures: number): void {
    this.painter.finely(this.camera, pictures);
  }

  /** What was shown last. */
  get head(): Header | null {
    return this.header;
  }

  lookThrough(on: boolean): void {
    this.eyes.lookThrough(on, !this.seen);
    this.throughChanged();
  }

  /** Brings one organism, or all, into the window: from where one looks now, or from a side of it. */
  frame(entry: number | null, side: keyof typeof SIDES | null = null): void {
    if (!this.header) return;
    const box = entry === null ? boundsOf(this.header) : boxOf(this.header.entries[entry]);
    if (!box.isEmpty()) this.eyes.lookAt(box, side ? SIDES[side] : undefined);
  }

  /** Back to where the preset's camera stands. */
  home(): void {
    this.eyes.home();
  }

  eye(): { at: Vec3; to: Vec3 } {
    return { at: this.eyes.at(), to: this.eyes.to() };
  }

  /** Degrees that a picture of that width by height shows across, as high as the window. */
  angleAcross(aspect: number): number {
    return round((360 / Math.PI) * Math.atan(Math.tan((this.camera.fov * Math.PI) / 360) * aspect), 2);
  }

  /** Looks as another view does. */
  lookAs(other: View): void {
    this.eyes.lookAs(other.eyes);
    this.changed();
  }

  /** Tells whenever a picture is drawn, which may be from another place. */
  onLook(act: () => void): void {
    this.looked = act;
  }

  /** Looks from a place at another. */
  goTo(at: Vec3, to: Vec3): void {
    this.eyes.goTo(at, to);
  }

  /** The ground at a place in the window; null: none is there. */
  groundAt(clientX: number, clientY: number): Vec3 | null {
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = [(clientX - box.left) / box.width, (clientY - box.top) / box.height];
    if (x < 0 || x > 1 || y < 0 || y > 1) return null;
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(2 * x - 1, 1 - 2 * y), this.camera);
    return this.groundUnder(ray, 0)?.toArray() ?? null;
  }

  /** The organism at a place in the window. */
  organismAt(clientX: number, clientY: number): number | null {
    const box = this.canvas.getBoundingClientRect();
    return this.header && this.entryAt(clientX - box.left, clientY - box.top);
  }

  /** Resolves when the next picture is on the screen. */
  drawn(): Promise<void> {
    const done = new Promise<void>((resolve) => this.waiting.push(resolve));
    this.changed();
    return done;
  }

  /** Another picture is being asked for: this one need not become finer. */
  hold(on: boolean): void {
    this.held = on;
    if (!on && !this.coming && !this.rest) this.rest = window.setTimeout(this.quiet, QUIET);
  }

  /** Resolves when the picture is as fine as it gets. */
  settled = async (): Promise<void> => {
    await this.drawn();
    while (this.coming || this.rest || this.held) await new Promise((next) => setTimeout(next, 50));
  };

  /** Resolves when the materials of what is shown have their pictures. */
  pictured = (): Promise<void> => this.pictures.tilesReady();

  theme(dark: boolean): void {
    this.painter.backdrop = dark ? 0x16181a : 0xe8e9ea;
    this.changed();
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (!width || !height) return;
    this.painter.resize(width, height);
    this.eyes.resize(width, height);
    this.placeFrame();
    // At once: another size is a blank sheet.
    cancelAnimationFrame(this.coming);
    this.paint();
  }

  dispose(): void {
    this.stop.abort();
    cancelAnimationFrame(this.coming);
    clearTimeout(this.rest);
    this.pointer.dispose();
    this.eyes.dispose();
    this.cache.clear();
    this.pictures.dispose();
    this.guides.dispose();
    this.painter.dispose();
    this.canvas.remove();
    this.traced.element.remove();
    this.frameBox.remove();
  }

  /** Organisms white on black from the preset's camera, as a PNG's address; `quickly`: as coarse as while something moves. */
  mask = async (width: number, height: number, quickly = false): Promise<string> => {
    const pixels = this.painter.mask(this.eyes.filmCamera(), width, height, quickly);
    this.changed();
    return addressOf(pixels, width, height);
  };

  // ---- Drawing ----

  /** Asks for a picture; many askings make one. */
  private changed = (): void => {
    if (this.stop.signal.aborted) return; // a picture of a material that came after the view was closed
    this.refining = false;
    this.events.refining?.(1);
    clearTimeout(this.rest);
    this.rest = 0;
    cancelAnimationFrame(this.coming);
    this.coming = requestAnimationFrame(this.draw);
  };

  /** A picture of a material has come: what is on the screen stays as it is until it can be drawn as finely. */
  private pictureCame = (): void => {
    if (this.stop.signal.aborted || this.rest || (this.coming && !this.refining)) return; // it comes with what is drawn next
    if (!this.seen) return this.changed();
    this.painter.again();
    if (!this.coming) this.startRefining();
  };

  private draw = (): void => {
    if (this.painter.busy) this.coming = requestAnimationFrame(this.draw);
    else this.paint();
  };

  private scale(handles: Pick<Tool, "scaleTo"> | null): void {
    handles?.scaleTo(this.camera, this.painter.pixelOf(this.camera, this.canvas.clientHeight));
  }

  private paint(): void {
    this.coming = 0;
    const more = this.eyes.step();
    this.looked();
    this.traced.place(this.toPixel);
    this.scale(this.guides);
    this.scale(this.tool);
    this.painter.draw(this.camera);
    this.seen ||= this.header !== null;
    const waiting = this.waiting.splice(0);
    if (waiting.length) {
      this.painter.finish();
      requestAnimationFrame(() => waiting.forEach((resolve) => resolve()));
    }
    if (more || this.coming) {
      if (!this.coming) this.coming = requestAnimationFrame(this.draw);
      return;
    }
    this.rest = window.setTimeout(this.quiet, QUIET);
  }

  private quiet = (): void => {
    this.rest = 0;
    if (!this.header || this.coming) return;
    this.startRefining();
  };

  private startRefining(): void {
    // The sign that it becomes finer is on the screen before that keeps the machine busy.
    this.events.refining?.(0);
    this.refining = true;
    this.coming = requestAnimationFrame(() => (this.coming = requestAnimationFrame(this.refine)));
  }

  private refine = (): void => {
    if (this.held) {
      this.coming = 0;
      this.refining = false;
      return;
    }
    const more = this.painter.busy || this.painter.refine(this.camera);
    this.coming = more ? requestAnimationFrame(this.refine) : 0;
    this.refining = more;
    this.events.refining?.(more ? this.painter.settled : 1);
  };

  private listen(): void {
    const options = { signal: this.stop.signal };
    const watch = new ResizeObserver(() => this.resize());
    watch.observe(this.host);
    this.stop.signal.addEventListener("abort", () => watch.disconnect());
    this.canvas.addEventListener("keydown", (event) => this.eyes.key(event) && event.preventDefault(), options);
    // What the graphics card has forgotten is here no more: it is asked for anew.
    this.canvas.addEventListener(
      "webglcontextrestored",
      () => {
        this.shown = [];
        this.painter.forget();
        this.cache.clear();
        this.events.forgotten?.();
      },
      options,
    );
  }

  private throughChanged(): void {
    this.events.through?.(this.eyes.through);
    this.guides.showCamera(!this.eyes.through);
    this.placeFrame();
    this.changed();
  }

  private placeFrame(): void {
    const [left, top, width, height] = this.eyes.frame();
    const { style } = this.frameBox;
    style.display = this.eyes.through ? "block" : "none";
    Object.assign(style, { left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` });
  }

  // ---- What is what ----

  private identify(part: Part, thing: Drawn | Stand): void {
    const number = part.specimen >= 0 ? part.specimen + 1 : part.entry >= 0 ? SOWN + part.entry : 0;
    for (const one of thing instanceof Stand ? thing.drawn() : [thing]) {
      one.identify(number, part.entry >= 0);
      this.paintOn(part, one);
      if (part.kind !== "ground") continue;
      one.isGround = true;
      if (!one.instanced) one.uniforms.rough!.value = 0.6;
      one.casts = one.instanced;
    }
  }

  /** Lays the picture of a sky round everything, once it is there. */
  private lay(sky: string): void {
    if (sky === this.sky) return;
    this.sky = sky;
    this.painter.shared.sky.value = null;
    if (!sky) return;
    void this.pictures.sky(sky).then((texture) => {
      if (sky !== this.sky) return;
      this.painter.shared.sky.value = texture;
      this.pictureCame();
    });
  }

  private paintOn(part: Part, one: Drawn): void {
    const on = this.painted?.on;
    const shown = on === "ground" ? part.kind === "ground" : on?.includes(part.entry);
    if (one.uniforms.paint_shown) one.uniforms.paint_shown.value = shown ? PAINT_SHOWN : 0;
  }

  /** Shows a picture on the surface of what is painted. */
  showPaint(painted: Painted | null): void {
    this.painted = painted;
    this.painter.shared.painted.value = painted?.texture ?? null;
    if (painted) this.painter.shared.to_painted.value.copy(painted.matrix);
    for (const { part, thing } of this.shown) for (const one of thing instanceof Stand ? thing.drawn() : [thing]) this.paintOn(part, one);
    this.redraw();
  }

  private markSelected(): void {
    const marked = this.selected === null ? [] : this.shown.filter(({ part }) => part.entry === this.selected || this.also.has(part.entry));
    this.painter.marked = new Set(marked.flatMap(({ thing }) => (thing instanceof Stand ? thing.drawn() : [thing])));
    this.movable = this.header?.specimens.filter((s) => (s.entry === this.selected || this.also.has(s.entry)) && s.placed !== null) ?? [];
    this.guides.setFeet(this.movable.map((s) => s.foot));
  }

  private entryAt(x: number, y: number): number | null {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const number = this.painter.numberAt(this.camera, x, y, width, height);
    if (number >= SOWN) return number - SOWN;
    const entry = this.header?.specimens[number - 1]?.entry ?? -1;
    return entry >= 0 ? entry : null;
  }

  // ---- What the pointer may do ----

  get camera() {
    return this.eyes.camera;
  }
  holdEye(still: boolean): void {
    this.eyes.controls.enabled = !still;
  }
  handleAt(x: number, y: number): Handle | null {
    return this.guides.handleAt(x, y, this.toPixel);
  }
  cameraAt(x: number, y: number): boolean {
    if (!this.guides.cameraSeen || !this.header) return false;
    const p = this.toPixel(this.guides.cameraAt());
    return p.near && Math.hypot(p.x - x, p.y - y) < 14;
  }
  plantingAt(x: number, y: number): Planting | null {
    const found = this.movable[this.guides.footAt(x, y, this.toPixel)];
    return found ? { entry: found.entry, place: found.placed!, foot: found.foot } : null;
  }
  groundUnder(ray: Raycaster, height: number): Vector3 | null {
    const ground = this.shown.filter(({ part, thing }) => part.kind === "ground" && thing instanceof Drawn && !thing.instanced);
    const hit = ray.intersectObjects(ground.map(({ thing }) => thing as Object3D), false)[0];
    if (hit) return hit.point;
    const { origin, direction } = ray.ray;
    const way = (height - origin.y) / direction.y;
    return way > 0 && way < 1e4 ? origin.clone().addScaledVector(direction, way) : null;
  }
  click(x: number, y: number, also: boolean): void {
    this.events.picked(this.header && this.entryAt(x, y), also);
  }
  flyToCamera(): void {
    this.lookThrough(true);
  }
  get filmEye(): Vector3 {
    return new Vector3(...this.header!.camera.at);
  }
  cameraMoved(at: Vec3, done: boolean): void {
    const { camera } = this.header!;
    this.guides.setCamera(this.header!, at);
    this.changed();
    if (done) this.events.camera(at, camera.to);
  }
  keyMoved(handle: Handle, at: Vec3, done: boolean): void {
    this.guides.moveKey(handle.pointer, at);
    this.changed();
    this.events.key(handle.what, handle.pointer, at, done);
  }
  plantingMoved(planting: Planting, at: Vector3, done: boolean): void {
    this.guides.showRing(done ? null : at, 0.06 * at.distanceTo(this.camera.position));
    this.changed();
    this.events.placed(planting.entry, planting.place, at.x, at.z, done);
  }

  private toPixel = (at: Vector3): { x: number; y: number; near: boolean } => {
    spot.copy(at).project(this.camera);
    return { x: ((spot.x + 1) / 2) * this.canvas.clientWidth, y: ((1 - spot.y) / 2) * this.canvas.clientHeight, near: spot.z < 1 };
  };
}

const spot = new Vector3();
