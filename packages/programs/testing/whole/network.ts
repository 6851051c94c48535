import type { Block } from '@botgarten/blocks'
import type { LedColour, MotorPort, SensorPort } from '@botgarten/simulation'
import { fieldOf, percent } from './parts.ts'
import { Failure, type Steps, type WholeTwin } from './twin.ts'

/** Rule 15: reads, thinks, executes. */
export function* network(twin: WholeTwin, block: Block): Steps<void> {
  const { robot } = twin.host
  const levels: number[] = []
  for (const neuron of yield* layer(twin, block, 'INPUT_LAYER')) levels.push(yield* level(twin, neuron))
  const thought = twin.host.think(block.id, levels)
  const outputs: { readonly neuron: Block; readonly level: number }[] = []
  for (const neuron of yield* layer(twin, block, 'OUTPUT_LAYER')) {
    yield 'block'
    outputs.push({ neuron, level: thought[outputs.length] ?? 0 })
  }
  const of = (ending: string) => outputs.filter(({ neuron }) => neuron.type === `ai_nn_output_node${ending}`)
  const best = (all: typeof outputs) => {
    const most = Math.max(0, ...all.map((output) => output.level))
    return most > 0 ? all.find((output) => output.level === most) : undefined
  }
  for (const { neuron, level } of of(''))
    robot.motor(fieldOf(neuron, 'OUTPUTNODE').slice(-1) as MotorPort, percent(level))
  of('_text').forEach(({ neuron, level }, row) =>
    robot.display(row, 0, level > 0 ? fieldOf(neuron, 'OUTPUTNODE') : '∅'),
  )
  const lamps: { readonly [colour: string]: LedColour } = {
    ...{ '#00642E': 'green', '#F7D118': 'orange', '#B30006': 'red' },
  }
  if (of('_led').length > 0) {
    const bright = best(of('_led'))
    robot.led(bright ? lamps[fieldOf(bright.neuron, 'OUTPUTNODE')]! : null)
  }
  if (of('_sound').length > 0) robot.tone((best(of('_sound'))?.level ?? 0) * 5, null)
}

function* layer(twin: WholeTwin, block: Block, name: string): Steps<readonly Block[]> {
  yield 'block'
  const first = block.values?.[name]
  // What a hidden layer makes of it is the network's own affair.
  if (first?.type === 'ai_nn_hidden_layer') return yield* layer(twin, first, 'LAYER')
  return Object.values(block.values?.[name]?.values ?? {}).filter(({ disabled }) => disabled !== true)
}

function* level(twin: WholeTwin, neuron: Block): Steps<number> {
  twin.acts += 1
  yield 'block'
  const { robot } = twin.host
  const port = (fieldOf(neuron, 'SENSORPORT') || fieldOf(neuron, 'INPUTNODE').slice(-1)) as SensorPort
  const read = (mode: 'distance' | 'light' | 'colour' | 'red' | 'green' | 'blue') => {
    const reading = robot.read(port, mode)
    if (reading === null) throw new Failure(neuron, 'nothingToRead')
    return reading
  }
  if (neuron.type.endsWith('ultrasonic')) return Math.min(100, Number(read('distance')))
  if (neuron.type.endsWith('light')) return Number(read('light'))
  if (neuron.type.endsWith('color')) return read('colour') === fieldOf(neuron, 'COLOUR') ? 100 : 0
  const channel = ({ '#FF0000': 'red', '#00FF00': 'green', '#0000FF': 'blue' } as const)[
    fieldOf(neuron, 'COLOUR') as '#FF0000'
  ]
  return (Number(read(channel)) * 100) / 255
}
