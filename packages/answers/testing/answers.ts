import fc from 'fast-check'
import { draw, stream } from '@botgarten/numbers'
import { birds } from '../file.ts'
import type { Answer, Chance, Column } from '../types.ts'

/** Chance that is the same in every run. */
export function chanceOf(seed: number): Chance {
  const state = stream(seed, 'answers')
  return () => draw(state)
}

export const columns: readonly Column[] = [
  { id: 'interest', kind: 'scale', options: ['1', '2', '3', '4', '5'] },
  { id: 'go-on', kind: 'choice', options: ['yes', 'maybe', 'no'] },
  { id: 'take-along', kind: 'text', options: [] },
  { id: 'robot', kind: 'robot', options: ['left', 'right'], answer: 'right' },
]

const hex = fc
  .array(fc.integer({ min: 0, max: 15 }), { minLength: 32, maxLength: 32 })
  .map((digits) => digits.map((digit) => digit.toString(16)).join(''))

const code = fc
  .tuple(fc.constantFrom(...birds.slice(0, 6)), fc.integer({ min: 100, max: 105 }))
  .map(([bird, number]) => `${bird}-${number}`)

const optional = <Value>(values: fc.Arbitrary<Value>) => fc.option(values, { nil: undefined })

const values = fc
  .record({
    interest: optional(fc.constantFrom('1', '2', '3', '4', '5')),
    'go-on': optional(fc.constantFrom('yes', 'maybe', 'no')),
    'take-along': optional(fc.string({ minLength: 1, maxLength: 20 })),
    robot: optional(fc.constantFrom('left', 'right')),
  })
  .map((all) =>
    Object.fromEntries(
      Object.entries(all).flatMap(([item, value]) => (value === undefined ? [] : [[item, value] as const])),
    ),
  )

/** Answers of a class or a school: few codes, so that some meet. */
export const answersOf = (forms: readonly string[]): fc.Arbitrary<readonly Answer[]> =>
  fc.uniqueArray(
    fc.record({
      id: hex,
      form: fc.constantFrom(...forms),
      grade: fc.integer({ min: 3, max: 12 }),
      code: fc.option(code),
      day: fc.constant('2026-11-26'),
      values,
    }),
    { maxLength: 60, selector: ({ id }) => id },
  )
