/** Questions to the person, and short messages that go by themselves. */

import { el, type Child } from "../dom";

export interface Answer {
  value: string;
  label: string;
  primary?: boolean;
}

/** Opens a dialog; `fill` gets a function that closes it with an answer. Resolves to null when it is dismissed. */
export function dialog(title: string, fill: (close: (answer: string | null) => void) => Child[], testid: string): Promise<string | null> {
  return new Promise((resolve) => {
    const before = document.activeElement as HTMLElement | null;
    const name = `dialog-${testid}`;
    const box = el<HTMLDialogElement>("dialog", { "aria-labelledby": name, "data-testid": testid });
    // While Enter is down it would press what gets the focus next.
    let entering = false;
    const close = (answer: string | null): void => {
      const back = (): void => void (before?.isConnected && before.focus());
      // Closing would give the focus back at once, which taking it out does not.
      if (entering) addEventListener("keyup", back, { once: true });
      else box.close();
      box.remove();
      resolve(answer);
      if (!entering) back();
    };
    box.addEventListener("keydown", (event) => {
      entering = event.key === "Enter";
      if (entering && event.repeat) event.preventDefault();
    }, { capture: true });
    box.addEventListener("keyup", () => (entering = false));
    box.append(el("h2", { id: name }, title), ...(fill(close).filter(Boolean) as Node[]));
    box.addEventListener("cancel", (event) => {
      event.preventDefault();
      close(null);
    });
    document.body.append(box);
    box.showModal();
    const first = box.querySelector<HTMLElement>("[autofocus]") ?? box.querySelector<HTMLElement>(".primary, input:not([type=file])");
    first?.focus();
  });
}

export function ask(title: string, text: string, answers: Answer[], testid: string): Promise<string | null> {
  return dialog(title, (close) => [el("p", {}, text), buttons(answers, close)], testid);
}

export function buttons(answers: Answer[], close: (answer: string | null) => void): HTMLElement {
  const made = answers.map(({ value, label, primary }) =>
    el(primary ? "button.primary" : "button", { type: "button", "data-testid": `answer:${value}`, click: () => close(value) }, label),
  );
  return el("div.answers", {}, ...made);
}

let host: HTMLElement | null = null;

/** A message that goes after a while; it is read aloud. */
export function say(text: string, wrong = false): void {
  host ??= document.body.appendChild(el("div.toasts", { role: "status", "aria-live": "polite" }));
  const toast = el(wrong ? "p.toast.wrong" : "p.toast", {}, text);
  host.append(toast);
  setTimeout(() => toast.remove(), wrong ? 9000 : 4000);
}
