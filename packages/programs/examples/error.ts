import type { Facts } from '@botgarten/blocks'

/** Of a table that names its columns, of a file, and of both. */
export type ExamplesProblem =
  'noHeading' | 'unknownColumn' | 'missingColumn' | 'twiceColumn' | FileProblem | 'manyRows' | 'manyDrives'

type FileProblem = 'notJson' | 'notExamples' | 'isAProject' | 'otherNetwork' | 'badRow' | 'tooBig'

/** Why examples cannot be taken. `facts` are for the words `examples.<problem>`. */
export class ExamplesError extends Error {
  override readonly name = 'ExamplesError'
  readonly problem: ExamplesProblem
  readonly facts: Facts

  constructor(problem: ExamplesProblem, facts: Facts = {}) {
    super(problem)
    this.problem = problem
    this.facts = facts
  }
}
