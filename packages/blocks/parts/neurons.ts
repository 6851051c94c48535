import { part } from './python.ts'
import type { ReadMode } from '@botgarten/simulation'
import type { BlockType } from '../packs/packs.ts'
import type { Block, Definition, FieldLook, Frame, Look, Pack, Value } from '../types.ts'
import { sensorPortIn } from './fields.ts'
import { rows, words } from './looks.ts'
import { fail, give } from './next.ts'
import { numberAt } from './numbers.ts'
import { sensorAtPort, type Missed } from './sensors.ts'

const look = (type: BlockType, output: 'InputNode' | 'OutputNode', fields: readonly FieldLook[]): Look => ({
  category: 'network',
  shape: 'value',
  output,
  fields,
  inputs: [],
  rows: rows(type, 1),
})

interface InputNeuron {
  readonly type: BlockType
  readonly pack: Pack
  readonly sensor: Missed
  /** Field that names the port, and what stands before the port's number in it. */
  readonly port: string
  readonly prefix?: string
  readonly fields: readonly FieldLook[]
  readonly label: string
  readonly colour: 'sensor' | { readonly field: string }
  readonly mode: ReadMode | ((block: Block) => ReadMode)
  /** From the sensor's reading to 0..100. */
  readonly level: (reading: Value, block: Block) => number
  readonly example: Definition['example']
}

/** A neuron that reads a sensor and gives 0..100. */
export function inputNeuron(neuron: InputNeuron): Definition {
  const { type, pack, port, mode } = neuron
  return {
    type,
    pack,
    look: look(type, 'InputNode', neuron.fields),
    words: words(type),
    neuron: { layer: 'input', label: neuron.label, port, colour: neuron.colour, sensor: neuron.sensor },
    acts: true,
    check: sensorAtPort(neuron.sensor, port, neuron.prefix),
    run(block, _frame, { robot }) {
      const socket = sensorPortIn(block, port)
      const how = typeof mode === 'string' ? mode : mode(block)
      const reading = socket === undefined ? null : robot.read(socket, how)
      return reading === null ? fail('nothingToRead') : give(neuron.level(reading, block))
    },
    python: part,
    example: neuron.example,
  }
}

interface OutputNeuron {
  readonly type: BlockType
  readonly pack: Pack
  readonly uses?: Definition['uses']
  readonly fields: readonly FieldLook[]
  readonly label: string
  readonly port?: string
  readonly colour: 'actuator' | { readonly field: string }
  readonly run: Definition['run']
  readonly example: Definition['example']
}

/** A neuron that turns the level it is given into an order; the network block carries the orders out. */
export function outputNeuron(neuron: OutputNeuron): Definition {
  const { type, pack, uses, label, colour } = neuron
  const port = neuron.port === undefined ? {} : { port: neuron.port }
  return {
    type,
    pack,
    look: look(type, 'OutputNode', neuron.fields),
    words: words(type),
    neuron: { layer: 'output', label, colour, ...port },
    acts: false,
    ...(uses && { uses }),
    run: neuron.run,
    python: part,
    example: neuron.example,
  }
}

/** The level an output neuron was given. */
export const levelOf = (frame: Frame): number => numberAt(frame, 0)
