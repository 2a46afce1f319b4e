/** What there is to say of the picture of the model. */

import type { Fault, CostEstimate } from "./api";
import type { Header } from "./view/header";

export interface SceneStatus {
  header: Header | null;
  errors: Fault[];
  notes: string[];
  estimate: CostEstimate | null;
  busy: boolean;
  /** Organisms that have grown, of so many; null: it takes no time worth telling. */
  growing: { done: number; of: number } | null;
  /** A person would not wait. */
  stopped: boolean;
  /** What went wrong with the server itself. */
  trouble: string;
  /** From the request to the picture, seconds. */
  took: number;
}

export const NO_SCENE: SceneStatus = { header: null, errors: [], notes: [], estimate: null, busy: false, growing: null, stopped: false, trouble: "", took: 0 };
