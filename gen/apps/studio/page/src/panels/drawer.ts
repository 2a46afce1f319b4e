/** The drawer below the view: tabs that open and close it, and an edge to draw it by. */

import { el } from "../dom";

export interface Tab {
  name: string;
  label: string;
  element: HTMLElement;
  opened?(): void;
  closed?(): void;
}

export interface Drawer {
  element: HTMLElement;
  open(name: string): void;
  close(): void;
  current(): string | null;
  badge(name: string, text: string, wrong?: boolean): void;
}

const KEY = "frond.drawer";

/** Pixels above and below the drawer that are left to all else; and of a narrow window, where it lies over nothing else,
 *  the share that the view keeps. */
const REST = 260;
const VIEW = 0.4;
const LEAST = 120;

/** `opening` is called before a tab shows itself. */
export function drawer(tabs: Tab[], opening: () => void = () => undefined): Drawer {
  let current: string | null = null;
  let height = Number(localStorage.getItem(KEY)) || 260;
  const buttons = tabs.map((tab) =>
    el<HTMLButtonElement>("button.tab", { type: "button", role: "tab", id: `tab-${tab.name}`, "aria-controls": `panel-${tab.name}`, "data-testid": `tab:${tab.name}`, click: () => (current === tab.name ? close() : open(tab.name)) },
      tab.label, el("span.badge", { hidden: true })),
  );
  const panels = tabs.map((tab) => el("div.panel", { role: "tabpanel", id: `panel-${tab.name}`, "aria-labelledby": `tab-${tab.name}`, hidden: true }, tab.element));
  const edge = el("div.edge", { role: "separator", tabIndex: 0, "aria-label": "Height of the drawer", "aria-orientation": "horizontal", "aria-valuemin": 120, "aria-valuemax": 640, hidden: true });
  const body = el("div.drawer-body", {}, ...panels);
  const element = el("section.drawer", { "aria-label": "Drawer" }, edge, el("div.tabs", { role: "tablist", "aria-label": "Drawer" }, ...buttons), body);

  /** What the view may give up: on phones its bar, the time and the tabs take of it as well. */
  const most = (): number => {
    if (!matchMedia("(max-width: 640px)").matches) return innerHeight - REST;
    const view = document.querySelector(".pictures-row")?.clientHeight ?? 0;
    return view + (current ? body.clientHeight : 0) - Math.ceil(VIEW * innerHeight);
  };
  const setHeight = (wanted: number): void => {
    height = Math.round(Math.max(LEAST, Math.min(wanted, most())));
    localStorage.setItem(KEY, String(height));
    show();
  };
  const show = (): void => {
    body.style.height = current ? `${height}px` : "0";
    element.classList.toggle("open", current !== null);
    edge.hidden = current === null;
    edge.setAttribute("aria-valuenow", String(height));
    tabs.forEach((tab, i) => {
      const chosen = tab.name === current;
      buttons[i]!.setAttribute("aria-selected", String(chosen));
      buttons[i]!.tabIndex = chosen || (!current && i === 0) ? 0 : -1;
      panels[i]!.hidden = !chosen;
    });
  };
  const left = (): void => tabs.find((t) => t.name === current)?.closed?.();
  const open = (name: string): void => {
    if (name !== current) left();
    if (!current) opening();
    current = name;
    height = Math.max(LEAST, Math.min(height, most()));
    show();
    tabs.find((t) => t.name === name)?.opened?.();
  };
  const close = (): void => {
    left();
    current = null;
    show();
  };

  element.querySelector(".tabs")!.addEventListener("keydown", (event) => {
    const { key } = event as KeyboardEvent;
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
    const next = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: buttons.length - 1 }[key];
    if (next === undefined) return;
    event.preventDefault();
    const to = (next + buttons.length) % buttons.length;
    buttons[to]!.focus();
    if (current) open(tabs[to]!.name);
    else buttons.forEach((b, i) => (b.tabIndex = i === to ? 0 : -1));
  });
  edge.addEventListener("pointerdown", (event) => {
    edge.setPointerCapture(event.pointerId);
    const begin = event.clientY + height;
    const move = (e: PointerEvent): void => setHeight(begin - e.clientY);
    edge.addEventListener("pointermove", move);
    edge.addEventListener("pointerup", () => edge.removeEventListener("pointermove", move), { once: true });
  });
  edge.addEventListener("keydown", (event) => {
    const step = { ArrowUp: 24, ArrowDown: -24 }[event.key];
    if (!step) return;
    event.preventDefault();
    setHeight(height + step);
  });
  // As where a phone is turned.
  addEventListener("resize", () => {
    if (!current) return;
    height = Math.max(LEAST, Math.min(height, most()));
    show();
  });
  show();
  return {
    element,
    open,
    close,
    current: () => current,
    badge(name, text, wrong = false): void {
      const badge = buttons[tabs.findIndex((t) => t.name === name)]!.querySelector<HTMLElement>(".badge")!;
      badge.textContent = text;
      badge.hidden = !text;
      badge.classList.toggle("wrong", wrong);
    },
  };
}
