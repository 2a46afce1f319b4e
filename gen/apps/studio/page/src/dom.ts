/** Small means to build the page: elements, icons, and waiting. */

export type Child = Node | string | null | undefined | false;
type Attributes = Record<string, unknown>;

/**
 * Makes an element. `name` may carry classes: "button.small.primary". An attribute that is a function is a listener
 * ("click"), one that is a property of the element is set as such, all others as text; null and false leave it out.
 */
export function el<T extends HTMLElement = HTMLElement>(name: string, attributes: Attributes = {}, ...children: Child[]): T {
  const [tag, ...classes] = name.split(".");
  const element = document.createElement(tag!) as T;
  if (classes.length) element.className = classes.join(" ");
  for (const [key, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (typeof value === "function") element.addEventListener(key, value as EventListener);
    else if (key in element && !key.startsWith("aria") && key !== "list") (element as unknown as Attributes)[key] = value;
    else element.setAttribute(key, value === true ? "" : String(value));
  }
  element.append(...children.filter((c): c is Node | string => c !== null && c !== undefined && c !== false));
  return element;
}

const ICONS = {
  undo: "M6 4 3 7l3 3M3 7h6a4 4 0 0 1 0 8H7",
  redo: "m10 4 3 3-3 3M13 7H7a4 4 0 0 0 0 8h2",
  add: "M8 3v10M3 8h10",
  copy: "M5.5 5.5h7v7h-7zM3.5 10.5v-7h7",
  remove: "M3 4.5h10M6.5 4.5V3h3v1.5M4.5 4.5l.6 8.5h5.8l.6-8.5M7 7v4M9 7v4",
  eye: "M1.5 8S4 3.8 8 3.8 14.5 8 14.5 8 12 12.2 8 12.2 1.5 8 1.5 8ZM8 6.2a1.8 1.8 0 1 0 0 3.6 1.8 1.8 0 0 0 0-3.6Z",
  hidden: "M2.5 2.5l11 11M4 5.2C2.4 6.4 1.5 8 1.5 8S4 12.2 8 12.2c1 0 1.9-.3 2.7-.6M7 3.9 8 3.8c4 0 6.5 4.2 6.5 4.2s-.6 1-1.7 2.1",
  solo: "M8 2v2.5M8 11.5V14M2 8h2.5M11.5 8H14M8 5.5a2.5 2.5 0 1 0 0 5 2.5 2.5 0 0 0 0-5Z",
  dice: "M3 3h10v10H3zM5.8 5.2a.6.6 0 1 0 0 1.2.6.6 0 0 0 0-1.2M8 7.4a.6.6 0 1 0 0 1.2.6.6 0 0 0 0-1.2M10.2 9.6a.6.6 0 1 0 0 1.2.6.6 0 0 0 0-1.2",
  play: "M5 3.2v9.6L12.5 8z",
  pause: "M5.5 3.5v9M10.5 3.5v9",
  camera: "M2.5 5h2.8l1-1.8h3.4l1 1.8h2.8v8h-11zM8 6.8a2.2 2.2 0 1 0 0 4.4 2.2 2.2 0 0 0 0-4.4Z",
  theme: "M8 2.5a5.5 5.5 0 1 0 0 11ZM8 2.5a5.5 5.5 0 0 1 0 11",
  search: "M7 3a4 4 0 1 0 0 8 4 4 0 0 0 0-8ZM10 10l3.5 3.5",
  open: "M6 4l4 4-4 4",
  close: "M4 4l8 8M12 4l-8 8",
  wall: "M2.5 2.5h3v3h-3zM6.5 2.5h3v3h-3zM10.5 2.5h3v3h-3zM2.5 6.5h3v3h-3zM6.5 6.5h3v3h-3zM10.5 6.5h3v3h-3zM2.5 10.5h3v3h-3zM6.5 10.5h3v3h-3zM10.5 10.5h3v3h-3z",
  lock: "M4 7.5h8V13H4zM5.5 7.5V5.3a2.5 2.5 0 0 1 5 0v2.2",
  side: "M2.5 3h11v10h-11zM10 3v10",
  sliders: "M3 4.5h10M3 8h10M3 11.5h10M6 3v3M10.5 6.5v3M5 10v3",
  select: "M4 2.5l8 5.6-3.6.7 2 3.7-1.7.9-2-3.8L4 12z",
  place: "M8 2v12M2 8h12M6.3 3.7 8 2l1.7 1.7M6.3 12.3 8 14l1.7-1.7M3.7 6.3 2 8l1.7 1.7M12.3 6.3 14 8l-1.7 1.7",
  branches: "M8 14V7M8 10 4 6.5V3M8 8l4-3V2.5M4 6.5 2.5 5M12 5l1.5.8",
  draw: "M3 13l.8-3L11 2.8 13.2 5 6 12.2zM9.6 4.2l2.2 2.2",
  paint: "M13.5 2.5 7 9M7 9c-2-.6-3.2.5-3.4 2-.1 1-.6 1.7-1.6 2 2.8 1 5.6.3 6.3-1.8.3-.9-.1-1.8-1.3-2.2Z",
  measure: "M2 10.5 10.5 2 14 5.5 5.5 14zM4.5 8l1.2 1.2M6.5 6l1.8 1.8M8.5 4l1.2 1.2",
  views: "M8 1.8 13.5 5v6L8 14.2 2.5 11V5zM2.5 5 8 8.2 13.5 5M8 8.2v6",
  more: "M3.5 8h.01M8 8h.01M12.5 8h.01",
  help: "M5.8 6a2.2 2.2 0 1 1 3.2 2c-.7.4-1 .8-1 1.6M8 12h.01M8 1.8a6.2 6.2 0 1 0 0 12.4A6.2 6.2 0 0 0 8 1.8Z",
  key: "M8 4.2 11.8 8 8 11.8 4.2 8z",
  gallery: "M2.5 3h11v10h-11zM2.5 11l3.5-4 3 3 2-2 2.5 3",
} as const;
export type IconName = keyof typeof ICONS;

/** A line drawing of 16 by 16 that takes the colour of the text. */
export function icon(name: IconName): SVGElement {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("class", "icon");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(space, "path");
  path.setAttribute("d", ICONS[name]);
  svg.append(path);
  return svg;
}

/** A button that shows only an icon; `label` is read aloud and shown as its tip. */
export function iconButton(name: IconName, label: string, click: (event: MouseEvent) => void, attributes: Attributes = {}): HTMLButtonElement {
  return el<HTMLButtonElement>("button.icon-button", { type: "button", "aria-label": label, "data-tip": label, click, ...attributes }, icon(name));
}

/** What a canvas shows, as a PNG. */
export async function pngOf(canvas: HTMLCanvasElement): Promise<Blob> {
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, "image/png"));
  if (!blob) throw new Error("The picture cannot be written");
  return blob;
}

