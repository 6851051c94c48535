import type { StreamState } from '@botgarten/numbers'
import type { ObjectSchema } from './parameters.ts'

/**
 * A way of learning. Its numbers depend on the parameters, the data and the random stream alone, so that the same seed
 * is the same run, on every machine. How to add one: README.md.
 */
export interface Learner<Parameters extends object, Data, State, Saved, Trace> {
  /** Its name on the command line: `botgarten learn <name>`. */
  readonly name: string
  /** What `begin` takes; everything else is refused. */
  readonly parameters: ObjectSchema
  /**
   * A state that has learned nothing yet.
   * @param stream of its own, `stream(seed, 'learn/…')`; may be drawn from
   * @throws RangeError for parameters outside the schema, or that do not fit the data
   */
  begin(parameters: Parameters, data: Data, stream: StreamState): State
  /**
   * The smallest step that has a meaning, in place; does nothing when there is nothing left to learn.
   * @param trace takes the step with all its numbers. It changes nothing; without it nothing is made for it.
   */
  step(state: State, trace?: (trace: Trace) => void): void
  /** All that the state goes on from, as plain data that survives JSON. */
  save(state: State): Saved
  /** Goes on from there, bit for bit. @throws RangeError where it does not fit this state's data */
  restore(state: State, saved: Saved): void
}

/** Any of them, for what treats all alike. */
export type AnyLearner = Learner<object, unknown, unknown, unknown, unknown>
