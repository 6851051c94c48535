import type { Python } from '../python.ts'
import type { BlockType } from '../packs/packs.ts'
import type { Definition, Pack } from '../types.ts'
import { number, show, start } from './examples.ts'
import { field } from './fields.ts'
import { choice, rows, value, worded, words } from './looks.ts'
import { ask, fail } from './next.ts'
import { finite, numberAt } from './numbers.ts'
import { afterAsking } from './steps.ts'

/** What OP says, its words, and what it does with a number. */
type Operation = readonly [value: string, words: string, work: (x: number) => number]

/** A block that works one number out of another; OP says how, the first operation is the preset. */
export function numberFunction(
  type: BlockType,
  pack: Pack,
  operations: readonly Operation[],
  python: Python,
): Definition {
  const works = new Map(operations.map(([op, , work]) => [op, work]))
  const preset = operations[0]?.[0] ?? ''
  return {
    type,
    pack,
    look: {
      category: 'math',
      shape: 'value',
      output: 'Number',
      fields: [
        choice(
          'OP',
          operations.map(([op, said]) => worded(op, said)),
        ),
      ],
      inputs: [value('NUM', 'Number')],
      rows: rows(type, 1),
    },
    words: words(type),
    acts: false,
    run: afterAsking([ask('NUM')], (frame, _context, block) => {
      const work = works.get(field(block, 'OP', preset))
      return work === undefined ? fail('unknownChoice') : finite(work(numberAt(frame, 0)), frame)
    }),
    python,
    example: [start, show({ type, fields: { OP: preset }, values: { NUM: number(2.25) } })],
  }
}
