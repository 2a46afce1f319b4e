import { Box3, PerspectiveCamera, Scene, Vector2, Vector3, WebGLRenderTarget, WebGLRenderer } from "three";
import { Stand } from "./copies";
import { Drawn } from "./drawn";
import { Outline } from "./outline";
import { LONGEST, Pace } from "./pace";
import { shared, type Shared } from "./shared";
import { Settle } from "./settle";
import { Shadow } from "./shadow";
import { Sky } from "./sky";

/** Machines that draw without a graphics card are spared. */
const SLOW = /swiftshader|llvmpipe|software|basic render/i;
/** Triangles of a picture while something moves, and of one at rest. */
const BUDGET = { quick: 8e6, fine: 16e6 };
const SLOW_BUDGET = { quick: 8e4, fine: 1.5e6 };
/** Pixels that may be lost where there is time enough, and where there is not: no more than are still a part of a plant. Then
 *  fewer pixels are drawn, of which as few may be lost. */
const LOST = 4;
const MOST_LOST = 16;
/** How many times fewer pixels each way a slow machine draws of what moves: where there is time enough, and where there is not. */
const SMALLER = 2;
const SMALLEST = 3;
/** What share is drawn at least. */
const LEAST_SHARE = 0.05;

/** Draws the scene in its several ways. */
export class Painter {
  readonly renderer: WebGLRenderer;
  readonly slow: boolean;
  readonly shared: Shared = shared();
  readonly world = new Scene();
  readonly over = new Scene();
  private sky: Sky;
  private shadow: Shadow;
  private settle: Settle;
  private outline: Outline;
  /** What a line is drawn round when nothing moves. */
  marked: ReadonlySet<Drawn> = new Set();
  private stands: Stand[] = [];
  private things: Drawn[] = [];
  /** Pixels that may be lost, for the budget of each mode. */
  private lost = { quick: LOST, fine: LOST };
  private bounds = new Box3();
  private shadowIsOld = true;
  private spot = new WebGLRenderTarget(1, 1, { generateMipmaps: false });
  private byte = new Uint8Array(4);
  private size = new Vector2();
  /** What is behind nothing. */
  backdrop = 0x16181a;
  private fence: WebGLSync | null = null;
  /** When the last picture was begun, and how long it took to draw, ms. */
  private began = 0;
  private took = 0;
  private pace: Pace;
  /** Triangles of the last plan, and whether it leaves nothing out. */
  private planned = 0;
  private whole = false;

