/** The most pixels a floor may have. */
export const WIDEST = 1600
export const HIGHEST = 1200

/** A picture: rows from the top, three bytes (R, G, B) a pixel. */
export interface Picture {
  readonly width: number
  readonly height: number
  readonly data: Uint8Array
}
