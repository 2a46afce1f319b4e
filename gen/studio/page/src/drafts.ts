/** What a tab keeps through a reload: the text, what it was loaded from, and the way back. */

const KEY = "frond.draft";

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

export function loadDraft(): Draft | null {
  try {
    return JSON.parse(sessionStorage.getItem(KEY) ?? "null") as Draft | null;
  } catch {
    return null;
  }
}

/** Where there is no room for all, the oldest steps back are let go. */
export function saveDraft(draft: Draft | null): void {
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
