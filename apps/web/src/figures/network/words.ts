import { definitions, isBlockType, nearestOption, optionFor, type FieldLook } from '@botgarten/blocks'
import type { NeuronOutline } from '@botgarten/programs'
import type { RobotConfig, SensorPlace, SensorPort } from '@botgarten/simulation'
import { message } from '#words/message.ts'

/** The fields of a neuron as a child reads them: `ULTRASONIC_PORT_2` is "2", `#00642E` is "green". */
function shownFields({ type, fields }: NeuronOutline): { readonly [name: string]: string } {
  const looks = isBlockType(type) ? definitions[type].look.fields : []
  const shown = { ...fields }
  for (const look of looks) {
    if (look.kind !== 'choice') continue
    shown[look.name] = shownChoice(look, fields[look.name] ?? look.preset)
  }
  return shown
}

function shownChoice({ options }: Extract<FieldLook, { kind: 'choice' }>, value: string): string {
  const option = optionFor(options, value)
  if (option) return option.words ? message(option.words) : option.value
  const near = nearestOption(options, value)
  return near?.words ? message('choice.almost', { name: message(near.words) }) : value
}

const nameOf = (neuron: NeuronOutline) => message(neuron.look.label, shownFields(neuron))

/** A neuron's whole label: "distance, port 2". */
export const labelOf = (neuron: NeuronOutline): string =>
  neuron.look.sensor
    ? message('neuron.port', { label: nameOf(neuron), port: portOf(neuron)! })
    : nameOf(neuron)

/** Label of a node: "distance" if no sensor of this kind in the layer is at another port, else its whole label. */
export const shortLabelOf = (neuron: NeuronOutline, layer: readonly NeuronOutline[]): string =>
  layer.every((one) => one.look.sensor !== neuron.look.sensor || portOf(one) === portOf(neuron))
    ? nameOf(neuron)
    : labelOf(neuron)

/** `ULTRASONIC_PORT_2` and `MOTORPORT_C` end with their port. */
const portOf = ({ look, fields }: NeuronOutline) => look.port && fields[look.port]?.at(-1)

/** Where the sensor or wheel of a neuron is: a message key, or null where there is no place to name. */
export function placeOf(neuron: NeuronOutline, config: RobotConfig): string | null {
  const { look } = neuron
  const port = portOf(neuron)
  if (!port) return null
  if (look.layer === 'output') return wheelPlace(port, config)
  const sensor = config.sensors[port as SensorPort]
  return sensor && sensor.kind === look.sensor ? sensorPlace(sensor) : null
}

function wheelPlace(port: string, { drive }: RobotConfig): string | null {
  if (port === drive.left) return 'network.place.left'
  return port === drive.right ? 'network.place.right' : null
}

function sensorPlace({ x, y }: SensorPlace): string {
  const along = x > 1 ? 'front' : x < -1 ? 'back' : ''
  const aside = y > 1 ? 'left' : y < -1 ? 'right' : ''
  const key = along && aside ? along + aside[0]!.toUpperCase() + aside.slice(1) : along || aside || 'middle'
  return `network.place.${key}`
}

/** The colour of a node's ring and its chips. */
export function colourOf({ look, fields }: NeuronOutline): string {
  if (look.colour === 'sensor') return '#2F9C95'
  if (look.colour === 'actuator') return '#F28C45'
  const colour = fields[look.colour.field] ?? ''
  return /^#[0-9a-f]{6}$/i.test(colour) ? colour : '#8C7152'
}
