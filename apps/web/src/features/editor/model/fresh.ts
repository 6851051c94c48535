import type * as Blockly from 'blockly/core'
import {
  definitions,
  isBlockType,
  type FieldLook,
  type Look,
  type NeuronLook,
  type Template,
} from '@botgarten/blocks'
import { COLOURS, type Colour, type RobotConfig, type SensorPort } from '@botgarten/simulation'
import { faceOf, isBotBlock, type BotBlock } from './bot-block.ts'

interface Surroundings {
  readonly config: RobotConfig
  readonly onFloor: () => readonly Colour[]
}

// The parts of the robot that a workspace's program drives, and the floor under it: new neurons take ports and colours that
// fit.
const surroundings = new WeakMap<Blockly.Workspace, Surroundings>()

/** @param onFloor colours of the floor, read when a neuron is added */
export const knowRobot = (
  workspace: Blockly.Workspace,
  config: RobotConfig,
  onFloor: () => readonly Colour[] = () => [],
): void => {
  surroundings.set(workspace, { config, onFloor })
}

type Choice = Extract<FieldLook, { kind: 'choice' }>

/** What a new line of a list comes with: one more of what stands in its last line, at the port that fits best. */
export function freshNeuron(list: BotBlock): Template | null {
  const preset = faceOf(list)?.items?.fresh
  if (!preset) return null
  const neurons = (list.extra.lines ?? []).map((line) => list.getInputTargetBlock(line)).filter(isBotBlock)
  const last = neurons.at(-1)
  const one = last ? templateOf(last) : preset
  const definition = isBlockType(one.type) ? definitions[one.type] : undefined
  const told = definition && tellingField(definition.look, definition.neuron)
  if (!told) return one
  const used = neurons.filter(({ type }) => type === one.type).map((neuron) => fieldOf(neuron, told.name))
  const around = surroundings.get(list.workspace)
  const fits = around ? fitIn(around, told.name, definition.neuron) : anyFits
  return { ...one, fields: { ...one.fields, [told.name]: best(told, one.fields?.[told.name], used, fits) } }
}

const fieldOf = (block: BotBlock, name: string) => String(block.getFieldValue(name))

const templateOf = (block: BotBlock): Template => ({
  type: block.type,
  fields: Object.fromEntries(block.definition.look.fields.map(({ name }) => [name, fieldOf(block, name)])),
})

/** The choice in which neurons of one kind differ: their colour, else their port, else the first there is. */
function tellingField({ fields }: Look, neuron: NeuronLook | undefined): Choice | undefined {
  const choices = fields.filter((field) => field.kind === 'choice')
  const colour = typeof neuron?.colour === 'object' ? neuron.colour.field : undefined
  const name = colour ?? neuron?.port
  return choices.find((choice) => choice.name === name) ?? choices[0]
}

/**
 * How well a value fits. A port: 0 its sensor or motor is plugged in, 1 it is free, 2 it has another sensor. A colour that
 * the sensor names: 0 the floor has it, 1 the floor does not.
 */
type Fit = (value: string) => 0 | 1 | 2
const anyFits: Fit = () => 0

function fitIn({ config, onFloor }: Surroundings, field: string, neuron: NeuronLook | undefined): Fit {
  if (neuron && field === neuron.port) return fit(neuron, config)
  if (neuron?.layer !== 'input') return anyFits
  const here = onFloor()
  const named = Object.values<string>(COLOURS)
  return (value) => (!named.includes(value) || here.some((colour) => colour === value) ? 0 : 1)
}

/** Values end with their port: `ULTRASONIC_PORT_2`, `MOTORPORT_C`. */
function fit({ sensor }: NeuronLook, { sensors, drive }: RobotConfig): Fit {
  if (sensor === undefined)
    return (value) => ([drive.left, drive.right].some((port) => value.endsWith(port)) ? 0 : 1)
  return (value) => {
    const kind = sensors[value.at(-1) as SensorPort]?.kind
    return kind === sensor ? 0 : kind === undefined ? 1 : 2
  }
}

/**
 * The best value, of equals the first after the last one in use: one that fits before a free port, both before one that
 * is used already, and that before one where something else sits.
 */
function best({ options }: Choice, present: string | undefined, used: readonly string[], fits: Fit): string {
  const values = options.map(({ value }) => value)
  const from = values.indexOf(present ?? '') + (used.length > 0 ? 1 : 0)
  const after = [...values.slice(from), ...values.slice(0, from)]
  const rank = (value: string) => (fits(value) === 2 ? 4 : fits(value) + (used.includes(value) ? 2 : 0))
  return after.reduce((found, value) => (rank(value) < rank(found) ? value : found), after[0] ?? '')
}
