/** The view of the model, what is said over it, and what is dragged in it. */

import { Binding } from "../controls/binding";
import { openMenu, type MenuItem } from "../controls/menu";
import { keysOf } from "../keyframes";
import { vectorOf } from "../controls/vector";
import { bytes, el, grouped, icon, spoken } from "../dom";
import { fromPointer, getAt, isObject, toPointer, type Path } from "../pointer";
import { rounded } from "../rounding";
import { SceneLoop } from "../scene_loop";
import type { Store } from "../store";
import type { Vec3 } from "../view/header";
import { View, type Path as DragPath } from "../view/view";
import { addOrganism } from "./add_organism";
import { ask } from "./dialogs";
import { docLink, nextStep } from "./help";
import { secondViews } from "./second_view";
import { setCamera } from "./set_camera";
import { onTheme } from "./theme";
import { together } from "./together";
import { tools, type Tools } from "./tools";

type StageLooks = Record<"frame" | "front" | "side" | "top" | "home", () => void>;
const VIEWS: [keyof StageLooks, string, string][] = [
  ["frame", "Frame what is selected", "F"],
  ["front", "From the front", "1"],
  ["side", "From the side", "3"],
  ["top", "From above", "7"],
  ["home", "Home, where the camera stands", "Home"],
];

/** Metres that a key moves what is selected. */
const NUDGE = 0.1;

export interface Stage {
  element: HTMLElement;
  /** Another view, beside it. */
  beside: HTMLElement;
  looks: StageLooks;
  loop: SceneLoop;
  view: View;
  tools: Tools;
  toggleCamera(): void;
}

export function stage(store: Store): Stage {
  const host = el("div.view-host", { "data-testid": "view" });
  const figures = el("p.scene-figures", { role: "status", "data-testid": "scene-status" });
  const look = el("button", { type: "button", "aria-pressed": "false", "data-tip": "Look through the preset's camera (C)", "data-testid": "look-through", click: () => toggleCamera() }, icon("camera"), "Camera");
  const menu = el("button", { type: "button", "aria-haspopup": "menu", "data-tip": "Where one looks from, a second view, and what it was before", "data-testid": "views", click: () => openMenu(menu, viewItems()) }, icon("views"), "Views");
  const viewItems = (): MenuItem[] => [
    ...VIEWS.map(([name, label, key]): MenuItem => ({ label, key, act: looks[name], testid: `view:${name}` })),
    { label: "Set the camera to this view", tip: "Puts the preset's camera where you look from now", testid: "set-camera", act: () => {
      const { at, to } = view.eye();
      setCamera(store, at, to);
    } },
    { label: "Two views", tip: "A second view beside this one, from another side", toggles: true, checked: beside, testid: "two-views", act: () => others.toggle() },
    { label: "Keep as A", tip: "Keeps the preset as it is now, and shows it beside what you make of it", toggles: true, checked: kept, testid: "keep-a", act: () => others.keep() },
  ];
  let [beside, kept] = [false, false];
  const chosen = (): number | null => (store.picked && typeof store.selected === "number" ? store.selected : null);
  const looks: StageLooks = { frame: () => view.frame(chosen()), front: () => view.frame(chosen(), "front"), side: () => view.frame(chosen(), "side"), top: () => view.frame(chosen(), "top"), home: () => view.home() };
  const finer = el<HTMLProgressElement>("progress.finer", { max: 1, hidden: true, "aria-label": "The picture becomes finer", "data-tip": "The picture becomes finer", "data-testid": "refining" });
  const over = el("div.over", { hidden: true, "data-testid": "estimate" });
  const nothing = el("div.over.nothing", { hidden: true, "data-testid": "nothing" }, nextStep("Nothing grows here yet. Add a plant, a coral or a wall, and shape it at the side; or drag one from the library.", docLink("tutorial.md", "An hour by hand"), ["Add an organism …", () => void addOrganism(store)]));
  const bar = el<HTMLProgressElement>("progress", { max: 1, "aria-label": "Organisms that have grown" });
  const growing = el("div.growing", { hidden: true, "data-testid": "growing" }, bar, el("button.small", { type: "button", "data-testid": "stop-growing", click: () => loop.stop() }, "Stop"));
  const element = el("section.stage", { "aria-label": "View of the model" }, host, growing, el("div.stage-tools", { role: "group", "aria-label": "Camera" }, menu, look), over, nothing, el("div.stage-said", {}, figures, finer));
  let through = false;

  const moving = together(store);
  const view = new View(host, {
    picked: (entry, also) => entry !== null && (also ? store.selectAlso(entry) : store.select(entry)),
    placed: moving.to,
    key: (_what, pointer, at, done) => {
      store.set(fromPointer(pointer), rounded(at), pointer);
      if (done) store.endGesture();
    },
    camera: (at, to) => setCamera(store, at, to),
    forgotten: () => loop.want(),
    through: (on) => showThrough(on),
    refining: (share) => {
      finer.hidden = share >= 1;
      if (share < 1) finer.value = share;
    },
  });
  const others = secondViews(store, view, (state) => ({ beside, kept } = state));
  host.after(others.over);
  const loop = new SceneLoop(store, view);
  const hands = tools(store, view);
  element.append(hands.element);
  view.onKey((event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!step || !event.altKey || !store.chosen.length) return false;
    const far = event.shiftKey ? 1 : NUDGE;
    moving.by(far * step[0]!, far * step[1]!);
    return true;
  });

  function toggleCamera(): void {
    view.lookThrough(!through);
  }
  function showThrough(on: boolean): void {
    through = on;
    look.setAttribute("aria-pressed", String(on));
  }
  const showFigures = (): void => {
    const { header, busy, took, estimate, stopped, growing: soFar } = store.scene;
    const faults = store.faults.length;
    element.classList.toggle("busy", busy);
    element.classList.toggle("wrong", faults > 0);
    // Words that change with each picture would be read aloud without end.
    figures.setAttribute("aria-live", faults ? "polite" : "off");
    figures.textContent = faults ? `${faults === 1 ? "A problem keeps" : `${faults} problems keep`} the picture as it was` : soFar ? (soFar.of ? `Growing, ${soFar.done} of ${soFar.of} …` : "Growing …") : header ? summary(header.nodes, header.copies, took) : busy ? "Growing …" : "";
    over.hidden = estimate === null && !stopped;
    if (stopped) over.replaceChildren(el("span", {}, "Stopped: not all has grown."), el("button", { type: "button", "data-testid": "grow-on", click: () => loop.agree() }, "Grow it"));
    growing.hidden = soFar === null;
    if (soFar) bar.value = soFar.of ? soFar.done / soFar.of : 0;
  };
  const summary = (nodes: number, copies: number, took: number): string =>
    [nodes ? `${grouped(nodes)} nodes` : "", copies ? `${grouped(copies)} copies` : "", spoken(took)].filter(Boolean).join(" · ");

  let asking = false;
  const askIfLong = async (): Promise<void> => {
    const { estimate } = store.scene;
    if (!estimate || asking) return;
    asking = true;
    const about = `about ${spoken(estimate.seconds)} and ${bytes(estimate.memory)} of memory`;
    // The land itself may take long, without a node.
    const text = estimate.nodes ? `${grouped(estimate.nodes)} nodes: ${about}.` : `The land and what lies on it: ${about}.`;
    const answer = await ask("This would take long to grow", text, [{ value: "no", label: "Not now" }, { value: "grow", label: "Grow it", primary: true }], "long");
    asking = false;
    if (answer === "grow") return loop.agree();
    const again = el("button", { type: "button", click: () => loop.agree() }, "Grow it");
    over.replaceChildren(el("span", {}, `Not grown yet: ${text}`), again);
  };

  store.on("scene", () => {
    showFigures();
    void askIfLong();
    // What was added may stand anywhere.
    const drawn = store.added === null ? undefined : store.scene.header?.entries[store.added];
    if (!drawn || store.scene.header?.missing.includes(store.added!) || drawn.specimens + drawn.copies === 0) return;
    view.frame(store.added);
    store.added = null;
  });
  store.on("opened", () => {
    view.lookThrough(false);
    view.clear();
  });
  store.on(["text", "opened"], () => (nothing.hidden = !store.isOpen || store.preset.syntax.length > 0 || store.preset.organisms.length > 0));
  let drawn = "[]";
  const drawPaths = (): void => {
    const paths = pathsOf(store);
    const way = store.selected === "scene" && movesOf(store);
    const now = JSON.stringify([paths, way]);
    if (now !== drawn) view.paths(paths, way);
    drawn = now;
  };
  store.on(["text", "selected", "opened"], () => {
    drawPaths();
    view.select(chosen(), store.also);
  });
  onTheme((dark) => view.theme(dark));
  return { element, beside: others.beside, looks, loop, view, tools: hands, toggleCamera };
}

