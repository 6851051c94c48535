import { cardConfig, COLOURS, withMotor, withoutSensor } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { networks } from './networks.ts'
import { neuronChoices } from './choices.ts'
import { block, net, programOf, start } from './testing/build.ts'

const eye = (port: string) => block('ai_nn_input_node_ultrasonic', { INPUTNODE: `ULTRASONIC_PORT_${port}` })
const motor = (port: string) => block('ai_nn_output_node', { OUTPUTNODE: `MOTORPORT_${port}` })
const colour = (value: string) =>
  block('ai_nn_input_node_coloursensor_color', { COLOUR: value, SENSORPORT: '1' })
const word = (text: string) => block('ai_nn_output_node_text', { OUTPUTNODE: text })

const outlineOf = (...layers: Parameters<typeof net>) => networks(programOf([start, net(...layers)]))[0]!

/** Choices as the values of their fields, after the end of their type; in brackets where the floor lacks the colour. */
const told = (choices: ReturnType<typeof neuronChoices>) =>
  choices.map(({ neuron, isHere }) => {
    const [, ...kind] = neuron.type.split('_node')
    const text = [...kind, ...Object.values(neuron.fields)].join(' ').trim()
    return isHere ? text : `(${text})`
  })

const inputs = (
  there: Parameters<typeof net>[0],
  config = cardConfig,
  onFloor = [COLOURS.white, COLOURS.yellow],
) => told(neuronChoices('input', { there: outlineOf(there, []).inputs, config, onFloor }))
const outputs = (there: Parameters<typeof net>[1], config = cardConfig) =>
  told(neuronChoices('output', { there: outlineOf([], there).outputs, config, onFloor: [] }))

describe('neurons that can be added', () => {
  it('are the values of plugged-in sensors, the colours on the floor before others', () => {
    expect(inputs([])).toEqual([
      '_coloursensor_color #F7D117 1',
      '_coloursensor_color #FFFFFF 1',
      ...['#000000', '#0057A6', '#00642E', '#B30006', '#532115', '#585858'].map(
        (one) => `(_coloursensor_color ${one} 1)`,
      ),
      '_coloursensor_light 1',
      '_coloursensor_rgb_channel #FF0000 1',
      '_coloursensor_rgb_channel #00FF00 1',
      '_coloursensor_rgb_channel #0000FF 1',
      '_ultrasonic ULTRASONIC_PORT_2',
      '_ultrasonic ULTRASONIC_PORT_3',
    ])
  })

  it('are none that the network has, and none of a sensor that is not plugged in', () => {
    expect(inputs([eye('2'), eye('3')]).filter((one) => one.includes('ultra'))).toEqual([])
    expect(inputs([colour('#F7D117')])).not.toContain('_coloursensor_color #F7D117 1')
    const blind = withoutSensor(withoutSensor(cardConfig, '1'), '3')
    expect(inputs([], blind)).toEqual(['_ultrasonic ULTRASONIC_PORT_2'])
    expect(inputs([], withoutSensor(blind, '2'))).toEqual([])
  })

  it('are the motors that are plugged in, lamps, one tone, and always another word', () => {
    expect(outputs([motor('B')])).toEqual(
      [' MOTORPORT_C', '_led #00642E', '_led #F7D118', '_led #B30006', '_sound', '_text A'].map((one) =>
        one.trim(),
      ),
    )
    expect(outputs([], withMotor(cardConfig, 'D', { kind: 'medium' }))).toContain('MOTORPORT_D')
    expect(outputs([word('A'), word('C')])).toContain('_text B')
    expect(outputs([block('ai_nn_output_node_sound')])).not.toContain('_sound')
  })
})
