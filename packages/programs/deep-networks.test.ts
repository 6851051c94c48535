import { addBlocks, blockFrom, type Block, type Template } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardConfig } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { check, networks, parseProject, type Program } from './index.ts'
import { readOpenRoberta, writeOpenRoberta } from './open-roberta/index.ts'
import { xmlTree } from './testing/xml-tree.ts'

addBlocks(learning)

const list = (kind: 'InputNode' | 'OutputNode', neurons: readonly Template[]): Template => ({
  type: 'ai_easy_list',
  mutation: { attrs: { items: String(neurons.length), list_type: kind } },
  values: Object.fromEntries(neurons.map((neuron, k) => [`ADD${k}`, neuron])),
})
const eye: Template = { type: 'ai_nn_input_node_ultrasonic', fields: { INPUTNODE: 'ULTRASONIC_PORT_2' } }
const motor: Template = { type: 'ai_nn_output_node', fields: { OUTPUTNODE: 'MOTORPORT_C' } }
const hidden = (before: Template | null, neurons: string, activation: string): Template => ({
  type: 'ai_nn_hidden_layer',
  fields: { NEURONS: neurons, ACTIVATION: activation },
  ...(before && { values: { LAYER: before } }),
})

function programOf(inputs: Template): Program {
  let count = 0
  const id = () => `b${++count}`
  const net: Template = {
    type: 'ai_neural_network',
    values: { INPUT_LAYER: inputs, OUTPUT_LAYER: list('OutputNode', [motor]) },
  }
  const blocks: Block[] = [
    blockFrom({ type: 'robControls_start' }, id),
    blockFrom({ type: 'robControls_loopForever', statements: { DO: [net] } }, id),
  ]
  return { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } }
}
const deep = programOf(hidden(hidden(list('InputNode', [eye]), '4', 'TANH'), '2', 'SIGMOID'))
const problemsOf = (program: Program) => check(program, cardConfig).map(({ problem }) => problem)

describe('hidden layers', () => {
  it('stand between the inputs and the outputs, the nearest to the inputs first', () => {
    const [net] = networks(deep)
    expect(net!.hidden.map(({ neurons, activation }) => [neurons, activation])).toEqual([
      [4, 'tanh'],
      [2, 'sigmoid'],
    ])
    expect([net!.inputs.length, net!.outputs.length]).toEqual([1, 1])
    expect(problemsOf(deep)).toEqual([])
  })

  it('need inputs before them', () => {
    expect(problemsOf(programOf(hidden(null, '3', 'RELU')))).toEqual(['problem.noInputs'])
  })

  it('have at most 64 neurons, and a network at most 256', () => {
    expect(problemsOf(programOf(hidden(list('InputNode', [eye]), '300', 'RELU')))).toEqual([
      'problem.tooManyInLayer',
    ])
    const tall = [1, 2, 3, 4].reduce((before) => hidden(before, '64', 'RELU'), list('InputNode', [eye]))
    expect(problemsOf(programOf(tall))).toEqual(['problem.tooManyNeurons'])
  })

  it('of which a file says nonsense are said at the block, and have one neuron', () => {
    const odd = programOf(hidden(list('InputNode', [eye]), 'NaN', 'GELU'))
    expect(problemsOf(odd)).toEqual(['problem.notANumber', 'problem.unknownChoice'])
    expect(networks(odd)[0]!.hidden[0]!.neurons).toBe(1)
  })

  it('travel in files of Open Roberta and in our own', () => {
    const xml = writeOpenRoberta(deep)
    const back = readOpenRoberta(xml)
    expect(xmlTree(writeOpenRoberta(back))).toEqual(xmlTree(xml))
    expect(networks(back)[0]!.hidden).toEqual(networks(deep)[0]!.hidden)
    const pose = { x: 100, y: 100, heading: 0 }
    const robots = [{ id: 'bo', pose, program: 'main', brain: '', config: cardConfig }]
    const world = { size: { width: 200, height: 200 }, floor: { colour: '#FFFFFF' }, areas: [], lines: [] }
    const project = { botgarten: 1, name: 'deep', programs: { main: deep }, brains: {}, assets: {} }
    const kept = parseProject({ ...project, world: { ...world, obstacles: [], robots } })
    expect(kept.programs['main']).toEqual(deep)
  })
})
