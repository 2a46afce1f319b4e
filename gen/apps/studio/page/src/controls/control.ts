/** What all controls are to the rows that hold them. */

import type { Field } from "../schema";
import type { Binding } from "./binding";

export interface Control {
  element: HTMLElement;
  /** Shows what counts now, unless the person is typing in it. */
  refresh(): void;
  /** Needs the whole width, below its label. */
  wide?: boolean;
}

export interface Place<F extends Field = Field> {
  field: F;
  binding: Binding;
  /** What it is called, for those who do not see the label. */
  label: string;
}

/** What is shown where the preset says nothing. */
export const valueOf = (place: Place): unknown => place.binding.get() ?? place.field.default;

/** Is the person in the middle of typing there? */
export const isTyping = (input: HTMLElement): boolean => document.activeElement === input && input.dataset.touched === "yes";
