/** Other views of the model: one beside the first, from another side; and, over the first, the preset as it was, up to a line that is dragged. */

import * as api from "../api";
import { openMenu } from "../controls/menu";
import { el, icon } from "../dom";
import type { Store } from "../store";
import { View } from "../view/view";
import { SIDES } from "../view/boxes";

const NOTHING = (): void => {};

export interface SecondViews {
  /** Beside the first view. */
  beside: HTMLElement;
  /** Over it. */
  over: HTMLElement;
  /** Opens and closes the one beside. */
  toggle(): void;
  /** Keeps the preset as it is now, to compare it with what it becomes; or ends that. */
  keep(): void;
}

/** A view that shows a text at the time that the studio shows. */
class Follower {
  readonly view: View;
  private session = crypto.randomUUID();
  private seq = 0;
  private busy = false;
  private wanted = false;
  private stop: () => void;

  constructor(
    private store: Store,
    host: HTMLElement,
    private doc: () => api.Doc,
  ) {
    this.view = new View(host, { picked: (entry) => entry !== null && store.select(entry), placed: NOTHING, key: NOTHING, camera: NOTHING, forgotten: () => void this.want() });
    let last: unknown = null;
    this.stop = store.on("scene", () => {
      const { header } = store.scene; // of each picture that came
      if (header !== last) void this.want();
      last = header;
    });
    void this.want();
  }

  /** Asks until what is shown is what was wanted last. */
  private async want(): Promise<void> {
    this.wanted = true;
    if (this.busy) return;
    this.busy = true;
    while (this.wanted) {
      this.wanted = false;
      const { store, view } = this;
      const question = { doc: this.doc(), time: store.time, have: view.have(), solo: store.solo.size ? [...store.solo] : null, hide: [...store.hidden], ask: null };
      const answer = await api.scene(this.session, ++this.seq, question).catch(() => null);
      if (answer?.is === "picture") view.show(answer.bytes);
    }
    this.busy = false;
  }

  dispose(): void {
    this.stop();
    this.wanted = false;
    this.view.dispose();
  }
}

export function secondViews(store: Store, first: View, changed: (state: { beside: boolean; kept: boolean }) => void): SecondViews {
  const host = el("div.view-host", { "data-testid": "second-view" });
  const looks = el("button", { type: "button", "aria-haspopup": "menu", "data-tip": "Where the second view looks from", "data-testid": "second-views", click: () => openMenu(looks, [
    ...(Object.keys(SIDES) as (keyof typeof SIDES)[]).map((side) => ({ label: `From the ${side}`, testid: `second:${side}`, act: () => second?.view.frame(chosen(), side) })),
    { label: "Through the camera", testid: "second:camera", act: () => second?.view.lookThrough(true) },
    { label: "Close this view", testid: "second:close", act: () => toggle() },
  ]) }, icon("views"), "Views");
  const beside = el("div.second-view", { hidden: true, role: "group", "aria-label": "Second view" }, host, el("div.stage-tools", { role: "group", "aria-label": "Second view looks from" }, looks));
  const keptHost = el("div.view-host.kept");
  const wipe = el<HTMLInputElement>("input.wipe", { type: "range", min: "0", max: "100", value: "50", "aria-label": "Where A ends and what it is now begins", "data-testid": "keep-wipe", input: () => setWipe() });
  const back = el("button.small", { type: "button", "data-tip": "The preset becomes what was kept; one step to undo", "data-testid": "back-to-a", click: () => kept !== null && store.change(kept) }, "Back to A");
  const over = el("div.compared", { hidden: true }, keptHost, wipe, el("div.cluster", {}, el("span", {}, "A | now"), back));
  let second: Follower | null = null;
  let before: Follower | null = null;
  let kept: string | null = null;

  const chosen = (): number | null => (store.picked && typeof store.selected === "number" ? store.selected : null);
  const setWipe = (): void => over.style.setProperty("--wipe", `${wipe.value}%`);
  const tell = (): void => changed({ beside: second !== null, kept: kept !== null });

  function toggle(): void {
    beside.hidden = second !== null;
    if (second) {
      second.dispose();
      second = null;
    } else {
      second = new Follower(store, host, () => store.doc);
      host.querySelector("canvas")?.setAttribute("aria-label", "The model from another side");
    }
    tell();
  }

  function keep(): void {
    over.hidden = kept !== null;
    if (kept !== null) {
      before?.dispose();
      before = kept = null;
    } else {
      kept = store.text;
      const doc = { ...store.doc };
      before = new Follower(store, keptHost, () => doc);
      keptHost.querySelector("canvas")?.setAttribute("tabindex", "-1");
      follow();
    }
    setWipe();
    tell();
  }
  const follow = (): void => before?.view.lookAs(first);
  first.onLook(follow);
  store.on("selected", () => second?.view.select(chosen(), store.also));
  store.on("opened", () => {
    if (second) toggle();
    if (kept !== null) keep();
  });
  return { beside, over, toggle, keep };
}