  constructor(canvas: HTMLCanvasElement) {
    const probe = document.createElement("canvas").getContext("webgl2");
    if (!probe) throw new Error("This browser shows no WebGL 2 pictures");
    const info = probe.getExtension("WEBGL_debug_renderer_info");
    this.slow = SLOW.test(String(probe.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : probe.RENDERER)));
    probe.getExtension("WEBGL_lose_context")?.loseContext();
    this.pace = new Pace(this.budget.quick, this.budget.fine);
    this.renderer = new WebGLRenderer({ canvas, antialias: !this.slow, preserveDrawingBuffer: true, powerPreference: "high-performance" });
    this.renderer.autoClear = false;
    this.renderer.sortObjects = false;
    this.renderer.setPixelRatio(this.slow ? 1 : Math.min(2, devicePixelRatio));
    this.world.matrixWorldAutoUpdate = false;
    this.sky = new Sky(this.shared);
    this.shadow = new Shadow(this.renderer, this.slow ? 1024 : 2048);
    this.shared.shade.value = this.shadow.texture;
    this.settle = new Settle(this.renderer);
    this.outline = new Outline(this.renderer);
  }

  resize(width: number, height: number): void {
    this.renderer.setSize(width, height, false);
    this.renderer.getDrawingBufferSize(this.size);
    this.settle.resize(this.size.x, this.size.y);
    this.outline.resize(this.size.x, this.size.y);
  }

  /** What is drawn from now on; shadows are those of what stands in `bounds`. */
  setThings(list: (Drawn | Stand)[], bounds: Box3): void {
    this.world.clear();
    if (list.length) this.world.add(...list);
    this.stands = list.filter((one) => one instanceof Stand);
    this.things = list.flatMap((one) => (one instanceof Stand ? one.drawn() : [one]));
    this.bounds.copy(bounds);
    this.shadowIsOld = true;
  }

  /** Makes all as coarse as the mode's budget asks for; where that is not enough, some stand for all, if they are parts of
   *  an organism. */
  private plan(camera: PerspectiveCamera, mode: "quick" | "fine", budget = this.budget[mode]): void {
    const { x, y, z } = camera.position;
    const pixel = this.pixelOf(camera, this.size.y);
    const cost = (): number => {
      const grain = pixel * this.lost[mode];
      for (const stand of this.stands) stand.sort(camera, grain / LOST);
      return this.things.reduce((sum, one) => (one.visible ? sum + one.choose(grain * one.distance(x, y, z)) : sum), 0);
    };
    let sum = cost();
    if (sum < budget / 4 && this.lost[mode] > LOST) {
      this.lost[mode] = LOST;
      sum = cost();
    }
    for (; sum > budget && this.lost[mode] < MOST_LOST; sum = cost()) this.lost[mode] *= 1.6;
    const mayGo = (one: Drawn): boolean => one.thinned && one.parent === this.world;
    const thinnable = this.things.reduce((sum, one) => (mayGo(one) && one.visible ? sum + one.triangles : sum), 0);
    // What cannot be thinned must not make all else too few to be told for what it is.
    const share = Math.min(1, Math.max(LEAST_SHARE, Math.max(budget - (sum - thinnable), budget / 2) / Math.max(1, thinnable)));
    this.planned = Math.min(sum, budget);
    this.whole = share === 1 && this.lost[mode] <= LOST;
    for (const one of this.things) one.thin(mayGo(one) ? share : 1);
  }

  private get budget(): typeof BUDGET {
    return this.slow ? SLOW_BUDGET : BUDGET;
  }

  /** How many pictures make a settled one: where each takes long, few. */
  private get enough(): number {
    const most = this.slow ? 8 : 16;
    return this.took > LONGEST ? 2 : most;
  }

  /** The picture at rest is made anew. */
  again(): void {
    this.settle.count = 0;
  }

  /** How much of the picture at rest there is, 0..1. */
  get settled(): number {
    return this.settle.count / this.enough;
  }

  /** Draws at once. */
  draw(camera: PerspectiveCamera): void {
    this.settle.count = 0;
    this.plan(camera, "quick");
    if (this.shadowIsOld && !this.slow) this.shade();
    this.renderer.setRenderTarget(null);
    const smaller = Math.min(SMALLEST, Math.max(SMALLER, Math.ceil(this.lost.quick / LOST)));
    if (this.slow) this.settle.roughly(smaller, () => this.look(camera, 0.5, true));
    else this.look(camera, 0.4, true);
    this.mark();
  }

  /** Makes the picture at rest finer; whether there is more to come. */
  refine(camera: PerspectiveCamera): boolean {
    if (this.settle.count === 1 && this.pace.finer(this.took, this.planned, this.whole)) this.settle.count = 0;
    if (this.settle.count === 0) this.plan(camera, "fine", this.pace.triangles);
    return this.add(camera);
  }

  /** Draws the picture at rest at once, however long that takes. */
  finely(camera: PerspectiveCamera, pictures: number): void {
    this.settle.count = 0;
    this.plan(camera, "fine");
    while (this.add(camera) && this.settle.count < pictures) {
      // One more.
    }
  }

  /** Adds a picture to the one at rest; whether there is more to come. */
  private add(camera: PerspectiveCamera): boolean {
    if (this.shadowIsOld) {
      this.shade();
      this.mark();
      return true;
    }
    if (this.settle.count === 0 && this.marked.size) this.takeOutline(camera);
    const [x, y] = Settle.shift(this.settle.count);
    const lens = camera.projectionMatrix.elements;
    const [wasX, wasY] = [lens[8]!, lens[9]!];
    lens[8]! += (2 * x) / this.size.x;
    lens[9]! += (2 * y) / this.size.y;
    this.shared.grain.value = this.settle.count;
    this.settle.step(() => this.look(camera, 0.2, false));
    lens[8] = wasX;
    lens[9] = wasY;
    if (this.marked.size) this.outline.paint();
    this.mark();
    return this.settle.count < this.enough;
  }

  private takeOutline(camera: PerspectiveCamera): void {
    this.flat(false, false);
    for (const one of this.things) one.visible &&= this.marked.has(one);
    this.shared.mask.value = 1;
    this.setEye(camera, this.size.y, 0.2);
    this.outline.take(() => this.renderer.render(this.world, camera));
    this.shared.mask.value = 0;
    this.unflat();
  }

  private shade(): void {
    this.shadowIsOld = false;
    this.shared.shade_texel.value = 0;
    if (this.bounds.isEmpty()) return;
    this.flat(true, true);
    this.shadow.draw(this.world, this.bounds, this.shared);
    this.unflat();
  }

  private look(camera: PerspectiveCamera, thin: number, quickly: boolean): void {
    for (const one of this.things) one.wear(false, quickly);
    this.setEye(camera, this.size.y, thin);
    this.renderer.setClearColor(this.backdrop, 1);
    this.renderer.clear();
    this.renderer.setClearColor(0, 0);
    this.renderer.render(this.world, camera);
    if (this.things.length) this.renderer.render(this.sky, camera);
    this.renderer.render(this.over, camera);
  }

  /** Sets all to be drawn flat; for the sun only what throws shadows. */
  private flat(forSun: boolean, quickly: boolean): void {
    for (const stand of this.stands) stand.forSun(forSun);
    for (const one of this.things) {
      one.wear(true, quickly);
      if (one.parent === this.world) one.visible = !forSun || one.casts;
    }
  }
  private unflat(): void {
    for (const stand of this.stands) stand.forSun(false);
    for (const one of this.things) if (one.parent === this.world) one.visible = true;
  }

  /** The number of what is under a pixel (of the page); 0: nothing. */
  numberAt(camera: PerspectiveCamera, x: number, y: number, width: number, height: number): number {
    this.flat(false, true);
    this.shared.mask.value = 0;
    camera.setViewOffset(width, height, x, y, 1, 1);
    camera.updateProjectionMatrix();
    this.setEye(camera, 1, 0.4);
    this.shared.pixel.value = this.pixelOf(camera, 1);
    this.renderer.setRenderTarget(this.spot);
    this.renderer.setClearColor(0, 0);
    this.renderer.clear();
    this.renderer.render(this.world, camera);
    this.renderer.readRenderTargetPixels(this.spot, 0, 0, 1, 1, this.byte);
    this.renderer.setRenderTarget(null);
    camera.clearViewOffset();
    this.unflat();
    const [a, b, c] = this.byte;
    return a! + (b! << 8) + (c! << 16);
  }

  /** Organisms white on black, without the ground, as RGBA bytes from the lowest row up; `quickly`: as they are drawn while
   *  something moves. */
  mask(camera: PerspectiveCamera, width: number, height: number, quickly: boolean): Uint8Array {
    const target = new WebGLRenderTarget(width, height, { generateMipmaps: false });
    if (quickly) this.plan(camera, "quick");
    else {
      for (const stand of this.stands) stand.sort(camera, this.pixelOf(camera, height));
      for (const one of this.things) one.choose(0), one.thin(1);
    }
    this.flat(false, quickly);
    for (const one of this.things) one.visible &&= !one.isGround;
    this.shared.mask.value = 1;
    this.setEye(camera, height, quickly ? 0.5 : 0);
    this.renderer.setRenderTarget(target);
    this.renderer.setClearColor(0, 1);
    this.renderer.clear();
    this.renderer.render(this.world, camera);
    const pixels = new Uint8Array(4 * width * height);
    this.renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
    this.renderer.setRenderTarget(null);
    target.dispose();
    this.shared.mask.value = 0;
    this.unflat();
    return pixels;
  }

  /** The graphics card has lost what it held. */
  forget(): void {
    this.setThings([], new Box3());
    this.fence = null;
  }

  /** Whether the graphics card still draws the last picture: a next one would wait behind it. */
  get busy(): boolean {
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    if (this.fence && gl.getSyncParameter(this.fence, gl.SYNC_STATUS) === gl.SIGNALED) {
      gl.deleteSync(this.fence);
      this.fence = null;
      this.took = performance.now() - this.began;
    }
    return this.fence !== null;
  }
  private mark(): void {
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    if (this.fence) gl.deleteSync(this.fence);
    this.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.began = performance.now();
    gl.flush();
  }

  /** Waits until the graphics card has drawn what it was told. */
  finish(): void {
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, this.byte);
  }

  /** Metres that a pixel covers a metre away. */
  pixelOf(camera: PerspectiveCamera, height: number): number {
    return 2 / (camera.projectionMatrix.elements[5]! * height);
  }
  private setEye(camera: PerspectiveCamera, height: number, thin: number): void {
    const at = camera.getWorldPosition(where);
    this.shared.eye.value.set(at.x, at.y, at.z, 1);
    this.shared.pixel.value = this.pixelOf(camera, height);
    this.shared.thin.value = thin;
  }

  dispose(): void {
    this.sky.dispose();
    this.shadow.dispose();
    this.settle.dispose();
    this.outline.dispose();
    this.spot.dispose();
    this.renderer.dispose();
  }
}

const where = new Vector3();
