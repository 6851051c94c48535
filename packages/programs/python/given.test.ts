import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardConfig } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { readOpenRoberta } from '../open-roberta/index.ts'
import { givenFiles } from '../testing/mutations.ts'
import { dialects, pythonFrom } from './index.ts'
import { asksElsewhere } from './testing/compare.ts'
import { interpreted, someBrains } from './testing/interpreted.ts'
import { tracesOf } from './testing/traces.ts'

addBlocks(expert)
addBlocks(learning)

const programs = Object.values(givenFiles()).map(readOpenRoberta)
const ours = programs.map((program) => interpreted(program, someBrains(program)))

/** Those that come to their end as blocks: others stop for a reason that semantics.md names. */
const ending = programs.flatMap((program, k) => {
  const run = ours[k]!
  return run.problem === null && !run.cut && run.held + run.failed.length > 0 ? [{ program, run }] : []
})

/** On SPIKE Prime a text goes by letter by letter. */
const ticks = { pybricks: 400, ev3dev2: 400, spike: 40_000 } as const

describe.each(dialects)('the given programs as Python for %s', (dialect) => {
  const able = ending.filter(({ program }) => !asksElsewhere(program, dialect))

  it('hold the assertions that their blocks hold', { timeout: 60_000 }, async () => {
    const texts = able.map(
      ({ program }) =>
        pythonFrom(
          { name: 'given', program, config: cardConfig, brains: someBrains(program), dialect },
          (key) => key,
        ).text,
    )
    const traces = await tracesOf(texts, ticks[dialect])
    const said = traces.map(
      (trace) => trace?.printed.filter((line) => / (holds|does not hold)$/.test(line)) ?? [],
    )
    const failed = said.map((lines) =>
      lines
        .filter((line) => line.endsWith('does not hold'))
        .map((line) => line.replace(/ does not hold$/, '')),
    )
    expect(failed).toEqual(able.map(({ run }) => run.failed))
    expect(said.map((lines) => lines.length)).toEqual(able.map(({ run }) => run.held + run.failed.length))
    expect(able.reduce((sum, { run }) => sum + run.held, 0)).toBeGreaterThan(100)
  })
})
