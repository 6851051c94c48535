import { readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { addBlocks, blockFrom, type HostBrain, type Template } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { content } from '@botgarten/content/files'
import { indexProgram, runThread, startThread } from '../index.ts'
import { brainsIn } from '../open-roberta/brains.ts'
import { fileFrom, projectFrom, readOpenRoberta } from '../open-roberta/index.ts'
import { block, number } from '../testing/build.ts'
import { nextTick, recordingRobot } from '../testing/recording-robot.ts'
import { xmlTree } from '../testing/xml-tree.ts'

addBlocks(expert)

const neuron = (id: string) => ({ id, bias: 0 })
const net: HostBrain = { layers: [[neuron('n1')], [neuron('n2')]], weights: { n1: { n2: 2 } } }

/** Runs these rows, each after a start, on a robot with this network. */
function run(rows: readonly Template[], brain: HostBrain | undefined = net) {
  let count = 0
  const blocks = [{ type: 'robControls_start' }, ...rows].map((template) =>
    blockFrom(template, () => `b${count++}`),
  )
  const recording = recordingRobot()
  const index = indexProgram({ stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } })
  const thread = startThread(index)
  while (!thread.ended && recording.tick < 300) {
    runThread(thread, index, { ...recording.context, brain: () => brain })
    nextTick(recording)
  }
  return { thread, shown: recording.log.filter(([, verb]) => verb === 'display').map((entry) => entry[4]) }
}

const show = (value: Template) =>
  block('robActions_display_text', {}, { OUT: value, COL: number(0), ROW: number(0) })
const step = { type: 'robActions_NNstep' }
const input = (NAME: string, value: number) =>
  block('robActions_set_inputneuron_val', { NAME }, { VALUE: number(value) })
const link = (type: string, FROM: string, TO: string, value = 1) =>
  block(type, { FROM, TO }, { VALUE: number(value) })
const bias = (type: string, NAME: string) => block(type, { NAME }, { VALUE: number(1) })
const output = (NAME: string) => block('robSensors_get_outputneuron_val', { NAME })

/** Names that no neuron has, some of which every object has. */
const strange = ['n9', '', '__proto__', 'constructor', 'toString', 'n1 ', 'N1', 'ä'.repeat(10_000)]

describe('steps of a network that a program carries', () => {
  it('run on what was set, as often as they are asked', () => {
    const { thread, shown } = run([
      input('n1', 3),
      step,
      show(output('n2')),
      input('n1', 4),
      step,
      show(output('n2')),
    ])
    expect(thread.problem).toBeNull()
    expect(shown).toEqual(['6', '8'])
  })

  it('without a network they stop with a word', () => {
    const { thread } = run([step], { layers: [], weights: {} })
    expect(thread.ended).toBe(true)
    const none = run([input('n1', 3), step], null as never)
    expect(none.thread.problem?.problem).toBe('problem.noNetwork')
  })

  it.each(strange)('a link or a bias of a neuron %s stops with its name', (name) => {
    const asks: readonly Template[] = [
      link('robActions_set_weight', name, 'n2'),
      link('robActions_set_weight', 'n1', name),
      link('robActions_change_weight', name, 'n2'),
      bias('robActions_set_bias', name),
      bias('robActions_change_bias', name),
      show(block('robSensors_get_weight', { FROM: name, TO: 'n2' })),
      show(block('robSensors_get_bias', { NAME: name })),
    ]
    for (const row of asks) {
      const { thread } = run([row])
      expect(thread.problem?.problem, row.type).toBe('problem.noSuchNeuron')
      expect(JSON.stringify(thread.problem?.facts)).toContain(JSON.stringify(name).slice(1, -1))
    }
  })

  it.each(strange)('an output %s gives 0', (name) => {
    const { thread, shown } = run([input('n1', 3), step, show(output(name))])
    expect(thread.problem).toBeNull()
    expect(shown).toEqual(['0'])
  })

  it.each(strange)('a value for an input %s changes nothing of the network', (name) => {
    const { thread, shown } = run([input('n1', 3), input(name, 50), step, show(output('n2'))])
    expect(thread.problem).toBeNull()
    expect(shown).toEqual(['6'])
    expect(Object.hasOwn(Object.prototype, 'n1')).toBe(false)
  })
})

const garden = content.world('garden')!
const file = readFileSync(
  new URL('../testing/open-roberta/programs/upstream__xNN__nn_step.xml', import.meta.url),
  'utf8',
)
const withData = (data: string) =>
  file.replace(
    /<data>\{"learningRate"[^]*?<\/data>/,
    () => `<data>${data.replaceAll('&', '&amp;').replaceAll('<', '&lt;')}</data>`,
  )

/** What may stand where the network should be. */
const odd = {
  nothing: '',
  'no JSON': '{"learningRate":0.03,',
  'another shape': '[1,2,3]',
  null: 'null',
  'a network without inputs': '{"activationKey":"linear","networkShape":[]}',
  'names that every object has':
    '{"activationKey":"linear","networkShape":[],"inputs":["__proto__"],"outputs":["constructor"],"weights":[[["1"]],[[]]],"biases":[["0"],["0"]]}',
  'five thousand inputs': JSON.stringify({
    ...{ activationKey: 'linear', networkShape: [], outputs: ['b'], weights: [], biases: [] },
    inputs: Array.from({ length: 5000 }, (_, k) => `i${k}`),
  }),
  'depth without end': '['.repeat(50_000),
  'signs of XML': '</data><block type="evil">&amp;',
}

it.each(Object.entries(odd))(
  'a file whose network is %s opens, and is written back as it came',
  (_, data) => {
    const text = withData(data)
    expect(text).not.toBe(file)
    const program = readOpenRoberta(text)
    expect(Object.keys(brainsIn(program))).toEqual([])
    expect(xmlTree(fileFrom(projectFrom(text, 'x', garden), 'bo'))).toEqual(xmlTree(text))
  },
)

it('a file whose network is larger than a project may be is refused with a word', () => {
  const inputs = Array.from({ length: 100_000 }, (_, k) => `i${k}`)
  expect(() => readOpenRoberta(withData(JSON.stringify({ inputs })))).toThrow(
    expect.objectContaining({ reason: 'notOpenRoberta' }) as Error,
  )
})
