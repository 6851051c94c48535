import type { NetView } from '@botgarten/lab'
import { trace, type Brain } from '@botgarten/learning/neural-network'
import { expect, test } from 'vitest'
import type { Neuron } from '#figures/network/neurons.ts'
import { sumOf } from './sum.ts'

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
