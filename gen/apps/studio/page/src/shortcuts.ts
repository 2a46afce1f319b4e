/** Keys that count everywhere. */

import type { ToolName } from "./panels/tools";

const TOOLS: Record<string, ToolName> = { v: "select", p: "place", b: "branches", d: "draw", k: "paint", m: "measure" };

export interface Shortcuts {
  undo(): void;
  redo(): void;
  save(): void;
  saveAs(): void;
  play(): void;
  camera(): void;
  search(): void;
  frame(): void;
  front(): void;
  side(): void;
  top(): void;
  home(): void;
  tool(name: ToolName): void;
  help(): void;
}

const isText = (target: EventTarget | null): boolean =>
  target instanceof HTMLElement && target.matches("input:not([type=range], [type=checkbox], [type=color]), textarea, select");

export function listenToKeys(acts: Shortcuts): void {
  addEventListener("keydown", (event) => {
    if (event.defaultPrevented || document.querySelector("dialog[open]")) return;
    const act = event.ctrlKey || event.metaKey ? withControl(event, acts) : plain(event, acts);
    if (!act) return;
    event.preventDefault();
    act();
  });
}

function withControl(event: KeyboardEvent, acts: Shortcuts): (() => void) | undefined {
  const key = event.key.toLowerCase();
  if (key === "z") return event.shiftKey ? acts.redo : acts.undo;
  if (key === "y") return acts.redo;
  if (key === "s") return event.shiftKey ? acts.saveAs : acts.save;
  return undefined;
}

function plain(event: KeyboardEvent, acts: Shortcuts): (() => void) | undefined {
  if (isText(event.target) || event.altKey) return undefined;
  const isButton = event.target instanceof HTMLElement && event.target.closest("button, summary, [role=menuitem], a");
  if (event.key === " " && !isButton) return acts.play;
  if (event.key === "c") return acts.camera;
  if (event.key === "/") return acts.search;
  if (event.key === "?") return acts.help;
  const tool = TOOLS[event.key];
  if (tool) return () => acts.tool(tool);
  const look = ({ f: acts.frame, "1": acts.front, "3": acts.side, "7": acts.top } as Record<string, (() => void) | undefined>)[event.key];
  if (look) return look;
  // In sliders, lists and tabs Home is the first of them.
  if (event.key === "Home" && !(event.target instanceof HTMLElement && event.target.closest("input, select, [role=tablist], [role=menu], [tabindex='0']:not(canvas)"))) return acts.home;
  return undefined;
}
