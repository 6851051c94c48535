import { cardConfig, COLOURS, withoutSensor } from '@botgarten/simulation'
import type { Block } from '@botgarten/blocks'
import { afterEach, describe, expect, it } from 'vitest'
import { knowRobot } from './fresh.ts'
import { addLine } from './list.ts'
import { addNeuron } from './network.ts'
import { Bench, distance, motor, network } from './test-bench.ts'

let bench: Bench
afterEach(() => bench.dispose())

/** Adds a neuron to a net on a robot with sensors, and says at which port. */
function added(layer: 'input' | 'output', robot = cardConfig): string {
  knowRobot(bench.workspace, robot)
  const id = addNeuron(bench.workspace, 'net', layer)!
  return String(bench.block(id).getFieldValue(layer === 'input' ? 'INPUTNODE' : 'OUTPUTNODE')).at(-1)!
}

describe('a new neuron', () => {
  it('takes a port where its sensor sits before a free one', () => {
    bench = new Bench(network([distance('a', '3')], [motor('m', 'C')]))
    expect(added('input')).toBe('2')
  })

  it('takes a free port when all its sensors are in use, and never one where something else sits', () => {
    bench = new Bench(network([distance('a', '2'), distance('b', '3')], [motor('m', 'C')]))
    // The cards' robot: colour at 1, nothing at 4.
    expect(added('input')).toBe('4')
  })

  it('shares a sensor rather than look where another one sits', () => {
    bench = new Bench(network([distance('a', '2')], [motor('m', 'C')]))
    const sensors = { ...cardConfig.sensors, '3': cardConfig.sensors['1']!, '4': cardConfig.sensors['1']! }
    expect(added('input', { ...cardConfig, sensors })).toBe('2')
  })

  it('looks for the first sensor where one is', () => {
    bench = new Bench(network([], [motor('m', 'C')]))
    expect(added('input', withoutSensor(cardConfig, '2'))).toBe('3')
  })

  it('sees a colour that lies on the floor before one that does not', () => {
    const colour = (id: string, value: string): Block => ({
      ...{ id, type: 'ai_nn_input_node_coloursensor_color' },
      fields: { COLOUR: value, SENSORPORT: '1' },
    })
    bench = new Bench(network([colour('a', COLOURS.white)], [motor('m', 'C')]))
    knowRobot(bench.workspace, cardConfig, () => [COLOURS.white, COLOURS.yellow])
    const added = () =>
      String(bench.block(addNeuron(bench.workspace, 'net', 'input')!).getFieldValue('COLOUR'))
    expect(added()).toBe(COLOURS.yellow)
    // White and yellow are in use: another colour rather than one of them twice.
    expect(added()).toBe(COLOURS.red)
  })

  it('drives a wheel before another motor', () => {
    bench = new Bench(network([distance('a', '2')], [motor('m', 'C')]))
    expect(added('output')).toBe('B')
    expect(added('output')).toBe('D')
  })
})

it('a new row of a list without neurons comes with what is in its last row', () => {
  const road = { id: 'road', type: 'ai_q_barrier_mountain', fields: { FROM: '3', TO: '2' } }
  const mutation = { attrs: { items: '1', list_type: 'Obstacle' } }
  bench = new Bench({ id: 'roads', type: 'rl_obstacles_easy_list', mutation, values: { ADD0: road } })
  const added = addLine(bench.block('roads'))!
  expect([added.type, added.getFieldValue('TO')]).toEqual(['ai_q_barrier_mountain', 2])
})
