import { definitions } from '@botgarten/blocks'
import type { NeuronOutline } from '@botgarten/programs'
import type { RobotConfig } from '@botgarten/simulation'
import { describe, expect, test } from 'vitest'
import { language } from '#words/language.svelte.ts'
import { drawn } from './neurons.ts'
import { colourOf, labelOf, placeOf, shortLabelOf } from './words.ts'

function neuron(type: keyof typeof definitions, fields: NeuronOutline['fields']): NeuronOutline {
  return { id: 'n', type, fields, look: definitions[type].neuron! }
}

const distance = (port: string) =>
  neuron('ai_nn_input_node_ultrasonic', { INPUTNODE: `ULTRASONIC_PORT_${port}` })
const motor = (port: string) => neuron('ai_nn_output_node', { OUTPUTNODE: `MOTORPORT_${port}` })
const lamp = neuron('ai_nn_output_node_led', { OUTPUTNODE: '#F7D118' })

const config: RobotConfig = {
  wheelDiameter: 5.6,
  trackWidth: 18,
  drive: { left: 'C', right: 'B' },
  sensors: {
    '1': { kind: 'colour', x: 5, y: 0, angle: 0 },
    '2': { kind: 'ultrasonic', x: 8, y: 4, angle: 20 },
    '3': { kind: 'ultrasonic', x: 8, y: -4, angle: -20 },
  },
}

describe('the words at a node', () => {
  test('say sensor and port, motor and port, in both languages', async () => {
    await language.speak('en')
    expect([labelOf(distance('2')), labelOf(motor('C'))]).toEqual(['distance, port 2', 'motor C'])
    await language.speak('de')
    expect([labelOf(distance('2')), labelOf(motor('C'))]).toEqual(['Abstand, Anschluss 2', 'Motor C'])
  })

  test('name a port only where sensors of one kind have two, and say the whole label to a screen reader', async () => {
    const colour = (COLOUR: string, SENSORPORT = '1') =>
      neuron('ai_nn_input_node_coloursensor_color', { COLOUR, SENSORPORT })
    const light = neuron('ai_nn_input_node_coloursensor_light', { SENSORPORT: '1' })
    const labels = (...layer: NeuronOutline[]) => layer.map((one) => shortLabelOf(one, layer))
    await language.speak('en')
    expect(labels(distance('2'))).toEqual(['distance'])
    expect(labels(colour('#00642E'), light, distance('2'))).toEqual(['colour green', 'light', 'distance'])
    expect(labels(distance('2'), distance('3'))).toEqual(['distance, port 2', 'distance, port 3'])
    expect(labels(colour('#00642E'), light, colour('#B30006', '4'))).toEqual([
      'colour green, port 1',
      'light, port 1',
      'colour red, port 4',
    ])
    expect(labels(motor('C'), lamp)).toEqual(['motor C', 'lamp orange-yellow'])
    const red = drawn(colour('#B30006'), config, new Set(), [colour('#B30006')])
    expect([red.label, red.name]).toEqual(['colour red', 'colour red, port 1 front'])
  })

  test('never show the code of a colour', async () => {
    for (const locale of ['en', 'de'] as const) {
      await language.speak(locale)
      expect(labelOf(lamp)).not.toContain('#')
    }
  })

  test('name a colour in either case, and the nearest name of one that has none', async () => {
    const sees = (COLOUR: string) =>
      labelOf(neuron('ai_nn_input_node_coloursensor_color', { COLOUR, SENSORPORT: '1' }))
    await language.speak('en')
    expect([sees('#00642E'), sees('#00642e'), sees('#b30006')]).toEqual([
      'colour green, port 1',
      'colour green, port 1',
      'colour red, port 1',
    ])
    expect(sees('#dc0000')).toBe('colour almost red, port 1')
    await language.speak('de')
    expect([sees('#0057a6'), sees('#0060b0')]).toEqual([
      'Farbe blau, Anschluss 1',
      'Farbe fast blau, Anschluss 1',
    ])
  })

  test('say where the sensor or the wheel is', () => {
    expect(placeOf(distance('2'), config)).toBe('network.place.frontLeft')
    expect(placeOf(distance('3'), config)).toBe('network.place.frontRight')
    expect(placeOf(motor('C'), config)).toBe('network.place.left')
    expect(placeOf(motor('B'), config)).toBe('network.place.right')
  })

  test('name no place where no such sensor is, no wheel turns, or there is no port', () => {
    expect(placeOf(distance('1'), config)).toBeNull()
    expect(placeOf(distance('4'), config)).toBeNull()
    expect(placeOf(motor('A'), config)).toBeNull()
    expect(placeOf(lamp, config)).toBeNull()
  })
})

test('every neuron block has words in both languages and a colour', async () => {
  const neurons = Object.values(definitions).filter((one) => one.neuron)
  expect(neurons.length).toBeGreaterThan(0)
  for (const { type, look, neuron: shape } of neurons) {
    const fields = Object.fromEntries(look.fields.map(({ name, preset }) => [name, String(preset)]))
    const outline: NeuronOutline = { id: 'n', type, fields, look: shape! }
    expect(colourOf(outline)).toMatch(/^#[0-9A-F]{6}$/i)
    for (const locale of ['en', 'de'] as const) {
      await language.speak(locale)
      expect(labelOf(outline)).not.toBe(shape!.label)
      expect(labelOf(outline)).not.toMatch(/[{}#_]/)
    }
  }
})
