import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import {
  biasRow,
  emptyBrain,
  follow,
  withActivation,
  withWeight,
} from '@botgarten/learning/neural-network/brain'
import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import type { NetworkOutline } from '../types.ts'
import { BrainError, brainFile, fitBrain, parseBrainFile, shelfName } from './brain-file.ts'

addBlocks(learning)

const outline = (eyes: readonly string[], wheels: readonly string[], type = 'ai_nn_output_node') =>
  ({
    id: 'net',
    inputs: eyes.map((id) => ({ id, type: 'ai_nn_input_node_ultrasonic' })),
    hidden: [],
    outputs: wheels.map((id) => ({ id, type })),
  }) as unknown as NetworkOutline
const net = outline(['a', 'b'], ['l', 'r'])
const brain = withWeight(
  withWeight(follow(emptyBrain, ['a', 'b'], ['l', 'r']), 'a', 'l', 0.8),
  biasRow,
  'r',
  -20,
)
const text = JSON.stringify(brainFile('mild', brain, net, brain.weights))

function problemOf(act: () => unknown): unknown {
  try {
    act()
  } catch (error) {
    expect(error).toBeInstanceOf(BrainError)
    return (error as BrainError).problem
  }
}
const withLayers = (layers: unknown) => JSON.stringify({ ...(JSON.parse(text) as object), layers })

describe('a brain as a file', () => {
  it('comes back with its name, its weights and its biases', () => {
    const file = parseBrainFile(text)
    expect(file.name).toBe('mild')
    expect(fitBrain(file, brain, net)).toEqual({ brain, weights: { a: { l: 0.8 }, [biasRow]: { r: -20 } } })
  })

  it('fits another program whose neurons are of the same kinds, in their order', () => {
    const other = follow(emptyBrain, ['x', 'y'], ['m', 'n'])
    expect(fitBrain(parseBrainFile(text), other, outline(['x', 'y'], ['m', 'n'])).weights).toEqual({
      x: { m: 0.8 },
      [biasRow]: { n: -20 },
    })
  })

  it('brings the activations of its outputs', () => {
    const shared = withActivation(brain, 'l', 'softmax')
    const file = parseBrainFile(JSON.stringify(brainFile('s', shared, net, shared.weights)))
    expect(fitBrain(file, brain, net).brain).toEqual(shared)
    const tanh = withActivation(brain, 'l', 'tanh')
    const back = parseBrainFile(JSON.stringify(brainFile('t', tanh, net, tanh.weights)))
    expect(fitBrain(back, shared, net).brain).toEqual(tanh)
  })

  it.each([
    ['a photo of my cat', 'notJson'],
    [text.replace('0.8', 'NaN'), 'notANumber'],
    [text.replace('0.8', 'null'), 'notANumber'],
    [text.replace('0.8', '"a lot"'), 'notANumber'],
    [text.replace('0.8', '1e999'), 'notANumber'],
    ['{"botgarten":1,"name":"x"}', 'isAProject'],
    ['[1,2]', 'notABrain'],
    ['null', 'notABrain'],
    ['{"botgarten":"brain","version":2,"layers":[[],[]]}', 'notABrain'],
    [withLayers([Array(300).fill({ id: 'a', kind: 'b', activation: 'relu' }), []]), 'tooManyNeurons'],
    [text.replace('"a":{', '"__proto__":{'), 'notABrain'],
    [' '.repeat(2_000_001), 'tooBig'],
  ])('%.40s is refused: %s', (file, problem) => {
    expect(problemOf(() => parseBrainFile(file))).toBe(problem)
  })

  it.each([
    ['more sensors', outline(['a', 'b', 'c'], ['l', 'r'])],
    ['other outputs', outline(['a', 'b'], ['l', 'r'], 'ai_nn_output_node_led')],
  ])('of a program with %s is for another program', (_what, other) => {
    const ids = [other.inputs, other.outputs].map((layer) => layer.map(({ id }) => id))
    const here = follow(emptyBrain, ...ids)
    expect(problemOf(() => fitBrain(parseBrainFile(text), here, other))).toBe('otherProgram')
  })

  it('is read or refused, whatever is in the file', () => {
    fc.assert(
      fc.property(fc.json(), (odd) => {
        const problem = problemOf(() => fitBrain(parseBrainFile(odd), brain, net))
        expect(typeof problem).toBe('string')
      }),
      { seed: 5 },
    )
    fc.assert(
      fc.property(fc.nat(text.length - 1), fc.constantFrom('', '0', '}', '"', '-', '[', 'x'), (at, by) => {
        problemOf(() => fitBrain(parseBrainFile(text.slice(0, at) + by + text.slice(at + 1)), brain, net))
      }),
      { seed: 6, numRuns: 500 },
    )
  })
})

describe('a name among saved brains', () => {
  it('is there once, not too long, and never empty', () => {
    expect(shelfName('  shy   Bo ', [], 'Brain')).toBe('shy Bo')
    expect(shelfName('', ['Brain'], 'Brain')).toBe('Brain 2')
    expect(shelfName('__proto__', [], 'Brain')).toBe('Brain')
    expect(shelfName('x'.repeat(99), [], 'Brain')).toHaveLength(40)
  })
})
