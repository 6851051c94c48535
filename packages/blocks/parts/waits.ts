import { asked } from './python.ts'
import type { PythonAt } from '../python.ts'
import type { BlockType } from '../packs/packs.ts'
import type { Definition, Next, Pack } from '../types.ts'
import { number, show, start } from './examples.ts'
import { rows, statements, value, words } from './looks.ts'
import { ask, execute, done, wait } from './next.ts'

interface Way {
  readonly ask: Next
  readonly execute: Next
}

const ways: Way[] = []

function wayAt(k: number): Way {
  while (ways.length <= k) ways.push({ ask: ask(`WAIT${ways.length}`), execute: execute(`DO${ways.length}`) })
  return ways[k] ?? { ask: done, execute: done }
}

/** Asks its conditions from the first on in every tick, until one is true; executes what belongs to it. */
const waitFor: Definition['run'] = (block, frame) => {
  if (frame.counter === 1) return done
  const count = 1 + (Number(block.mutation?.attrs.wait) || 0)
  const asked = frame.stage
  if (asked > 0 && frame.got[asked - 1] === true) {
    frame.counter = 1
    return wayAt(asked - 1).execute
  }
  if (asked < count) {
    frame.stage++
    return wayAt(asked).ask
  }
  frame.stage = 0
  frame.got.length = 0
  return wait
}

/** A loop that asks; of several conditions the first that is true is noted, and its blocks come after the loop. */
function pythonWait(py: PythonAt): void {
  const count = 1 + (Number(py.block.mutation?.attrs.wait) || 0)
  const conditions = Array.from({ length: count }, (_, k) => py.expression(`WAIT${k}`))
  const tick = py.robot.wait('10')
  const [only] = conditions
  if (count === 1 && only) {
    py.line(`while ${asked(only)}:`)
    py.inner(() => py.line(tick))
    return py.body('DO0')
  }
  const which = py.fresh('which')
  py.line(`${which} = 0`)
  py.line(`while ${which} == 0:`)
  py.inner(() => {
    conditions.forEach(({ code }, k) => {
      py.line(`${k === 0 ? 'if' : 'elif'} ${code}:`)
      py.inner(() => py.line(`${which} = ${k + 1}`))
    })
    py.line('else:')
    py.inner(() => py.line(tick))
  })
  conditions.forEach((_, k) => py.rows(`${k === 0 ? 'if' : 'elif'} ${which} == ${k + 1}:`, `DO${k}`))
}

/** Waits until one of WAIT0, WAIT1, … is true (mutation `wait`: how many more than one), then executes its DO. */
export const waitingBlock = (type: BlockType, pack: Pack): Definition => ({
  type,
  pack,
  look: {
    category: 'control',
    shape: 'statement',
    fields: [],
    inputs: [value('WAIT0', 'Boolean'), statements('DO0')],
    branches: { attribute: 'wait', value: 'WAIT', most: 30 },
    rows: rows(type, 2),
  },
  words: words(type),
  acts: false,
  run: waitFor,
  python: pythonWait,
  example: [
    start,
    {
      type,
      values: {
        WAIT0: {
          type: 'robSensors_key_getSample',
          fields: { MODE: 'PRESSED', SENSORPORT: 'LEFT', SLOT: '' },
        },
      },
    },
    show(number(2)),
  ],
})
