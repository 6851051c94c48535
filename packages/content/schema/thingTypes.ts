/** `things.json` of a set: the same things on paper and on the screen, each with a picture `<id>.svg` beside. */
export interface ThingSet {
  readonly id: string
  readonly features: readonly Feature[]
  readonly things: readonly Thing[]
}

export interface Thing {
  readonly id: string
  /** What it is called in both languages: `sorting.kind.<kind>`. Never counts: groups are to be found. */
  readonly kind: string
  readonly values: { readonly [feature: string]: number | string }
}

/** What can be compared. Its words: `sorting.feature.<id>`; those of an option: `sorting.option.<option>`. */
export type Feature =
  | { readonly id: string; readonly kind: 'number'; readonly unit: string }
  /** `#RRGGBB`, compared by its red, green and blue. */
  | { readonly id: string; readonly kind: 'colour' }
  /** Things with the same option are alike, all others equally unlike. */
  | { readonly id: string; readonly kind: 'choice'; readonly options: readonly string[] }

/** A number of each thing, and how it is scaled to the plane's of 0 to 10. */
export interface Column {
  readonly feature: string
  /** `red`, `green`, `blue` of a colour; the option of a choice; '' where the feature is one number. */
  readonly part: string
  readonly unit: string
  /** Raw values that lie at 0 and at `scale`. */
  readonly low: number
  readonly high: number
  readonly scale: number
}
