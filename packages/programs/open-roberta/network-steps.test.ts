import { addBlocks, type Template } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { follow, forward, layOut, type Brain } from '@botgarten/learning/neural-network/brain'
import fc from 'fast-check'
import * as v from 'valibot'
import { describe, expect, it } from 'vitest'
import { check, indexProgram, networks, runThread, startThread, type Program } from '../index.ts'
import { block, forever, net, programOf, start } from '../testing/build.ts'
import { cardSensors, nextTick, recordingRobot } from '../testing/recording-robot.ts'
import { programSchema } from '../project/schema-program.ts'
import { brainsIn } from './brains.ts'
import { readOpenRoberta, writeOpenRoberta } from './index.ts'
import { strangersIn } from './known.ts'
import { inSteps } from './network-steps.ts'

addBlocks(expert)
addBlocks(learning)

const eye = (port: string) => block('ai_nn_input_node_ultrasonic', { INPUTNODE: `ULTRASONIC_PORT_${port}` })
const light = block('ai_nn_input_node_coloursensor_light', { SENSORPORT: '1' })
const colour = (COLOUR: string) => block('ai_nn_input_node_coloursensor_color', { COLOUR, SENSORPORT: '1' })
const channel = (COLOUR: string) =>
  block('ai_nn_input_node_coloursensor_rgb_channel', { COLOUR, SENSORPORT: '1' })
const motor = (port: string) => block('ai_nn_output_node', { OUTPUTNODE: `MOTORPORT_${port}` })
const lamp = (OUTPUTNODE: string) => block('ai_nn_output_node_led', { OUTPUTNODE })
const word = (OUTPUTNODE: string) => block('ai_nn_output_node_text', { OUTPUTNODE })
const tone = block('ai_nn_output_node_sound')

const inputs = fc.array(
  fc.constantFrom(eye('2'), eye('3'), light, colour('#b30006'), colour('#FFFFFF'), channel('#00FF00')),
  { minLength: 1, maxLength: 4 },
)
const outputs = fc.array(
  fc.constantFrom(
    ...[motor('B'), motor('C'), word('Ja'), word('Nein')],
    ...['#00642E', '#F7D118', '#B30006'].map(lamp),
  ),
  { minLength: 1, maxLength: 5 },
)
const weight = fc.integer({ min: -20, max: 20 }).map((tenths) => tenths / 10)

/** What a robot is told in ten ticks, thinking left out. */
function told(program: Program, brain: Brain | undefined) {
  const recording = recordingRobot()
  const index = indexProgram(program)
  const thread = startThread(index)
  const think = (_id: string, values: readonly number[]) => [...forward(layOut(brain!), values)]
  for (let tick = 0; tick < 10; tick++) {
    runThread(thread, index, { ...recording.context, think, brain: () => brain })
    nextTick(recording)
  }
  expect(thread.problem).toBeNull()
  return recording.log
}

/** What has the same effect within a tick, whatever came first: the last order for each part counts. */
const effects = (log: ReturnType<typeof told>) => {
  const last = new Map<string, unknown>()
  for (const [tick, verb, ...facts] of log) {
    const part = ['motor', 'display'].includes(verb) ? `${verb} ${String(facts[0])}` : verb
    last.set(`${tick} ${part}`, facts)
  }
  return new Map([...last].sort(([a], [b]) => (a < b ? -1 : 1)))
}

/** A program's one network with these weights, in the order of its links; what is missing is 0.5. */
function brainOf(program: Program, weights: readonly number[]): { readonly [id: string]: Brain } {
  const [outline] = networks(program)
  const layers = [outline!.inputs, outline!.outputs].map((neurons) => neurons.map(({ id }) => id))
  const rows = layers[0]!.map((from, i) => [
    from,
    Object.fromEntries(layers[1]!.map((to, k) => [to, weights[i * layers[1]!.length + k] ?? 0.5])),
  ])
  const brain = follow({ kind: 'network', layers: [[], []], weights: {}, sets: {} }, ...layers)
  return { [outline!.id]: { ...brain, weights: Object.fromEntries(rows) as Brain['weights'] } }
}

const looping = (...row: Template[]) => programOf([start, forever(...row)])

describe('a network in Open Roberta’s own blocks', () => {
  it('does what the network does, tick by tick, also after the way through a file', () => {
    fc.assert(
      fc.property(inputs, outputs, fc.array(weight, { maxLength: 20 }), (read, drive, weights) => {
        const program = looping(net(read, drive))
        const brains = brainOf(program, weights)
        const steps = inSteps(program, brains)
        if (typeof steps === 'string') throw new Error(steps)
        expect(strangersIn(program)).toEqual(['network'])
        expect(strangersIn(steps)).toEqual([])
        expect(v.is(programSchema, steps)).toBe(true)
        expect(check(steps, { sensors: cardSensors })).toEqual([])
        const back = readOpenRoberta(writeOpenRoberta(steps))
        const [after] = Object.values(brainsIn(back))
        expect(effects(told(back, after))).toEqual(effects(told(program, Object.values(brains)[0])))
      }),
      { seed: 38, numRuns: 200 },
    )
  })

  it('carries the weights of the set that the robot drives with', () => {
    const program = looping(net([eye('2')], [motor('C')]))
    const [[id, brain]] = Object.entries(brainOf(program, [1])) as [[string, Brain]]
    const [from] = Object.keys(brain.weights)
    const [to] = Object.keys(brain.weights[from!]!)
    const brave = { ...brain, sets: { brave: { [from!]: { [to!]: 0.000_000_3 } } } }
    const steps = inSteps(program, { [id]: brave }, 'brave') as Program
    expect(Object.values(brainsIn(steps))[0]!.weights).toEqual({ i1: { o1: 0.000_000_3 } })
  })

  it('is not there for what Open Roberta’s network cannot say, and the reason is named', () => {
    const hidden = (ACTIVATION: string): Program => {
      const program = looping(net([eye('2')], [motor('C')]))
      return JSON.parse(
        JSON.stringify(program).replace(
          /"INPUT_LAYER":(\{.*?\}\}\})/,
          `"INPUT_LAYER":{"id":"h","type":"ai_nn_hidden_layer","fields":{"NEURONS":"2","ACTIVATION":"${ACTIVATION}"},"values":{"LAYER":$1}}`,
        ),
      ) as Program
    }
    expect(inSteps(hidden('TANH'), {})).toBe('curved')
    expect(inSteps(hidden('LINEAR'), {})).toMatchObject({ stacks: [{}] })
    expect(inSteps(looping(net([eye('2')], [tone])), {})).toBe('tone')
    expect(inSteps(looping(net([light], [motor('C')]), net([light], [motor('B')])), {})).toBe(
      'severalNetworks',
    )
    expect(inSteps(programOf([net([light], [motor('C')])]), {})).toBe('noStart')
  })
})

it('what today’s Open Roberta does not know is named by what it belongs to', () => {
  const all = looping(
    net([light], [motor('C')]),
    block('ai_q_learner_config'),
    block('ai_sorting_collect'),
    block('robSensors_odometry_getSample'),
    block('robActions_brand_new'),
  )
  expect(strangersIn(all)).toEqual(['learning', 'network', 'position', 'sorting'])
})
