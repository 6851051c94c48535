import { addBlocks, definitions, type Block } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import fc from 'fast-check'
import { beforeAll, describe, expect, it } from 'vitest'
import { bothRun } from '../testing/whole/both.ts'
import { wellTyped } from '../testing/whole/programs.ts'

beforeAll(() => addBlocks(expert))

/** Each has tests of its own; without a learner beside it, it does nothing. */
const learns = /^(ai_q_|ai_try_|rl_|ai_sorting_|ai_nn_(remember|practise|forget|error)$)/

const inside = (block: Block): readonly string[] => [
  block.type,
  ...Object.values(block.values ?? {}).flatMap(inside),
  ...Object.values(block.statements ?? {}).flatMap((rows) => rows.flatMap(inside)),
]

describe('random programs of the whole language', () => {
  it('do in every tick what the slow twin of semantics.md does', () => {
    fc.assert(
      fc.property(wellTyped, (program) => {
        const { ours, twins } = bothRun(program)
        expect(ours).toEqual(twins)
      }),
      { numRuns: 500, seed: 39 },
    )
  })

  it('hold every type of block but those that learn or sort', () => {
    const seen = new Set(
      fc
        .sample(wellTyped, { numRuns: 1500, seed: 7 })
        .flatMap(({ stacks }) => stacks.flatMap(({ blocks }) => blocks.flatMap(inside))),
    )
    const all = Object.keys(definitions).filter((type) => !learns.test(type))
    const missing = all.filter((type) => !seen.has(type))
    expect(
      missing,
      'give them a second meaning in programs/testing/whole (statements.ts, typed-rows.ts …)',
    ).toEqual([])
  })
})
