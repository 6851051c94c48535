import { choice, rows, words, worded } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import { part } from '../parts/python.ts'
import { chipProgram } from '../parts/trying-examples.ts'
import type { Definition, FieldLook } from '../types.ts'

const type = 'ai_try_chip'

const percent = (name: string, preset: number): FieldLook => ({
  ...{ name, kind: 'number', preset, min: -100, max: 100 },
})

/** One more thing that a robot that tries can do: both wheels in percent, and a lamp. */
export const ai_try_chip: Definition = {
  type,
  pack: 'learning',
  look: {
    category: 'q-learning',
    shape: 'statement',
    fields: [
      ...[percent('LEFT', 60), percent('RIGHT', 30)],
      choice('LAMP', [
        worded('NONE', 'tryNone'),
        worded('GREEN', 'tryGreen', '#00642E'),
        worded('ORANGE', 'tryOrange', '#F7D117'),
        worded('RED', 'tryRed', '#B30006'),
        worded('OFF', 'tryDark'),
      ]),
    ],
    inputs: [],
    rows: rows(type, 2),
  },
  words: words(type),
  acts: false,
  run: () => done,
  python: part,
  example: chipProgram(),
}
