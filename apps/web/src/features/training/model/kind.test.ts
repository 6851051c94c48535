import { expect, test } from 'vitest'
import { rightNow } from './kind.ts'
import type { Practice } from './practice.svelte.ts'

const neuron = (id: string) => ({ id, activation: 'identity' as const, bias: 0 })
const lamp = (id: string) => ({ id, type: 'ai_nn_output_node_led' })
const pair = (inputs: readonly number[], outputs: readonly number[]) => ({ inputs, outputs })

/** Each input lights the lamp of its place: of two lamps the one with the higher reading is on. */
const practice = (data: object, isGoing = false) =>
  ({
    ...{ net: { outputs: [lamp('red'), lamp('green')] }, isGoing },
    layers: [
      [neuron('a'), neuron('b')],
      [neuron('red'), neuron('green')],
    ],
    knobs: { weights: { a: { red: 1, green: 0 }, b: { red: 0, green: 1 } } },
    prepared: { kept: [], practised: [], ...data },
  }) as unknown as Practice

const red = pair([90, 10], [100, -100])
const wrong = pair([90, 10], [-100, 100])

test('examples that are held back are counted, else those that are practised, else there is nothing to count', () => {
  expect(rightNow(practice({ practised: [red, red, wrong] }))).toEqual({ right: 2, of: 3 })
  expect(rightNow(practice({ kept: [red], practised: [red, wrong] }))).toEqual({ right: 1, of: 1 })
  expect(rightNow(practice({}))).toBeNull()
})

test('up to 500 examples are counted while knobs move, and more only when they rest', () => {
  const many = (count: number) => ({ practised: Array.from({ length: count }, () => red) })
  expect(rightNow(practice(many(500), true))).toEqual({ right: 500, of: 500 })
  expect(rightNow(practice(many(501), true))).toBeNull()
  expect(rightNow(practice(many(501)))).toEqual({ right: 501, of: 501 })
})
