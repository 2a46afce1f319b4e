/** How fine pictures at rest may be: they grow finer by steps, and none takes longer than a person may have to wait for what
 *  is done next. */

/** Triangles grow by so much from one picture to the next. */
const FINER = 4;
/** The longest that a picture may take to draw, ms. */
export const LONGEST = 1500;

export class Pace {
  /** Triangles of a picture at rest, as many as this machine has drawn in time. */
  triangles: number;

  constructor(
    private least: number,
    private most: number,
  ) {
    this.triangles = Math.min(most, FINER * least);
  }

  /** After a picture of so many triangles that took so long, ms: whether another is to come that is finer. `whole`: that one
   *  left nothing out. */
  finer(took: number, drawn: number, whole: boolean): boolean {
    if (took > LONGEST) this.triangles = Math.max(this.least, (drawn * LONGEST) / took);
    if (whole || this.triangles >= this.most || FINER * took > LONGEST) return false;
    this.triangles = Math.min(this.most, FINER * this.triangles);
    return true;
  }
}
