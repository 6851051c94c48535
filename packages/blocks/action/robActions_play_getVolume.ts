import { show, start } from '../parts/examples.ts'
import { rows, words } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_play_getVolume'

/** 0 to 100; 50 at the start. */
export const robActions_play_getVolume: Definition = {
  type,
  pack: 'expert',
  look: { category: 'action', shape: 'value', output: 'Number', fields: [], inputs: [], rows: rows(type, 1) },
  words: words(type),
  acts: true,
  run: (_block, _frame, { robot }) => give(robot.volume()),
  python: (py) => py.robot.volume(),
  example: [start, show({ type })],
}
