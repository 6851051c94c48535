import type { Block } from '@botgarten/blocks'
import type { Program } from '@botgarten/programs'
import { cardConfig, paintFloor, type World } from '@botgarten/simulation'
import { createLab, type Document, type Lab } from '../index.ts'

// A small world with things to push, and blocks in short lines, for tests.

const box = (id: string, x: number, y: number, fixed = false) => ({
  ...{ id, fixed, colour: '#B30006', pose: { x, y, heading: 10 } },
  shape: { kind: 'rectangle' as const, width: 30, height: 30 },
})

const robot = (id: string, x: number) => ({
  ...{ id, program: 'main', brain: '', config: cardConfig },
  pose: { x, y: 100, heading: 90 },
})

/** `robots` of them side by side, the first is called `bo`, the others `bo2`, … */
export const worldWith = (robots = 1): World => ({
  size: { width: 400, height: 400 },
  floor: { colour: '#FFFFFF' },
  areas: [],
  lines: [],
  obstacles: [box('box', 200, 260), box('wall', 330, 330, true)],
  robots: Array.from({ length: robots }, (_, index) =>
    robot(index === 0 ? 'bo' : `bo${index + 1}`, 200 - 60 * index),
  ),
})

export const block = (id: string, type: string, rest: Partial<Block> = {}): Block => ({ id, type, ...rest })
const number = (id: string, value: number) => block(id, 'math_number', { fields: { NUM: String(value) } })

const list = (id: string, kind: string, items: readonly Block[]) =>
  block(id, 'ai_easy_list', {
    mutation: { attrs: { items: String(items.length), list_type: kind } },
    values: Object.fromEntries(items.map((item, index) => [`ADD${index}`, item])),
  })

/** A distance sensor as an input. */
export const eye = (id: string, port: number) =>
  block(id, 'ai_nn_input_node_ultrasonic', { fields: { INPUTNODE: `ULTRASONIC_PORT_${port}` } })
const wheel = (id: string, port: string) =>
  block(id, 'ai_nn_output_node', { fields: { OUTPUTNODE: `MOTORPORT_${port}` } })

/** Eyes, two of them where nothing else is said, to two wheels. */
export const net = (id = 'net', of = '', eyes = [eye(`${of}eyeLeft`, 2), eye(`${of}eyeRight`, 3)]): Block =>
  block(id, 'ai_neural_network', {
    values: {
      INPUT_LAYER: list(`${of}inputs`, 'InputNode', eyes),
      OUTPUT_LAYER: list(`${of}outputs`, 'OutputNode', [
        wheel(`${of}wheelLeft`, 'C'),
        wheel(`${of}wheelRight`, 'B'),
      ]),
    },
  })

export const forever = (...blocks: readonly Block[]): Block =>
  block('forever', 'robControls_loopForever', { statements: { DO: blocks } })

export const drive = (id: string, power: number, cm: number): Block =>
  block(id, 'robActions_motorDiff_on_for', {
    fields: { DIRECTION: 'FOREWARD' },
    values: { POWER: number(`${id}P`, power), DISTANCE: number(`${id}D`, cm) },
  })

export const turn = (id: string, power: number, degrees: number): Block =>
  block(id, 'robActions_motorDiff_turn_for', {
    fields: { DIRECTION: 'LEFT' },
    values: { POWER: number(`${id}P`, power), DEGREE: number(`${id}D`, degrees) },
  })

export const program = (...blocks: readonly Block[]): Program => ({
  stacks: [{ x: 0, y: 0, blocks: [block('start', 'robControls_start'), ...blocks] }],
  config: { stacks: [] },
})

export function labWith(main: Program, world = worldWith(), more: Partial<Document> = {}): Lab {
  const lab = createLab()
  const document = { programs: { main }, world, brains: {}, ...more }
  lab.load(document, paintFloor(world), { seed: 1, checks: [] })
  lab.setWeight('net', 'eyeLeft', 'wheelLeft', 0.5)
  lab.setWeight('net', 'eyeRight', 'wheelRight', 0.4)
  return lab
}