/** Is the camera's way another than that through its keys? */
function movesOf(store: Store): boolean {
  const camera = getAt(store.preset.whole, ["scene", "camera"]);
  return isObject(camera) && (camera.follow === true || camera.fit !== undefined || camera.compose !== undefined || (isObject(camera.move) && (camera.move.orbit !== undefined || camera.move.rail !== undefined)));
}

const CAMERA_PATHS: Path[] = [["location"], ["look_at"], ["move", "rail", "to"], ["move", "orbit", "center"]];

/** What can be dragged along its way: the food of what is selected, and with the scene the camera. */
function pathsOf(store: Store): DragPath[] {
  const { selected } = store;
  if (selected === "scene") {
    if (getAt(store.preset.whole, ["scene", "camera", "follow"]) === true) return [];
    return CAMERA_PATHS.map((path) => pathAt(store, "camera", ["scene", "camera", ...path])).filter((p) => p !== null);
  }
  const entry = typeof selected === "number" && store.schema.kind(store.preset.kindOf(selected)).fields.has("food") ? selected : null;
  const path: Path = entry === null ? ["defaults", "food", "position"] : new Binding(store, entry, ["food", "position"]).path;
  return [pathAt(store, "food", path)].filter((p) => p !== null);
}

function pathAt(store: Store, what: "food" | "camera", path: Path): DragPath | null {
  const value = getAt(store.preset.whole, path);
  const keys = keysOf(value);
  const pointer = toPointer(path);
  if (keys) return { what, pointer, keys: keys.map(([t, at, shape], i) => ({ t, at: vectorOf(at, 3) as Vec3, shape, pointer: `${pointer}/${i}/1` })) };
  return Array.isArray(value) ? { what, pointer, keys: [{ t: 0, at: vectorOf(value, 3) as Vec3, pointer }] } : null;
}
