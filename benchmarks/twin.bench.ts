import { isDeepStrictEqual } from 'node:util'
import { addBlocks, type Block } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import fc from 'fast-check'
import { bothRun, endingOf } from '../packages/programs/testing/whole/both.ts'
import { wellTyped } from '../packages/programs/testing/whole/programs.ts'
import type { Table } from './bench.ts'

addBlocks(expert)

const programs = 10_000
const seed = 1

const sizeOf = (block: Block): number =>
  [...Object.values(block.values ?? {}), ...Object.values(block.statements ?? {}).flat()].reduce(
    (sum, inner) => sum + sizeOf(inner),
    1,
  )

/** Random well-typed programs over the whole language, on the interpreter and on the twin of semantics.md. */
export default function twin(): Table {
  const endings = new Map<string, number>()
  const different: string[] = []
  let blocks = 0
  fc.sample(wellTyped, { numRuns: programs, seed }).forEach((program, number) => {
    const { ours, twins } = bothRun(program)
    if (!isDeepStrictEqual(ours, twins)) different.push(`program ${number} of seed ${seed}`)
    const ending = endingOf(program)
    endings.set(ending, (endings.get(ending) ?? 0) + 1)
    blocks += program.stacks.flatMap((stack) => stack.blocks).reduce((sum, block) => sum + sizeOf(block), 0)
  })
  if (different.length > 0) process.exitCode = 1
  return {
    title: `${programs} random programs on the interpreter and on its twin`,
    how: 'Well-typed programs over every type of block but those that learn by trying or sort; 90 ticks each. What the robot is told tick by tick, the block that runs, variables, assertions and notes are compared with a plain recursive evaluator written from semantics.md.',
    columns: ['what', 'figure', 'goal'],
    rows: [
      ['different', different.length, 0],
      ['blocks a program, mean', (blocks / programs).toFixed(0), ''],
      ...[...endings].sort(([a], [b]) => (a < b ? -1 : 1)).map(([name, count]) => [name, count, '']),
    ],
    notes: different.slice(0, 20),
  }
}
