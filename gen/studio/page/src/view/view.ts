import type { Header } from "./header";

/** What a person did in the view. */
export interface ViewEvents {
  picked(entry: number | null): void;
  placed(entry: number, placeIndex: number, x: number, z: number, done: boolean): void;
  key(what: "food" | "camera", pointer: string, at: [number, number, number], done: boolean): void;
  /** The eye came to rest somewhere else. */
  camera(at: [number, number, number], to: [number, number, number]): void;
  dropped?(file: File): void;
}

/** A path that can be dragged: its keys, each with the JSON pointer of its vector. */
export interface Path {
  what: "food" | "camera";
  pointer: string;
  keys: { t: number; at: [number, number, number]; pointer: string }[];
}

/** A stand-in for the 3D view: it tells what it was sent. */
export class View {
  private canvas = document.createElement("canvas");
  private header: Header | null = null;

  constructor(
    private host: HTMLElement,
    _events: ViewEvents,
  ) {
    this.host.append(this.canvas);
    this.resize();
  }

  show(answer: ArrayBuffer): Header {
    const size = new DataView(answer).getUint32(4, true);
    this.header = JSON.parse(new TextDecoder().decode(new Uint8Array(answer, 8, size))) as Header;
    this.draw();
    return this.header;
  }

  have(): string[] {
    return [];
  }
  select(_entry: number | null): void {}
  paths(_list: Path[]): void {}
  lookThrough(_on: boolean): void {}
  eye(): { at: [number, number, number]; to: [number, number, number] } {
    return { at: [0, 1, 5], to: [0, 0, 0] };
  }
  async drawn(): Promise<void> {
    await new Promise(requestAnimationFrame);
  }
  theme(_dark: boolean): void {}
  resize(): void {
    this.canvas.width = this.host.clientWidth;
    this.canvas.height = this.host.clientHeight;
    this.draw();
  }
  dispose(): void {
    this.canvas.remove();
  }

  private draw(): void {
    const pen = this.canvas.getContext("2d");
    if (!pen || !this.header) return;
    const { width, height } = this.canvas;
    const sky = this.header.light.sky.map((c) => Math.round(255 * c ** (1 / 2.2)));
    pen.fillStyle = `rgb(${sky.join(",")})`;
    pen.fillRect(0, 0, width, height);
    pen.fillStyle = "#fff";
    pen.fillText(`${this.header.nodes} nodes at ${this.header.time} s`, 12, height - 12);
  }
}
