/** A rectangle in px of CSS, as large as on paper. */
export interface Box {
  readonly left: number
  readonly top: number
  readonly right: number
  readonly bottom: number
}

/** Red, green, blue 0..255 and how opaque 0..1. */
export type Colour = readonly [number, number, number, number]

/** A line of words on a page. */
export interface SeenText {
  readonly text: string
  readonly box: Box
  /** A line belongs to one text of the page; lines of one text do not overlap. */
  readonly of: number
  /** The side, the slide or the sheet on which it stands. */
  readonly home: number
  readonly points: number
  readonly bold: boolean
  /** Inside a drawing. */
  readonly drawn: boolean
  readonly language: string
  readonly colour: Colour
  /** At three places: what is painted below, from the top down; null: a picture, whose colour nobody knows. */
  readonly below: readonly (readonly Colour[] | null)[]
  /** What is painted over it, if anything. */
  readonly coveredBy: string | null
  /** Where it may be seen: the sides of the paper, and boxes that cut what stands out. */
  readonly within: readonly Box[]
}

/** A figure, a picture, a table or a section. */
export interface SeenPart {
  readonly name: string
  readonly box: Box
  readonly home: number
  /** Numbers of the parts that it is inside of. */
  readonly inside: readonly number[]
  /** Letters, shapes and pictures in it. */
  readonly marks: number
  readonly within: readonly Box[]
}

export interface SeenPaper {
  readonly language: string
  readonly texts: readonly SeenText[]
  readonly parts: readonly SeenPart[]
  /** What pictures and drawings are called for ears. */
  readonly names: readonly { readonly text: string; readonly language: string }[]
}
