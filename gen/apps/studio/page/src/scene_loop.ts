/**
 * Asks for pictures of the model. What a person changes comes first: just the organisms that are changed, roughly where
 * they take long, among the others as they were. Then, when nothing is changed for a moment, all of it. While the whole
 * grows, what has grown so far is shown; a change ends the wait for it. A drag never queues.
 */

import * as api from "./api";
import { sleep } from "./dom";
import { changedOrganisms, grownFrom, type GrownFrom } from "./changes";
import type { Store } from "./store";
import type { Header } from "./view/header";
import type { View } from "./view/view";

/** What takes longer than so many seconds is asked first. */
const PATIENCE = 8;
/** The same for what is more nodes than that, which are sent and drawn after they have grown. */
const MOST_NODES = 1.5e6;
/** An organism that takes longer than so many seconds grows roughly while it is changed: in about so many, or in this share of its time where that is more. */
const QUICK = 0.2;
const LEAST_SHARE = 1 / 32;
/** So long nothing is changed before the whole is grown, ms. */
const CALM = 300;
/** How soon, and how often, is looked what has grown so far, ms; a look takes at most this share of the time. */
const FIRST_LOOK = 250;
const LOOK = 700;
const SHARE = 0.25;

export class SceneLoop {
  private session = crypto.randomUUID();
  private seq = 0;
  private seqSoFar = 0;
  private running = false;
  private wanted = false;
  private patience = PATIENCE;
  private most = MOST_NODES;
  private waiting: (() => void)[] = [];
  /** The question() of the last request. */
  private asked = "";
  /** What the last picture of all grew from. */
  private grown: GrownFrom | null = null;
  /** Seconds that organisms took to grow, with what grew along. */
  private took = new Map<number, number>();
  /** The request for the whole that is under way. */
  private whole: AbortController | null = null;

  constructor(
    private store: Store,
    private view: View,
  ) {
    store.on("opened", () => {
      this.leave();
      this.patience = PATIENCE;
      this.most = MOST_NODES;
      this.session = crypto.randomUUID();
      this.grown = null;
      this.asked = ""; // the same preset opened once more is a new question: the view was cleared
      this.took.clear();
    });
    store.on(["text", "time", "shown"], () => this.question() !== this.asked && this.want());
    store.on("text", () => this.question() !== this.asked && this.leave());
  }

  /** What a picture depends on. More may be known of the same text, which does not change its picture. */
  private question(): string {
    const { text, file, time, solo, hidden } = this.store;
    return JSON.stringify([text, file, time, [...solo], [...hidden]]);
  }

  want(): void {
    this.wanted = true;
    if (!this.running) void this.run();
  }

  /** Resolves when what is shown now is what is wanted. */
  settled(): Promise<void> {
    return this.running || this.wanted ? new Promise((done) => this.waiting.push(done)) : Promise.resolve();
  }

  /** The person agreed to wait: so long from now on. */
  agree(): void {
    this.patience = Math.max(this.patience, 1.5 * (this.store.scene.estimate?.seconds ?? 0));
    this.most = Math.max(this.most, 1.5 * (this.store.scene.estimate?.nodes ?? 0));
    this.store.setScene({ estimate: null, stopped: false });
    this.want();
  }

  /** The person does not want to wait for the rest. */
  stop(): void {
    this.store.setScene({ stopped: true });
    this.leave();
  }

  /** The whole need not grow on. */
  private leave(): void {
    if (!this.whole) return;
    this.whole.abort();
    void api.leaveScene(this.session, this.seq).catch(() => undefined);
  }

  private async run(): Promise<void> {
    this.running = true;
    while (this.wanted) {
      this.wanted = false;
      if (this.store.isOpen) await this.ask().catch((error: unknown) => this.fail(error));
    }
    this.running = false;
    for (const done of this.waiting.splice(0)) done();
  }

