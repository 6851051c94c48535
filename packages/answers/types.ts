/** The fewest people of whom anything is shown. */
export const fewest = 5

/** What one child answered to one form. */
export interface Answer {
  /** 32 hexadecimal digits, by chance: what is read twice is one. */
  readonly id: string
  readonly form: string
  /** 3 to 12. */
  readonly grade: number
  /** A bird and a number, `kingfisher-417`, which join what one child answers over time; null: none, or forgotten. */
  readonly code: string | null
  /** ISO, such as `2026-11-26`. */
  readonly day: string
  /** By item: a step `1` to `5`, the name of a choice, or a sentence. What was left out is not there. */
  readonly values: { readonly [item: string]: string }
}

/** An item of a form as it is counted. */
export interface Column {
  readonly id: string
  readonly kind: 'scale' | 'choice' | 'text' | 'robot'
  /** What can be chosen, in order; none where a sentence is written. */
  readonly options: readonly string[]
  /** What the robot really does. */
  readonly answer?: string
}

/** A number from 0 to 1, 1 excluded, by chance. */
export type Chance = () => number
