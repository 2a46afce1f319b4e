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
  copy: "M5.5 5.5h7v7h-7zM3.500 10.500v-7h7",
  remove: "M3 4.500h10M6.500 4.500V3h3v1.500M4.500 4.500l.6 8.500h5.800l.6-8.500M7 7v4M9 7v4",
  eye: "M1.500 8S4 3.800 8 3.800 14.500 8 14.500 8 12 12.200 8 12.200 1.500 8 1.500 8ZM8 6.200a1.800 1.800 0 1 0 0 3.600 1.800 1.800 0 0 0 0-3.600Z",
  hidden: "M2.500 2.500l11 11M4 5.200C2.400 6.400 1.500 8 1.500 8S4 12.200 8 12.200c1 0 1.900-.3 2.700-.6M7 3.900 8 3.800c4 0 6.500 4.200 6.500 4.200s-.6 1-1.700 2.100",
  solo: "M8 2v2.500M8 11.500V14M2 8h2.500M11.500 8H14M8 5.500a2.500 2.500 0 1 0 0 5 2.500 2.500 0 0 0 0-5Z",
  dice: "M3 3h10v10H3zM5.800 5.800h.01M10.200 5.800h.01M8 8h.01M5.800 10.200h.01M10.200 10.200h.01",
  play: "M5 3.200v9.600L12.500 8z",
  pause: "M5.500 3.500v9M10.500 3.500v9",
  camera: "M2.500 5h2.800l1-1.800h3.400l1 1.800h2.800v8h-11zM8 6.800a2.200 2.200 0 1 0 0 4.400 2.200 2.200 0 0 0 0-4.400Z",
  theme: "M8 2.500a5.500 5.500 0 1 0 0 11ZM8 2.500a5.500 5.500 0 0 1 0 11",
  search: "M7 3a4 4 0 1 0 0 8 4 4 0 0 0 0-8ZM10 10l3.500 3.500",
  open: "M6 4l4 4-4 4",
  close: "M4 4l8 8M12 4l-8 8",
  wall: "M2.500 2.500h3v3h-3zM6.500 2.500h3v3h-3zM10.500 2.500h3v3h-3zM2.500 6.500h3v3h-3zM6.500 6.500h3v3h-3zM10.500 6.500h3v3h-3zM2.500 10.500h3v3h-3zM6.500 10.500h3v3h-3zM10.500 10.500h3v3h-3z",
  lock: "M4 7.500h8V13H4zM5.500 7.500V5.300a2.500 2.500 0 0 1 5 0v2.200",
  side: "M2.500 3h11v10h-11zM10 3v10",
  sliders: "M3 4.500h10M3 8h10M3 11.500h10M6 3v3M10.500 6.500v3M5 10v3",
  gallery: "M2.500 3h11v10h-11zM2.500 11l3.500-4 3 3 2-2 2.500 3",
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