  private async ask(): Promise<void> {
    const { store } = this;
    if (store.preset.syntax.length) return store.setScene({ busy: false, errors: [], notes: [] });
    store.setScene({ busy: true, stopped: false });
    this.asked = this.question();
    const from = grownFrom(store.preset);
    const changed = changedOrganisms(this.grown, from);
    if (changed.length) {
      const begin = performance.now();
      const took = Math.max(...changed.map((entry) => this.took.get(entry) ?? 0));
      const share = Math.min(1, Math.max(LEAST_SHARE, 2 ** Math.floor(Math.log2(QUICK / took)))); // few values, whose pictures are kept
      const header = await this.picture({ only: changed, share }, begin);
      if (header && !header.missing.length && !header.coarse) this.grown = from;
      if (!header || this.wanted || this.grown === from) return;
      await sleep(CALM);
      if (this.wanted) return;
    }
    if (await this.askWhole()) this.grown = from;
  }

  /** The whole, with what there is of it meanwhile. */
  private async askWhole(): Promise<Header | null> {
    const begin = performance.now();
    this.whole = new AbortController();
    let over = false;
    void this.lookOn(() => over);
    try {
      return await this.picture({}, begin);
    } finally {
      over = true;
      this.whole = null;
      this.store.setScene({ growing: null });
    }
  }

  /** Shows how far it is, and, where nothing was shown of the preset yet, what has grown. */
  private async lookOn(over: () => boolean): Promise<void> {
    const session = this.session;
    const partial = this.grown === null;
    let seen = -1;
    for (let pause = FIRST_LOOK; ; ) {
      await sleep(pause);
      if (over() || session !== this.session) return;
      const begin = performance.now();
      try {
        const growing = await api.sceneProgress(session);
        if (over() || session !== this.session) return;
        this.store.setScene({ growing });
        if (partial && growing.done !== seen) await this.look(over);
        seen = growing.done;
      } catch {
        return; // the request for the whole tells
      }
      pause = Math.max(LOOK, (performance.now() - begin) / SHARE);
    }
  }

  /** A picture of what has grown so far. */
  private async look(over: () => boolean): Promise<void> {
    const session = this.session;
    const answer = await api.scene(`${session}-so-far`, ++this.seqSoFar, { ...this.request(), only: [], ask: null });
    if (answer.is !== "picture" || over() || session !== this.session) return;
    const header = this.view.show(answer.bytes);
    this.store.setScene({ header, estimate: null });
  }
  private request(): api.SceneRequest {
    const { store } = this;
    return {
      doc: store.doc,
      time: store.time,
      have: this.view.have(),
      solo: store.solo.size ? [...store.solo] : null,
      hide: [...store.hidden],
      ask: this.patience,
      most: this.most,
    };
  }

  /** Asks for a picture and shows it; answers its header, null where there is none. */
  private async picture(more: Partial<api.SceneRequest>, begin: number): Promise<Header | null> {
    const { store, session } = this;
    this.view.hold(true);
    const name = more.only ? `${session}-changed` : session;
    const signal = more.only ? undefined : this.whole?.signal;
    const answer = await api.scene(name, ++this.seq, { ...this.request(), ...more }, signal)
      .catch((error: unknown): api.SceneAnswer => {
        if (signal?.aborted) return { is: "stale" };
        throw error;
      })
      .finally(() => this.view.hold(false));
    store.setLink("up");
    if (session !== this.session) return null;
    if (answer.is === "stale") {
      store.setScene({ busy: false });
      return null;
    }
    if (answer.is === "picture") {
      const header = this.view.show(answer.bytes);
      await this.view.drawn();
      const share = header.coarse ? more.share ?? 1 : 1;
      for (const entry of header.regrown) this.took.set(entry, header.seconds.grow / share);
      const took = (performance.now() - begin) / 1000;
      store.setScene({ header, errors: [], notes: header.notes, estimate: null, busy: more.only !== undefined && (header.missing.length > 0 || header.coarse), trouble: "", took });
      return header;
    }
    if (answer.is === "wrong") store.setScene({ errors: answer.errors, notes: answer.notes, estimate: null, busy: false, trouble: "" });
    else store.setScene({ estimate: answer.estimate, errors: [], busy: false, trouble: "" });
    return null;
  }

  private fail(error: unknown): void {
    const status = error instanceof api.ApiError ? error.status : -1;
    if (status === 0) this.store.setLink("down");
    else if (status === 403) this.store.setLink("refused");
    this.store.setScene({ busy: false, trouble: status === 0 ? "" : (error as Error).message });
  }
}
