import { describe, expect, it } from 'vitest'
import type { Template } from '@botgarten/blocks'
import { evaluate, indexProgram, runThread, startThread } from '../index.ts'
import { block, net, programOf, start } from '../testing/build.ts'
import { nextTick, recordingRobot } from '../testing/recording-robot.ts'
import { run } from '../testing/run.ts'

describe('rules 15 and 16: the network', () => {
  const eye = (port: string) => block('ai_nn_input_node_ultrasonic', { INPUTNODE: `ULTRASONIC_PORT_${port}` })
  const motor = (port: string) => block('ai_nn_output_node', { OUTPUTNODE: `MOTORPORT_${port}` })
  const led = (value: string) => block('ai_nn_output_node_led', { OUTPUTNODE: value })
  const word = (text: string) => block('ai_nn_output_node_text', { OUTPUTNODE: text })
  const sound = block('ai_nn_output_node_sound')
  const channel = (value: string) =>
    block('ai_nn_input_node_coloursensor_rgb_channel', { COLOUR: value, SENSORPORT: '1' })

  /** The brain gives each output of `levels`. */
  function runNet(
    outputs: readonly Template[],
    levels: readonly number[],
    inputs: readonly (Template | null)[] = [eye('2')],
  ) {
    const recording = recordingRobot()
    const thought: (readonly number[])[] = []
    const think = (_id: string, values: readonly number[]) => {
      thought.push([...values])
      return levels
    }
    const index = indexProgram(programOf([start, net(inputs, outputs)]))
    const thread = startThread(index)
    for (let k = 0; k < 3; k++) nextTick(recording)
    runThread(thread, index, { ...recording.context, think })
    return { log: recording.log.slice(0, -2).map(([, ...told]) => told), thought, thread }
  }

  it('reads its filled rows from the top: tick 3 gives 21 cm', () => {
    expect(runNet([], [], [eye('2'), null, eye('3')]).thought).toEqual([[21, 21]])
  })

  it('distances count up to 100, channels 0..255 are 0..100, a colour is 100 or 0', () => {
    const seen = (value: string) =>
      block('ai_nn_input_node_coloursensor_color', { COLOUR: value, SENSORPORT: '1' })
    const light = block('ai_nn_input_node_coloursensor_light', { SENSORPORT: '1' })
    const { thought } = runNet([], [], [channel('#0000ff'), seen('#b30006'), seen('#FFFFFF'), light])
    expect(thought).toEqual([[100, 100, 0, 9]])
    const recording = recordingRobot()
    for (let k = 0; k < 30; k++) nextTick(recording)
    const index = indexProgram(programOf([eye('2')]))
    expect(evaluate(index, 'ai_nn_input_node_ultrasonic', recording.context)).toBe(100)
  })

  it('motors are cut to −100..100, each gets its own level', () => {
    expect(runNet([motor('C'), motor('B')], [150, -3]).log).toEqual([
      ['motor', 'C', 100],
      ['motor', 'B', -3],
    ])
  })

  it('of several lamps the highest above 0 wins, of equals the upper one; none above 0 is off', () => {
    const lamps = [led('#00642E'), led('#F7D118'), led('#B30006')]
    expect(runNet(lamps, [1, 7, 3]).log).toEqual([['led', 'orange']])
    expect(runNet(lamps, [5, 2, 5]).log).toEqual([['led', 'green']])
    expect(runNet(lamps, [0, -1, 0]).log).toEqual([['led', null]])
  })

  it('each word has its own row; one that is not above 0 shows the sign for nothing', () => {
    expect(runNet([word('rot'), motor('B'), word('blau')], [3, 1, 0]).log).toEqual([
      ['motor', 'B', 1],
      ['display', 0, 0, 'rot'],
      ['display', 1, 0, '∅'],
    ])
  })

  it('a tone is value × 5 Hz, the highest sounds, none is silence', () => {
    expect(runNet([sound, sound], [20, 60]).log).toEqual([['tone', 300, null]])
    expect(runNet([sound], [0]).log).toEqual([['tone', 0, null]])
  })

  it('a net of 1,200 inputs is read over two ticks', () => {
    const { thought, thread } = runNet(
      [motor('B')],
      [1],
      Array.from({ length: 1200 }, () => eye('2')),
    )
    expect(thought).toEqual([])
    expect(thread.ended).toBe(false)
    const { log } = run(
      [
        net(
          Array.from({ length: 1200 }, () => eye('2')),
          [motor('B')],
        ),
      ],
      5,
      1,
    )
    expect(log.map(([tick, verb]) => [tick, verb])).toEqual([
      [1, 'think'],
      [1, 'motor'],
    ])
  })
})
