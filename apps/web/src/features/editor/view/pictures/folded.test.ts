import type { Block } from '@botgarten/blocks'
import { afterEach, expect, test } from 'vitest'
import { Bench } from '../../model/test-bench.ts'
import { phraseOf } from './folded.ts'

const benches: Bench[] = []
afterEach(() => benches.splice(0).forEach((bench) => bench.dispose()))

function folded(block: Block): string {
  const bench = new Bench({ ...block, collapsed: true })
  benches.push(bench)
  return phraseOf(bench.block(block.id))
}

const wait = { id: 'inside', type: 'robControls_wait_time', values: {} } as const

test('a folded loop says its own words, and nothing of what is in it', () => {
  const loop = { id: 'loop', type: 'robControls_loopForever', statements: { DO: [wait] } } as const
  expect(folded(loop)).toBe('repeat forever …')
})

test('what is asked or counted belongs to the phrase', () => {
  const times = {
    id: 'times',
    type: 'controls_repeat_ext',
    values: { TIMES: { id: 'n', type: 'math_number', fields: { NUM: '7' } } },
  } as const
  expect(folded(times)).toBe('repeat 7 times …')
})
