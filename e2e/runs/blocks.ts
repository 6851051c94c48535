import type { Block } from '@botgarten/blocks'
import type { Brain } from '@botgarten/learning/neural-network'
import type { Program } from '@botgarten/programs'

type Parts = Omit<Block, 'id' | 'type'>

/** Writes programs as short lines; ids are counted, so that the same lines give the same program. */
export class Blocks {
  #count = 0

  block(type: string, parts: Parts = {}): Block {
    this.#count += 1
    return { id: `b${this.#count}`, type, ...parts }
  }

  program(...blocks: readonly Block[]): Program {
    const start = this.block('robControls_start', { fields: { DEBUG: 'FALSE' } })
    return { stacks: [{ x: 0, y: 0, blocks: [start, ...blocks] }], config: { stacks: [] } }
  }

  forever(...blocks: readonly Block[]) {
    return this.block('robControls_loopForever', { statements: { DO: blocks } })
  }

  repeat(times: number, ...blocks: readonly Block[]) {
    const statements = { DO: blocks }
    return this.block('controls_repeat_ext', { values: { TIMES: this.number(times) }, statements })
  }

  ifElse(condition: Block, yes: readonly Block[], no: readonly Block[]) {
    const mutation = { attrs: { else: '1' } }
    return this.block('robControls_ifElse', {
      ...{ mutation, values: { IF0: condition }, statements: { DO0: yes, ELSE: no } },
    })
  }

  wait(milliseconds: number) {
    return this.block('robControls_wait_time', { values: { WAIT: this.number(milliseconds) } })
  }

  number(value: number) {
    return this.block('math_number', { fields: { NUM: String(value) } })
  }

  calculate(OP: 'ADD' | 'MINUS' | 'MULTIPLY' | 'DIVIDE', A: Block, B: Block) {
    return this.block('math_arithmetic', { fields: { OP }, values: { A, B } })
  }

  compare(OP: 'EQ' | 'LT' | 'GT', A: Block, B: Block) {
    return this.block('logic_compare', { fields: { OP }, values: { A, B } })
  }

  distance(SENSORPORT: string) {
    return this.block('robSensors_ultrasonic_getSample', { fields: { MODE: 'DISTANCE', SENSORPORT } })
  }

  floor(MODE: 'COLOUR' | 'LIGHT') {
    return this.block('robSensors_colour_getSample', { fields: { MODE, SENSORPORT: '1' } })
  }

  motor(MOTORPORT: 'B' | 'C', power: Block) {
    return this.block('robActions_motor_on', { fields: { MOTORPORT }, values: { POWER: power } })
  }

  drive(power: number, cm: number) {
    const values = { POWER: this.number(power), DISTANCE: this.number(cm) }
    return this.block('robActions_motorDiff_on_for', { fields: { DIRECTION: 'FOREWARD' }, values })
  }

  turnRight(power: number, degrees: number) {
    const values = { POWER: this.number(power), DEGREE: this.number(degrees) }
    return this.block('robActions_motorDiff_turn_for', { fields: { DIRECTION: 'RIGHT' }, values })
  }

  /** A network of the neurons given, and its brain with `weights[input][output]`. */
  net(inputs: readonly Block[], outputs: readonly Block[], weights: readonly (readonly number[])[]) {
    const INPUT_LAYER = this.#layer('InputNode', inputs)
    const OUTPUT_LAYER = this.#layer('OutputNode', outputs)
    const block = this.block('ai_neural_network', { values: { INPUT_LAYER, OUTPUT_LAYER } })
    const rowOf = (row: number) =>
      Object.fromEntries(outputs.map((to, column) => [to.id, weights[row]?.[column] ?? 0]))
    const written = Object.fromEntries(inputs.map(({ id }, row) => [id, rowOf(row)]))
    const layers = [inputs, outputs].map((layer) =>
      layer.map(({ id }) => ({ id, activation: 'identity' as const, bias: 0 })),
    )
    const brain: Brain = { kind: 'network', layers, weights: written, sets: {} }
    return { block, brain }
  }

  eye(port: string) {
    return this.block('ai_nn_input_node_ultrasonic', { fields: { INPUTNODE: `ULTRASONIC_PORT_${port}` } })
  }

  brightness() {
    return this.block('ai_nn_input_node_coloursensor_light', { fields: { SENSORPORT: '1' } })
  }

  wheel(port: 'B' | 'C') {
    return this.block('ai_nn_output_node', { fields: { OUTPUTNODE: `MOTORPORT_${port}` } })
  }

  #layer(list_type: string, neurons: readonly Block[]) {
    const mutation = { attrs: { items: String(neurons.length), list_type } }
    const values = Object.fromEntries(neurons.map((neuron, row) => [`ADD${row}`, neuron]))
    return this.block('ai_easy_list', { mutation, values })
  }
}
