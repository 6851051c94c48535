import { readFileSync } from 'node:fs'
import { expect, it } from 'vitest'
import { brainsIn } from './brains.ts'
import { readOpenRoberta } from './index.ts'
import { networkIn, withNetwork } from './network-json.ts'

const folder = new URL('../testing/open-roberta/programs/', import.meta.url)
const programOf = (file: string) => readOpenRoberta(readFileSync(new URL(`${file}.xml`, folder), 'utf8'))
const dataOf = (file: string) =>
  programOf(file)
    .stacks.flatMap(({ blocks }) => blocks)
    .find(({ data }) => data?.includes('networkShape'))!.data!

it('a network of Open Roberta is read with its names, and its numbers however they are written', () => {
  const [brain] = Object.values(brainsIn(programOf('upstream__xNN__nn_step')))
  expect(brain!.layers.map((layer) => layer.map(({ id }) => id))).toEqual([
    ['i1', 'i2'],
    ['h1n1', 'h1n2', 'h1n3'],
    ['o1', 'o2'],
  ])
  expect(brain!.weights).toEqual({
    i1: { h1n1: 1, h1n2: -1, h1n3: 0 },
    i2: { h1n1: 1, h1n2: 1, h1n3: 1 },
    h1n1: { o1: -1, o2: -1 },
    h1n2: { o1: -1 / 15, o2: 1 },
    h1n3: { o1: -1 / 15, o2: 1 },
  })
  expect(brain!.layers[1]!.map(({ bias }) => bias)).toEqual([1, 1, 0])
})

it('one without names for its hidden neurons gets Open Roberta’s', () => {
  const [brain] = Object.values(brainsIn(programOf('history__ev3__nn_step')))
  expect(brain!.layers[1]!.map(({ id }) => id)).toEqual(['h1n1', 'h1n2'])
})

it('parts of one are read, and what is no number is 0', () => {
  const data = (weight: string) =>
    JSON.stringify({
      ...{ activationKey: 'linear', networkShape: [], inputs: ['a'], outputs: ['b'] },
      ...{ weights: [[[weight]], [[]]], biases: [['0'], ['0']] },
    })
  const weightOf = (weight: string) => networkIn(data(weight))!.weights['a']!['b']
  expect(['/15', ':2', '-1,5', '-/4', '1/0', 'x', ''].map(weightOf)).toEqual([
    1 / 15, 0.5, -1.5, -0.25, 0, 0, 0,
  ]) // prettier-ignore
})

it('a network that cannot be computed here is none', () => {
  expect(networkIn('{"activationKey":"tanh"}')).toBeNull()
  expect(networkIn('hello')).toBeNull()
  expect(networkIn(dataOf('upstream__xNN__nn_step').replace('"i1"', '"__proto__"'))).toBeNull()
})

it('weights go back into the data, and nothing else of it changes', () => {
  const data = dataOf('upstream__xNN__nn_step')
  const brain = networkIn(data)!
  expect(withNetwork(data, brain)).toBe(data)
  const changed = { ...brain, weights: { ...brain.weights, i1: { ...brain.weights['i1'], h1n3: 0.25 } } }
  const after = withNetwork(data, changed)
  expect(networkIn(after)).toEqual(changed)
  expect(after).toBe(data.replace('["1","-1","0"]', '["1","-1","0.25"]'))
})

it('how it practises is read with it: learning rate, batch, and L2 as weight decay', () => {
  const data = JSON.parse(dataOf('upstream__xNN__nn_step')) as object
  const settingsOf = (more: object) => networkIn(JSON.stringify({ ...data, ...more }))!.practice?.settings
  expect(settingsOf({ learningRate: 0.3, batchSize: 16 })).toMatchObject({
    rate: 0.3,
    batch: 16,
    decay: 0,
    bias: 'on',
  })
  const regularized = { regularization: 'L2', regularizationRate: 0.001 }
  expect(settingsOf(regularized)).toMatchObject({ decay: 0.001 })
  expect(settingsOf({ ...regularized, regularization: 'L1' })).toMatchObject({ decay: 0 })
  expect(settingsOf({ learningRate: 'fast', batchSize: -3 })).toBeUndefined()
  expect(networkIn(JSON.stringify(data))!.practice).toMatchObject({ round: 0, curve: [] })
})
