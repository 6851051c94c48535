import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { isLong } from '@botgarten/numbers/testing'
import { cardConfig } from '@botgarten/simulation'
import fc from 'fast-check'
import { beforeAll, describe, expect, it } from 'vitest'
import { check } from '../check/check.ts'
import { wellTyped } from '../testing/whole/programs.ts'
import type { Program } from '../types.ts'
import { dialects, pythonFrom } from './index.ts'
import { interpreted, someBrains } from './testing/interpreted.ts'
import { tracesOf } from './testing/traces.ts'
import { asksElsewhere, difference } from './testing/compare.ts'

const count = isLong ? 500 : 40
const programs: Program[] = []
beforeAll(() => {
  addBlocks(expert)
  addBlocks(learning)
  for (const program of runnable()) if (programs.push(program) === count) break
}, 300_000)

/** Programs that the lab would start, and that tell the robot something. */
function* runnable(): Generator<Program, void> {
  for (let seed = 1; ; seed++)
    for (const program of fc.sample(wellTyped, { numRuns: 100, seed }))
      if (canStart(program) && interpreted(program, someBrains(program)).log.length > 2) yield program
}

const canStart = (program: Program) =>
  !asksElsewhere(program, 'ev3dev2') && check(program, cardConfig).every(({ stops }) => !stops)

/** Programs that differ, by their number, and why: python.md, "Numbers". */
const named: { readonly [index: number]: string } = {
  191: 'a place below 0, counted from the end: nothing here, the beginning in Python',
  422: 'the 150th power of -3: a double here, every digit of it in Python',
}

describe.each(dialects)('random programs as Python for %s', (dialect) => {
  it('tell the robot the same commands as their blocks', { timeout: 300_000 }, async () => {
    const own = programs.filter((program, k) => !(k in named) && !asksElsewhere(program, dialect))
    const texts = own.map(
      (program) =>
        pythonFrom(
          { name: 'random', program, config: cardConfig, brains: someBrains(program), dialect },
          (key) => key,
        ).text,
    )
    const traces = await tracesOf(texts)
    expect(traces.reduce((sum, trace) => sum + (trace?.log.length ?? 0), 0)).toBeGreaterThan(3 * count)
    const differences = own.flatMap((program, k) => {
      const found = difference(interpreted(program, someBrains(program)), traces[k]!, dialect)
      return found === null ? [] : [`${k}: ${found}\n${texts[k]}`]
    })
    expect(differences).toEqual([])
  })
})