export const sleep = (milliseconds: number): Promise<void> => new Promise((done) => setTimeout(done, milliseconds));

/** Calls `act` once things have been quiet for so long. */
export function quiet(milliseconds: number, act: () => void): { (): void; now(): void; stop(): void } {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const stop = (): void => {
    clearTimeout(timer);
    timer = undefined;
  };
  const call = (): void => {
    stop();
    timer = setTimeout(() => {
      timer = undefined;
      act();
    }, milliseconds);
  };
  return Object.assign(call, {
    stop,
    now: (): void => {
      if (timer === undefined) return;
      stop();
      act();
    },
  });
}

/** So many seconds as a person says it. */
export function spoken(seconds: number): string {
  if (seconds < 9.95) return `${seconds.toFixed(1)} s`;
  if (seconds < 90) return `${Math.round(seconds)} s`;
  if (seconds < 5400) return `${Math.round(seconds / 60)} min`;
  return `${(seconds / 3600).toFixed(1)} h`;
}

/** 12345678 as 12,345,678. */
export const grouped = (n: number): string => Math.round(n).toLocaleString("en-US");

/** Bytes as MB or GB. */
export const bytes = (n: number): string => (n < 1e9 ? `${Math.max(1, Math.round(n / 1e6))} MB` : `${(n / 1e9).toFixed(1)} GB`);
