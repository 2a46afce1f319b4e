/**
 * What is kept of a tab in the browser: through a reload the text, what it was loaded from and the way back; and for others,
 * should the tab go, what it had not saved.
 */

const KEY = "frond.draft";
const TAB = "frond.tab";
const LEFT = "frond.left:";
const MOST_LEFT = 12;

export interface Draft {
  file: string;
  text: string;
  saved: string;
  disk: string | null;
  copy: boolean;
  undo: string[];
  redo: string[];
  time: number;
  selected: Selection;
}

/** What the properties are shown of: the preset itself, its scene, what counts for all, or an organism. */
export type Selection = "preset" | "scene" | "all" | number;

/** What a tab that is gone had not saved. */
export interface Left {
  key: string;
  when: number;
  draft: Draft;
}

export function loadDraft(): Draft | null {
  try {
    return JSON.parse(sessionStorage.getItem(KEY) ?? "null") as Draft | null;
  } catch {
    return null;
  }
}

/** Where there is no room for all, the oldest steps back are let go. */
export function saveDraft(draft: Draft | null): void {
  leave(draft);
  if (!draft) return sessionStorage.removeItem(KEY);
  for (let steps = 60; ; steps = Math.floor(steps / 2)) {
    const kept = { ...draft, undo: steps ? draft.undo.slice(-steps) : [], redo: steps ? draft.redo.slice(-steps) : [] };
    try {
      return sessionStorage.setItem(KEY, JSON.stringify(kept));
    } catch {
      if (!steps) return;
    }
  }
}

/** What is not saved is left where other tabs of this address find it. */
function leave(draft: Draft | null): void {
  const tab = sessionStorage.getItem(TAB);
  if (!tab) return;
  try {
    if (!draft || draft.text === draft.saved) return localStorage.removeItem(LEFT + tab);
    localStorage.setItem(LEFT + tab, JSON.stringify({ when: Date.now(), draft: { ...draft, undo: [], redo: [] } }));
  } catch {
    // The browser keeps nothing, or no more.
  }
}

/** Gives this tab a name that says it lives, as long as it does. A tab that was doubled gets one of its own. */
export async function nameTab(): Promise<void> {
  const held = (name: string): Promise<boolean> =>
    new Promise((told) => {
      void navigator.locks.request(TAB + ":" + name, { ifAvailable: true }, (lock) => {
        told(lock !== null);
        return lock ? new Promise<void>(() => undefined) : undefined;
      });
    });
  let name = sessionStorage.getItem(TAB) ?? crypto.randomUUID();
  if (!(await held(name))) {
    name = crypto.randomUUID();
    await held(name);
  }
  sessionStorage.setItem(TAB, name);
}

/** What tabs that are gone have left, the newest first. */
export async function leftByOthers(): Promise<Left[]> {
  const alive = new Set(((await navigator.locks.query()).held ?? []).map((lock) => lock.name));
  const list: Left[] = [];
  for (const key of Object.keys(localStorage)) {
    if (!key.startsWith(LEFT) || alive.has(`${TAB}:${key.slice(LEFT.length)}`)) continue;
    try {
      list.push({ key, ...(JSON.parse(localStorage.getItem(key)!) as Omit<Left, "key">) });
    } catch {
      localStorage.removeItem(key);
    }
  }
  list.sort((a, b) => b.when - a.when);
  for (const old of list.splice(MOST_LEFT)) forget(old);
  return list;
}

export const forget = (left: Left): void => localStorage.removeItem(left.key);
