/** Milliseconds of a frame that painting one canvas may take. */
const most = 12
/** So many paintings in a row tell how fast a device is; a single slow one tells nothing. */
const enough = 30

/** Whether a device paints too slowly for its full resolution. */
export class Pace {
  #slow = 0

  /** @param milliseconds that the last painting took */
  isSlow(milliseconds: number): boolean {
    this.#slow = milliseconds > most ? this.#slow + 1 : 0
    return this.#slow >= enough
  }
}
