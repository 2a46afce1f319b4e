/** Where there is no time to draw all, some of many alike stand for the rest and are a little larger. */

/** So many are drawn at least: of fewer each is a thing that one would miss. */
const FEWEST = 400;
/** The same of pieces of branches, which are cheap: a plant of fewer is never cut. */
const FEWEST_PIECES = 4000;
/** What stands for others grows to so many times its size at most: larger ones would be other shapes. */
export const LARGEST = 2;

/** One of how many of `count` is drawn where a share, 0..1, of them may be. */
export const everyOf = (count: number, share: number): number => Math.max(1, Math.min(Math.ceil(1 / share), Math.floor(count / FEWEST)));

/** How many of `count` pieces of branches are drawn then: the first of an order in which none comes before what it stands on. */
export const firstOf = (count: number, share: number): number => Math.min(count, Math.max(FEWEST_PIECES, Math.ceil(count * share)));

/** How much larger each is that stands for `every`. */
export const enlarged = (every: number): number => Math.min(Math.sqrt(every), LARGEST);
