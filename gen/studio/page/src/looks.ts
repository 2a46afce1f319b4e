/**
 * Pictures of presets that have none in the gallery: the server grows them one after another, those in sight only, and
 * none while a preset is open.
 */

import * as api from "./api";

export class Looks {
  private files = new Map<Element, string>();
  private queue: HTMLImageElement[] = [];
  private running: AbortController | null = null;
  private observer = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      this.observer.unobserve(target);
      this.queue.push(target as HTMLImageElement);
    }
    void this.run();
  });

  /** Shows the picture once the image is in sight; an "error" event comes where there is none. */
  want(image: HTMLImageElement, file: string): void {
    this.files.set(image, file);
    this.observer.observe(image);
  }

  /** Forgets what is wanted so far. */
  stop(): void {
    this.observer.disconnect();
    this.files.clear();
    this.queue = [];
    this.running?.abort();
    this.running = null;
  }

  private async run(): Promise<void> {
    if (this.running) return;
    const { signal } = (this.running = new AbortController());
    for (let image = this.queue.shift(); image; image = this.queue.shift()) {
      const picture = await api.look(this.files.get(image) ?? "", signal).catch(() => null);
      if (signal.aborted) return;
      if (picture) show(image, picture);
      else image.dispatchEvent(new Event("error"));
    }
    this.running = null;
  }
}

function show(image: HTMLImageElement, picture: Blob): void {
  const address = URL.createObjectURL(picture);
  image.addEventListener("load", () => URL.revokeObjectURL(address), { once: true });
  image.src = address;
}
