import { sensorPortIn, type Block } from '@botgarten/blocks'
import type { SensorPort } from '@botgarten/simulation'
import { functionBlocks, startingStacks } from '../run/index-program.ts'
import type { Program } from '../types.ts'
import { within } from './names.ts'
import { definitionOf } from './places.ts'
import { reachedIn } from './reached.ts'

/** What of its robot a program comes to, as far as is known without running. */
export interface Uses {
  /** Ports whose sensors it reads. */
  readonly ports: readonly SensorPort[]
  /** Ports whose sensors it asks for a colour, and for the brightness. */
  readonly colour: readonly SensorPort[]
  readonly light: readonly SensorPort[]
  readonly lamp: boolean
  readonly display: boolean
  readonly sound: boolean
  readonly speech: boolean
}

/** Timers are counted, not plugged in. */
const isTimer = ({ type, fields }: Block) =>
  /^robSensors_timer/.test(type) || /^TIMER/.test(fields?.['SENSORTYPE'] ?? '')

const portOf = (block: Block): SensorPort | undefined =>
  isTimer(block) ? undefined : (sensorPortIn(block, 'SENSORPORT') ?? sensorPortIn(block, 'INPUTNODE'))

const asksColour = ({ type, fields }: Block) =>
  type === 'ai_nn_input_node_coloursensor_color' ||
  /COLOUR$/.test(fields?.['MODE'] ?? fields?.['SENSORTYPE'] ?? '')
const asksLight = ({ type, fields }: Block) =>
  type === 'ai_nn_input_node_coloursensor_light' ||
  /LIGHT$/.test(fields?.['MODE'] ?? fields?.['SENSORTYPE'] ?? '')

const portsOf = (blocks: readonly Block[]): readonly SensorPort[] =>
  [...new Set(blocks.map(portOf).filter((port) => port !== undefined))].sort()

export function usesOf(program: Program): Uses {
  const reached = reachedIn(program)
  const rows = [...(startingStacks(program)[0]?.blocks ?? []), ...functionBlocks(program)]
  const blocks = rows.flatMap(within).filter(({ id }) => reached.has(id))
  const parts = new Set(blocks.map((block) => definitionOf(block)?.uses))
  return {
    ports: portsOf(blocks),
    colour: portsOf(blocks.filter(asksColour)),
    light: portsOf(blocks.filter(asksLight)),
    lamp: parts.has('lamp'),
    display: parts.has('display'),
    sound: parts.has('sound'),
    speech: parts.has('speech'),
  }
}
