import { expect, it } from 'vitest'
import { addBlocks, type Template } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import {
  block,
  compare,
  distance,
  forever,
  lamp,
  net,
  number,
  programOf,
  show,
  start,
} from '../testing/build.ts'
import { usesOf } from './uses.ts'

addBlocks(expert)

const uses = (...rows: Template[]) => usesOf(programOf([start, ...rows]))
const nothing = { ports: [], colour: [], light: [], lamp: false, display: false, sound: false, speech: false }

const eye = (port: string) => block('ai_nn_input_node_ultrasonic', { INPUTNODE: `ULTRASONIC_PORT_${port}` })
const green = block('ai_nn_input_node_coloursensor_color', { COLOUR: '#00642E', SENSORPORT: '1' })
const tone = block('ai_nn_output_node_sound')

it('a program of the start block alone uses nothing', () => {
  expect(uses()).toEqual(nothing)
})

it('a network uses the ports of its neurons, and what its outputs show or sound with', () => {
  expect(uses(forever(net([eye('3'), eye('2'), green], [tone])))).toEqual({
    ...nothing,
    ports: ['1', '2', '3'],
    colour: ['1'],
    sound: true,
  })
})

it('a sensor block uses its port, and each block what it shows', () => {
  const near = { ...block('robControls_if'), values: { IF0: compare('LT', distance('2'), number(9)) } }
  expect(uses(near, lamp('RED'), show(number(1)))).toEqual({
    ...nothing,
    ports: ['2'],
    lamp: true,
    display: true,
  })
})

it('a robot that says something has no tone', () => {
  const said = { ...block('robActions_sayText'), values: { OUT: number(1) } }
  expect(uses(said)).toEqual({ ...nothing, speech: true })
})

it('the number of a timer is no port', () => {
  const timer = block('robSensors_timer_getSample', { MODE: 'VALUE', SENSORPORT: '1', SLOT: '' })
  expect(uses(show(timer))).toEqual({ ...nothing, display: true })
})

it('what no start block comes to does not count: behind an endless loop, or loose', () => {
  expect(uses(forever(), net([eye('2')], [tone]))).toEqual(nothing)
})
