import type { PythonAt } from '@botgarten/blocks'
import type { MotorPort, SensorPort } from '@botgarten/simulation'
import type { NetworkOutline, NeuronOutline } from '../types.ts'
import type { Draft } from './draft.ts'
import { motorName } from './robots/devices.ts'

const lamps: { readonly [colour: string]: string } = {
  '#00642E': 'GREEN',
  '#F7D118': 'ORANGE',
  '#B30006': 'RED',
}

const portOf = ({ fields }: NeuronOutline, name: string) => (fields[name] ?? '').slice(-1)
const motorOf = (neuron: NeuronOutline) => portOf(neuron, 'OUTPUTNODE') as MotorPort
const lampOf = ({ fields }: NeuronOutline) =>
  lamps[(fields['OUTPUTNODE'] ?? fields['COLOUR'] ?? '').toUpperCase()] ?? 'GREEN'
const kindOf = ({ type }: NeuronOutline) => /^ai_nn_output_node_?(\w*)$/.exec(type)?.[1] ?? ''

const channels: { readonly [colour: string]: string } = {
  '#FF0000': 'red',
  '#00FF00': 'green',
  '#0000FF': 'blue',
}

/** How an input neuron reads its sensor: 0..100. */
export function reading(at: PythonAt, neuron: NeuronOutline): string {
  const { type, fields } = neuron
  const distance = type.endsWith('ultrasonic')
  const port = portOf(neuron, distance ? 'INPUTNODE' : 'SENSORPORT') as SensorPort
  const read = (what: string) =>
    at.robot.read(distance ? 'ultrasonic' : 'colour', port, what)?.code ?? at.gap('problem.unknownChoice')
  if (distance) return at.call('distance', read('device'))
  if (type.endsWith('light')) return read('light')
  const colour = (fields['COLOUR'] ?? '').toUpperCase()
  if (type.endsWith('color')) return at.call('sees', read('device'), at.robot.colour(colour))
  return read(channels[colour] ?? 'red')
}

/** Names of the outputs' values: what they set. */
export const namesOf = (draft: Draft, { outputs }: NetworkOutline): readonly string[] =>
  outputs.map((neuron) => draft.names.of(`neuron ${neuron.id}`, wanted(draft, neuron)))

function wanted(draft: Draft, neuron: NeuronOutline): string {
  switch (kindOf(neuron)) {
    case 'led':
      return lampOf(neuron).toLowerCase()
    case 'sound':
      return 'tone_level'
    case 'text':
      return (neuron.fields['OUTPUTNODE'] ?? '').toLowerCase() || 'word'
    default:
      return motorName(draft, motorOf(neuron)).replace('_motor', '')
  }
}

type Write = (neurons: readonly NeuronOutline[], line: () => void) => void

/** Motors and words each for itself, of the lamps and of the tones the highest (semantics.md, rule 15). */
export function outputLines(
  draft: Draft,
  at: PythonAt,
  { outputs }: NetworkOutline,
  names: readonly string[],
  write: Write,
): void {
  const of = (kind: string) =>
    outputs.flatMap((neuron, k) => (kindOf(neuron) === kind ? [{ neuron, name: names[k]! }] : []))
  for (const { neuron, name } of of(''))
    write([neuron], () => draft.line(at.robot.motor(motorOf(neuron), name)))
  const words = of('text').map((one) => ({ ...one, word: at.quote(one.neuron.fields['OUTPUTNODE'] ?? '') }))
  if (draft.input.dialect === 'spike' && words.length > 1)
    write(neuronsOf(words), () => showHighest(draft, at, words))
  else
    words.forEach(({ neuron, name, word }, row) =>
      write([neuron], () => draft.line(at.robot.show(`${word} if ${name} > 0 else "-"`, '0', String(row)))),
    )
  const lit = of('led')
  const pairs = lit.map(({ neuron, name }) => `(${name}, ${at.robot.lampColour(lampOf(neuron))})`)
  if (lit.length > 0)
    write(neuronsOf(lit), () => draft.line(at.call('lamp', at.call('highest', `[${pairs.join(', ')}]`))))
  const tones = of('sound')
  const levels = tones.map(({ name }) => name).join(', ')
  if (tones.length > 0)
    write(neuronsOf(tones), () => draft.line(at.call('hum', tones.length > 1 ? `max(${levels})` : levels)))
}

const neuronsOf = (outputs: readonly { readonly neuron: NeuronOutline }[]) =>
  outputs.map(({ neuron }) => neuron)

/** The hub of SPIKE Prime has room for one word. */
function showHighest(
  draft: Draft,
  at: PythonAt,
  words: readonly { readonly name: string; readonly word: string }[],
): void {
  const pairs = words.map(({ name, word }) => `(${name}, ${word})`)
  draft.line(at.robot.show(`${at.call('highest', `[${pairs.join(', ')}]`)} or "-"`, '0', '0'))
}
