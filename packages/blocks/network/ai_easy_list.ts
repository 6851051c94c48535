import { part } from '../parts/python.ts'
import type { MotorPort } from '@botgarten/simulation'
import { distanceNeuron, motorNeuron, netProgram } from '../parts/examples.ts'
import { motorPortIn } from '../parts/fields.ts'
import { words } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import { filledRows, plugged, rowCount, rowName } from '../parts/rows.ts'
import type { Block, Definition, Frame, Next } from '../types.ts'

const type = 'ai_easy_list'

/**
 * Asks for the next row. `counter`: how many levels the list was given; the k-th filled row gets the k-th of them,
 * and what a row gives comes behind them in `got`.
 */
function askRow(frame: Frame, row: number): Next {
  const given = frame.counter ?? 0
  const input = rowName(row)
  const filledBefore = frame.got.length - given
  const level = filledBefore < given ? frame.got[filledBefore] : undefined
  return level === undefined ? { next: 'value', input } : { next: 'value', input, given: [level] }
}

type Check = ReturnType<NonNullable<Definition['check']>>

function emptyRow(list: Block): Check {
  const count = rowCount(list)
  for (let k = 0; k < count; k++) {
    if (!plugged(list, rowName(k))) return [{ problem: 'problem.emptyRow', stops: false }]
  }
  return []
}

/** Two neurons for one motor: the lower one wins (rule 4). Said at it, with the motors that are free. */
function sameMotor(list: Block): Check {
  const motors = filledRows(list).filter(({ type }) => type === 'ai_nn_output_node')
  const ports = motors.map((neuron) => motorPortIn(neuron, 'OUTPUTNODE'))
  const free = (['B', 'C', 'A', 'D'] as const).filter((port) => !ports.includes(port))
  return motors.flatMap(({ id }, k) => {
    const port = ports[k]
    if (port === undefined || ports.indexOf(port) === k) return []
    return [{ block: id, problem: 'problem.sameMotor', facts: { port }, fixes: free.map(take), stops: false }]
  })
}

const take = (port: MotorPort) => ({
  field: 'OUTPUTNODE',
  value: `MOTORPORT_${port}`,
  words: 'problem.fix.motor',
  facts: { port },
})

/** A layer: one neuron a row. Empty rows are skipped. */
export const ai_easy_list: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'network',
    shape: 'value',
    output: 'InputLayer',
    fields: [],
    inputs: [],
    items: { prefix: 'ADD', min: 1, max: 99 },
    faces: {
      by: { attribute: 'list_type' },
      of: {
        InputNode: {
          output: 'InputLayer',
          plug: 'pointed',
          tint: 'sensor',
          items: { accepts: ['InputNode'], add: `block.${type}.addInput`, fresh: distanceNeuron('2') },
        },
        OutputNode: {
          output: 'OutputLayer',
          plug: 'round',
          tint: 'actuator',
          items: { accepts: ['OutputNode'], add: `block.${type}.addOutput`, fresh: motorNeuron('C') },
        },
      },
    },
    rows: [],
  },
  words: words(type),
  acts: false,
  check: (block) => [...emptyRow(block), ...sameMotor(block)],
  run(block, frame) {
    if (frame.stage === 0) frame.counter = frame.got.length
    const count = rowCount(block)
    while (frame.stage < count) {
      const row = frame.stage++
      if (plugged(block, rowName(row))) return askRow(frame, row)
    }
    return give(frame.counter === 0 ? frame.got : frame.got.slice(frame.counter))
  },
  python: part,
  example: netProgram([distanceNeuron('2'), distanceNeuron('3')], [motorNeuron('C'), motorNeuron('B')]),
}
