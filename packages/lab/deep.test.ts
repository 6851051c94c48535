import { addBlocks, type Block } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { biasRow, follow, hiddenId } from '@botgarten/learning/neural-network/brain'
import type { Program } from '@botgarten/programs'
import { describe, expect, it } from 'vitest'
import { labWith, worldWith } from './testing/scene.ts'

addBlocks(learning)

const block = (id: string, type: string, rest: Partial<Block> = {}): Block => ({ id, type, ...rest })
const list = (id: string, kind: string, item: Block) =>
  block(id, 'ai_easy_list', { mutation: { attrs: { items: '1', list_type: kind } }, values: { ADD0: item } })
const inputs = list(
  'inputs',
  'InputNode',
  block('eye', 'ai_nn_input_node_ultrasonic', { fields: { INPUTNODE: 'ULTRASONIC_PORT_2' } }),
)
const outputs = list(
  'outputs',
  'OutputNode',
  block('wheel', 'ai_nn_output_node', { fields: { OUTPUTNODE: 'MOTORPORT_C' } }),
)
const hidden = (neurons: number, activation: string) =>
  block('hidden', 'ai_nn_hidden_layer', {
    fields: { NEURONS: String(neurons), ACTIVATION: activation },
    values: { LAYER: inputs },
  })
const programWith = (before: Block): Program => ({
  stacks: [
    {
      x: 0,
      y: 0,
      blocks: [
        block('start', 'robControls_start'),
        block('forever', 'robControls_loopForever', {
          statements: {
            DO: [
              block('net', 'ai_neural_network', { values: { INPUT_LAYER: before, OUTPUT_LAYER: outputs } }),
            ],
          },
        }),
      ],
    },
  ],
  config: { stacks: [] },
})

describe('a network with a hidden layer', () => {
  const lab = () => labWith(programWith(hidden(2, 'THRESHOLD')), worldWith(1))

  it('drives as its neurons say: two steps of 100 and a bias make 55', () => {
    const deep = lab()
    deep.setWeight('net', biasRow, hiddenId('hidden', 1), 5)
    deep.setWeight('net', biasRow, hiddenId('hidden', 2), -1000)
    deep.setWeight('net', hiddenId('hidden', 1), 'wheel', 0.75)
    deep.setWeight('net', hiddenId('hidden', 2), 'wheel', 1)
    deep.setWeight('net', biasRow, 'wheel', -20)
    deep.start()
    deep.advance(2)
    expect(deep.view().robots[0]!.motors['C']).toBe(55)
    expect(deep.view().networks['net']!.biases).toEqual({ 'hidden#1': 5, 'hidden#2': -1000, wheel: -20 })
  })

  it('follows its block, and keeps its weights when it grows, shrinks, goes and comes back', () => {
    const deep = lab()
    deep.setWeight('net', hiddenId('hidden', 2), 'wheel', 0.4)
    deep.edit({ main: programWith(inputs) })
    expect(deep.document().brains['net']!.layers).toHaveLength(2)
    deep.edit({ main: programWith(hidden(3, 'RELU')) })
    const { layers, weights } = deep.document().brains['net']!
    expect(layers[1]!.map(({ id, activation }) => [id, activation])).toEqual([
      ['hidden#1', 'relu'],
      ['hidden#2', 'relu'],
      ['hidden#3', 'relu'],
    ])
    expect(weights['hidden#2']).toEqual({ wheel: 0.4 })
  })

  it('gives the same run again from the same start: weights by hand, biases too, are inputs of their tick', () => {
    const hashes = [0, 1].map(() => {
      const deep = lab()
      deep.start()
      deep.advance(20)
      deep.setWeight('net', biasRow, 'wheel', 40)
      deep.advance(40)
      deep.goTo(10)
      deep.goTo(60)
      return deep.hash()
    })
    expect(hashes[0]).toBe(hashes[1])
  })

  it('keeps an activation of its outputs that was set by hand', () => {
    const deep = lab()
    const brain = deep.document().brains['net']!
    const last = brain.layers.at(-1)!.map((neuron) => ({ ...neuron, activation: 'softmax' as const }))
    deep.setBrain('net', { ...brain, layers: brain.layers.with(-1, last) })
    deep.edit({ main: programWith(hidden(3, 'TANH')) })
    expect(deep.document().brains['net']!.layers.at(-1)).toEqual(last)
    expect(follow(brain, ['eye'], ['wheel']).layers.at(-1)![0]!.activation).toBe('identity')
  })
})
