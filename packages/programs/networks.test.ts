import type { Template } from '@botgarten/blocks'
import { describe, expect, it } from 'vitest'
import { block, forever, net, number, programOf, repeat, start } from './testing/build.ts'
import { networks, networksByUse, spotIn } from './index.ts'

const eye = (port: string) => block('ai_nn_input_node_ultrasonic', { INPUTNODE: `ULTRASONIC_PORT_${port}` })
const motor = (port: string) => block('ai_nn_output_node', { OUTPUTNODE: `MOTORPORT_${port}` })

describe('networks', () => {
  it('lists the neurons of a network from the top, without empty rows and blocks that are switched off', () => {
    const off = { ...eye('3'), disabled: true }
    const program = programOf([start, forever(net([eye('2'), null, off, eye('3')], [motor('C')]))])
    const [network] = networks(program)
    expect(network?.inputs.map(({ id, fields }) => [id, fields])).toEqual([
      ['ai_nn_input_node_ultrasonic', { INPUTNODE: 'ULTRASONIC_PORT_2' }],
      ['ai_nn_input_node_ultrasonic#3', { INPUTNODE: 'ULTRASONIC_PORT_3' }],
    ])
    expect(network?.outputs[0]).toMatchObject({
      type: 'ai_nn_output_node',
      look: { layer: 'output', port: 'OUTPUTNODE' },
    })
  })

  it('finds networks that lie about and leaves out those that are switched off', () => {
    const off = { ...net([eye('2')], []), disabled: true }
    const program = programOf([start, net([eye('2')], [])], [net([], [motor('B')])], [off])
    expect(networks(program).map(({ id }) => id)).toEqual(['ai_neural_network', 'ai_neural_network#2'])
  })

  it('that run come first, those that are switched off last, with what keeps the others from running', () => {
    const one = () => net([eye('2')], [motor('B')])
    const program = programOf(
      [{ ...forever(one()), disabled: true }],
      [one()],
      [start, forever(one()), one()],
      [{ ...start, disabled: true }, one()],
    )
    expect(networksByUse(program).map(({ id, idle }) => [id, idle])).toEqual([
      ['ai_neural_network#3', null],
      ['ai_neural_network#2', 'loose'],
      ['ai_neural_network#4', 'behind'],
      ['ai_neural_network#5', 'loose'],
      ['ai_neural_network', 'off'],
    ])
  })

  it('go into the loop that never ends, the innermost of several, else the first loop, else a new one', () => {
    const wait = block('robControls_wait_time')
    const twice = repeat(number(2))
    const loopOf = (...rows: Template[]) => spotIn(programOf([start, ...rows])).loop
    expect(loopOf(wait)).toBe(null)
    expect(loopOf(twice, forever())).toBe('robControls_loopForever')
    expect(loopOf(twice, repeat(number(3)))).toBe('controls_repeat_ext')
    expect(loopOf(forever(wait, forever(wait)))).toBe('robControls_loopForever#2')
    expect(loopOf(forever(twice))).toBe('robControls_loopForever')
    expect(spotIn(programOf([wait]))).toEqual({ start: null, loop: null })
  })

  it('gives an empty side where a layer is missing', () => {
    expect(networks(programOf([block('ai_neural_network')]))).toEqual([
      { id: 'ai_neural_network', inputs: [], hidden: [], outputs: [] },
    ])
  })
})
