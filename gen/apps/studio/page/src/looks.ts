/** Pictures that the server makes one after another, of those in sight only: looks at presets, materials on balls. */

type Source = (signal: AbortSignal) => Promise<Blob | null>;

export class Looks {
  private sources = new Map<Element, Source>();
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
  want(image: HTMLImageElement, source: Source): void {
    this.sources.set(image, source);
    this.observer.observe(image);
  }

  /** Forgets what is wanted so far. */
  stop(): void {
    this.observer.disconnect();
    this.sources.clear();
    this.queue = [];
    this.running?.abort();
    this.running = null;
  }

  private async run(): Promise<void> {
    if (this.running) return;
    const { signal } = (this.running = new AbortController());
    for (let image = this.queue.shift(); image; image = this.queue.shift()) {
      const picture = await this.sources.get(image)?.(signal).catch(() => null);
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
