import { describe, expect, it } from 'vitest'
import { block, forever, net, programOf, start } from './testing/build.ts'
import { networks } from './index.ts'

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

  it('gives an empty side where a layer is missing', () => {
    expect(networks(programOf([block('ai_neural_network')]))).toEqual([
      { id: 'ai_neural_network', inputs: [], hidden: [], outputs: [] },
    ])
  })
})
