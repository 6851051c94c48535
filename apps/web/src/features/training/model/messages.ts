import type { Exercise, ExampleFinding, Table } from '@botgarten/learning/neural-network/examples'
import type { CurvePoint, Ending, Settings, TrainTrace } from '@botgarten/learning/neural-network/train'

/** What the page asks of a practice. `job` numbers its beginnings: reports of an earlier one are not listened to. */
export type Order =
  | { readonly kind: 'begin'; readonly job: number; readonly exercise: Exercise; readonly settings: Settings }
  /** Practises to the end of this round. `pace`: rounds a second at most; Infinity: as fast as it can. */
  | { readonly kind: 'go'; readonly until: number; readonly pace: number }
  /** Pauses; what counts is the last whole round. */
  | { readonly kind: 'stop' }
  /** The last report was taken in: before that, rounds that go on are not reported again. */
  | { readonly kind: 'heard' }
  /** Opens the next example and changes nothing. */
  | { readonly kind: 'peek' }
  /** Takes the next example. */
  | { readonly kind: 'step' }
  | Ask

/** What is to be asked about a table that is too large to look through on the page. */
export interface Ask {
  readonly kind: 'ask'
  readonly number: number
  readonly table: Table
}

export type Report = Progress | Example | Answer

/** The findings in the table that was asked about by this number. */
export interface Answer {
  readonly kind: 'answer'
  readonly number: number
  readonly findings: readonly ExampleFinding[]
}

/** Rounds have passed, or it has come to rest. */
export interface Progress {
  readonly kind: 'progress'
  readonly job: number
  readonly round: number
  /** Measured since the last report. */
  readonly points: readonly CurvePoint[]
  /** The parameters of each of these points, one behind the other. */
  readonly stored: Float64Array<ArrayBuffer>
  /** The parameters that count now: of the last whole round, or of the best one. */
  readonly now: Float64Array<ArrayBuffer>
  readonly isGoing: boolean
  readonly ended: Ending | null
  /** Ids of hidden neurons that no example wakes; looked at when it comes to rest. */
  readonly sleeping: readonly string[]
}

/** One example, opened. */
export interface Example {
  readonly kind: 'example'
  readonly job: number
  readonly trace: TrainTrace
  /** Is it only looked at? */
  readonly isPeek: boolean
  /** The parameters after it, or before it where it is only looked at. */
  readonly now: Float64Array<ArrayBuffer>
}

/** `going`: rounds pass · `again`: rounds that were practised before are practised again, to get back to one. */
export type Phase = 'rest' | 'going' | 'again'

/** What is to happen when the rounds of before are there again. */
export type Then =
  { readonly kind: 'show'; readonly round: number } | { readonly kind: 'go' } | { readonly kind: 'open' }
