import { motorIn } from './python.ts'
import type { BlockType } from '../packs/packs.ts'
import type { Definition, Pack } from '../types.ts'
import { number, start } from './examples.ts'
import { motorPortIn } from './fields.ts'
import { motorPort, rows, value, words } from './looks.ts'
import { ask, done, fail } from './next.ts'
import { numberAt, percent } from './numbers.ts'
import { afterAsking } from './steps.ts'

/** One motor turns at this speed from now on. `count`: of the block's rows. */
export const motorSpeed = (type: BlockType, pack: Pack, count: number): Definition => ({
  type,
  pack,
  look: {
    category: 'action',
    shape: 'statement',
    fields: [motorPort('B')],
    inputs: [value('POWER', 'Number')],
    rows: rows(type, count),
  },
  words: words(type),
  acts: true,
  run: afterAsking([ask('POWER')], (frame, { robot }, block) => {
    const port = motorPortIn(block, 'MOTORPORT')
    if (port === undefined) return fail('unknownChoice')
    robot.motor(port, percent(numberAt(frame, 0)))
    return done
  }),
  python: (py) => py.line(py.robot.motor(motorIn(py), py.value('POWER'))),
  example: [
    start,
    { type, fields: { MOTORPORT: 'B' }, values: { POWER: number(30) } },
    { type: 'robControls_wait_time', values: { WAIT: number(500) } },
  ],
})
