import type { Value } from '@botgarten/blocks'
import type { RobotRun } from './robots/run.ts'

/** What a program remembers under a name. */
export interface Variable {
  readonly name: string
  readonly value: Value
  /** Id of the block of the function that it belongs to; null: the whole program's. */
  readonly of: string | null
}

/** The program's variables, then those of the function that runs. Copies: the program may change its own. */
export function variablesOf({ thread, index }: RobotRun): readonly Variable[] {
  const [program = {}] = thread.scopes
  const inner = thread.frames.findLast(({ block }) => index.blocks.get(block)?.isFunction)?.block
  const local = inner === undefined ? undefined : thread.scopes.at(-1)
  const named = (scope: object, of: string | null) =>
    Object.entries(structuredClone(scope) as { [name: string]: Value }).map(([name, value]) => ({
      name,
      value,
      of,
    }))
  return [...named(program, null), ...(local && inner !== undefined ? named(local, inner) : [])]
}
