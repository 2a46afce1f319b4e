/** Asks for pictures of the model: one request at a time, then the newest there is to ask. A drag never queues. */

import * as api from "./api";
import type { Store } from "./store";
import type { View } from "./view/view";

/** What takes longer than so many seconds is asked first. */
const PATIENCE = 8;

export class SceneLoop {
  private session = crypto.randomUUID();
  private seq = 0;
  private running = false;
  private wanted = false;
  private patience = PATIENCE;
  private waiting: (() => void)[] = [];
  /** The question() of the last request. */
  private asked = "";

  constructor(
    private store: Store,
    private view: View,
  ) {
    store.on("opened", () => {
      this.patience = PATIENCE;
      this.session = crypto.randomUUID();
    });
    store.on(["text", "time", "shown"], () => this.question() !== this.asked && this.want());
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
    this.patience = Math.max(this.patience, 1.5 * (this.store.scene.foretold?.seconds ?? 0));
    this.store.setScene({ foretold: null });
    this.want();
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
    store.setScene({ busy: true });
    const begin = performance.now();
    const session = this.session;
    this.asked = this.question();
    this.view.hold(true);
    const answer = await api.scene(session, ++this.seq, {
      doc: store.doc,
      time: store.time,
      have: this.view.have(),
      solo: store.solo.size ? [...store.solo] : null,
      hide: [...store.hidden],
      ask: this.patience,
    }).finally(() => this.view.hold(false));
    store.setLink("up");
    if (session !== this.session || answer.is === "stale") return;
    if (answer.is === "picture") {
      const header = this.view.show(answer.bytes);
      await this.view.drawn();
      const took = (performance.now() - begin) / 1000;
      store.setScene({ header, errors: [], notes: header.notes, foretold: null, busy: false, trouble: "", took });
    } else if (answer.is === "wrong") {
      store.setScene({ errors: answer.errors, notes: answer.notes, foretold: null, busy: false, trouble: "" });
    } else {
      store.setScene({ foretold: answer.foretold, errors: [], busy: false, trouble: "" });
    }
  }

  private fail(error: unknown): void {
    const status = error instanceof api.ApiError ? error.status : -1;
    if (status === 0) this.store.setLink("down");
    else if (status === 403) this.store.setLink("refused");
    this.store.setScene({ busy: false, trouble: status === 0 ? "" : (error as Error).message });
  }
}
