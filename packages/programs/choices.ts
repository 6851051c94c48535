import { definitions, type Definition, type FieldLook, type NeuronLook } from '@botgarten/blocks'
import {
  COLOURS,
  motorAt,
  motorPorts,
  type Colour,
  type RobotConfig,
  type SensorPort,
} from '@botgarten/simulation'
import type { NeuronOutline } from './types.ts'

/** A neuron that can be added. `isHere`: false for a colour missing on the floor. */
export interface NeuronChoice {
  readonly neuron: NeuronOutline
  readonly isHere: boolean
}

/** The robot and the layer that choices are for. */
export interface Surroundings {
  /** Neurons that the layer has. */
  readonly there: readonly NeuronOutline[]
  readonly config: RobotConfig
  /** Colours on the floor. */
  readonly onFloor: readonly Colour[]
}

/**
 * The neurons that a layer of a robot's network can still get: one for each value that a plugged-in sensor gives, and for
 * each part that the robot can use. Parts that are not plugged in and neurons that the layer has are left out. Of one kind the colours on the floor come first.
 */
export const neuronChoices = (
  layer: NeuronLook['layer'],
  surroundings: Surroundings,
): readonly NeuronChoice[] =>
  Object.values<Definition>(definitions)
    .filter(({ pack, outsideToolbox }) => pack === 'core' && !outsideToolbox)
    .flatMap(({ type, look: { fields }, neuron: look }) => {
      if (look?.layer !== layer) return []
      const neurons = combined(fields, look, surroundings).map((values) => ({
        id: [type, ...Object.values(values)].join(' '),
        ...{ type, fields: values, look },
      }))
      const choices = neurons
        .filter((neuron) => !surroundings.there.some((one) => isSame(one, neuron)))
        .map((neuron) => ({ neuron, isHere: isHere(neuron, surroundings.onFloor) }))
      return [...choices.filter((one) => one.isHere), ...choices.filter((one) => !one.isHere)]
    })

type Fields = NeuronOutline['fields']

/** Every combination of the values that the fields can have. */
const combined = (
  fields: readonly FieldLook[],
  look: NeuronLook,
  surroundings: Surroundings,
): readonly Fields[] =>
  fields.reduce<readonly Fields[]>(
    (found, field) =>
      found.flatMap((before) =>
        valuesOf(field, look, surroundings).map((value) => ({ ...before, [field.name]: value })),
      ),
    [{}],
  )

function valuesOf(field: FieldLook, look: NeuronLook, { there, config }: Surroundings): readonly string[] {
  if (field.kind !== 'choice') return [unusedWord(there)]
  const values = field.options.map(({ value }) => value)
  return field.name === look.port ? values.filter((value) => isPlugged(value, look, config)) : values
}

/** Values of a port's field end with the port: `ULTRASONIC_PORT_2`, `MOTORPORT_C`. */
function isPlugged(value: string, { sensor }: NeuronLook, config: RobotConfig): boolean {
  const port = value.at(-1)
  if (sensor !== undefined) return config.sensors[port as SensorPort]?.kind === sensor
  return motorPorts.some((one) => one === port && motorAt(config, one) !== undefined)
}

/** The first letter that no neuron shows yet: a word to begin with. */
function unusedWord(there: readonly NeuronOutline[]): string {
  const used = there.flatMap(({ fields }) => Object.values(fields))
  return [...'ABCDEFGHIJKLMNOPQRSTUVWXYZ'].find((letter) => !used.includes(letter)) ?? ''
}

const isSame = (a: NeuronOutline, b: NeuronOutline) =>
  a.type === b.type && Object.entries(b.fields).every(([name, value]) => a.fields[name] === value)

/** Colours that a sensor names are on the floor or not; everything else is where the robot is. */
function isHere({ look, fields }: NeuronOutline, onFloor: readonly Colour[]): boolean {
  if (look.layer === 'output' || typeof look.colour === 'string') return true
  const colour = fields[look.colour.field]
  return !Object.values<string>(COLOURS).includes(colour ?? '') || onFloor.some((one) => one === colour)
}
