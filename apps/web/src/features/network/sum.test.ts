import type { NetView } from '@botgarten/lab'
import { trace, type Brain } from '@botgarten/learning/neural-network'
import fc from 'fast-check'
import { describe, expect, test } from 'vitest'
import type { Neuron } from '#figures/network/neurons.ts'
import { roundingOf, sumOf } from './sum.ts'

const weights = { left: { wheel: 0.5, other: 1 }, right: { wheel: -0.25 } }
const identity = (id: string, bias = 0) => ({ id, activation: 'identity' as const, bias })
const brain: Brain = {
  ...{ kind: 'network', weights, sets: {} },
  layers: [
    [identity('left'), identity('right')],
    [identity('wheel', 12), identity('other')],
  ],
}
const view: NetView = { ...trace(brain, [40, 60]), ran: true, brain }

const neuron = (id: string, colour = '#000000'): Neuron => ({
  ...{ id, label: `label of ${id}`, place: null, name: id, colour, missing: false },
})
const inputs = [neuron('left', '#1F67B3'), neuron('right', '#C2335F')]

test('a sum has the value and the weight of every link, the bias, and what they come to', () => {
  // 40 · 0.5 + 60 · −0.25 + 12 = 17
  expect(sumOf(neuron('wheel', '#5B7A12'), inputs, view, weights)).toEqual({
    ...{ output: 'label of wheel', colour: '#5B7A12', bias: 12, sum: 17, would: false },
    terms: [
      { id: 'left', colour: '#1F67B3', input: 40, weight: 0.5 },
      { id: 'right', colour: '#C2335F', input: 60, weight: -0.25 },
    ],
  })
})

test('before anything has run inputs and sum are unknown, and a link without a weight counts as 0', () => {
  expect(sumOf(neuron('wheel'), inputs, null, { left: {} })).toMatchObject({
    ...{ bias: 0, sum: null, would: false },
    terms: [
      { input: null, weight: 0 },
      { input: null, weight: 0 },
    ],
  })
})

test('a network that did not run shows the sum that would be', () => {
  expect(sumOf(neuron('wheel'), inputs, { ...view, ran: false }, weights).would).toBe(true)
})

describe('the numbers of a sum', () => {
  const sumWith = (terms: readonly (readonly [input: number, weight: number])[], bias = 0) => ({
    terms: terms.map(([input, weight], id) => ({ id: String(id), colour: '', input, weight })),
    ...{ bias, would: false },
    sum: terms.reduce((total, [input, weight]) => total + input * weight, bias),
  })

  test('have a digit behind the comma where whole numbers would not add up', () => {
    // 56 × 0.8 is not 44.
    expect(roundingOf(sumWith([[55.6, 0.8]]), false)).toEqual({ digits: 1, isExact: true })
    expect(roundingOf(sumWith([[50, 0.8]]), false)).toEqual({ digits: 0, isExact: true })
    expect(roundingOf(sumWith([[55.6, 0.8]]), true)).toEqual({ digits: 0, isExact: false })
  })

  test('are not off before anything has run', () => {
    const links = [{ id: 'left', colour: '#1F67B3', input: null, weight: 0.8 }]
    expect(roundingOf({ terms: links, bias: 0, sum: null, would: false }, false)).toEqual({
      digits: 0,
      isExact: true,
    })
  })

  test('add up, or are not called equal, over random networks', () => {
    const input = fc.double({ min: -100, max: 100, noNaN: true })
    const weight = fc.double({ min: -5, max: 5, noNaN: true })
    fc.assert(
      fc.property(
        fc.array(fc.tuple(input, weight), { minLength: 1, maxLength: 8 }),
        input,
        fc.boolean(),
        (terms, bias, coarse) => {
          const sum = sumWith(terms, bias)
          const { digits, isExact } = roundingOf(sum, coarse)
          const shown = (value: number, places: number) => Number(value.toFixed(places))
          const total = terms.reduce((all, [x, w]) => all + shown(x, digits) * shown(w, 2), shown(bias, 2))
          const gap = Math.abs(total - shown(sum.sum, digits))
          expect(isExact).toBe(gap <= 0.5 / 10 ** digits + 1e-9)
        },
      ),
    )
  })

  test('of one or two links with weights in hundredths add up', () => {
    const tenths = fc.integer({ min: 0, max: 1000 }).map((tenth) => tenth / 10)
    const hundredths = fc.integer({ min: 0, max: 100 }).map((part) => part / 100)
    fc.assert(
      fc.property(fc.array(fc.tuple(tenths, hundredths), { minLength: 1, maxLength: 2 }), (terms) => {
        expect(roundingOf(sumWith(terms), false).isExact).toBe(true)
      }),
    )
  })
})
