import type { ItemMarkdown } from './itemTypes.ts'

/** `question.json` of a folder `content/materials/questions/<nn-id>/`: what will Bo do? */
export interface Question {
  readonly id: string
  readonly module: number
  readonly grades: readonly [number, number]
  /** What is shown, and run to find the answer. */
  readonly run: QuestionRun
  /** Possible outcomes, in the order shown; the words of each stand in `## Choices`. */
  readonly choices: readonly string[]
  /** What the run ends with: the tests compare. */
  readonly answer: string
}

export type QuestionRun =
  /** A card's program (`file` as in embeds) from start pose `start`, for `seconds`. */
  | {
      readonly observe: 'moves' | 'meets' | 'lamp' | 'tone'
      readonly card: string
      readonly file: string
      readonly start: number
      readonly seconds: number
    }
  | { readonly observe: 'way'; readonly card: string; readonly file: string }
  /** A cage of the zoo, at a setting of its mend. */
  | { readonly observe: 'cage'; readonly cage: string; readonly setting: number }
  /** Flags stand at things; with which of them does another thing end? */
  | {
      readonly observe: 'group'
      readonly set: string
      readonly features: readonly string[]
      readonly flags: readonly string[]
      readonly thing: string
    }

/** A question in one language. */
export interface QuestionText {
  readonly question: string
  /** By outcome. */
  readonly choices: { readonly [outcome: string]: string }
  /** Shown after an answer. */
  readonly why: ItemMarkdown
}
