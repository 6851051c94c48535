import { start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { choice, plain, rows, words } from '../parts/looks.ts'
import { done, fail } from '../parts/next.ts'
import { waiting } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_play_file'

/** Hz and ms. */
const tunes: readonly (readonly (readonly [number, number])[])[] = [
  [
    [523, 150],
    [659, 150],
    [784, 300],
  ],
  [
    [784, 150],
    [659, 150],
    [523, 300],
  ],
  [
    [440, 100],
    [554, 100],
    [659, 100],
    [880, 300],
  ],
  [
    [330, 200],
    [330, 200],
    [262, 400],
  ],
  [
    [988, 80],
    [1319, 400],
  ],
]

/** One of five little tunes. */
export const robActions_play_file: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [choice('FILE', ['0', '1', '2', '3', '4'].map(plain))],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  uses: 'sound',
  /** `stage`: the tone that comes next. */
  run(block, frame, context) {
    const tune = tunes[Number(field(block, 'FILE', '0'))]
    if (tune === undefined) return fail('unknownChoice')
    const tone = tune[frame.stage]
    if (tone === undefined) return done
    if (frame.counter === undefined) context.robot.tone(tone[0], tone[1] / 1000)
    const next = waiting(frame, context, tone[1])
    if (next.next !== 'done') return next
    frame.counter = undefined
    frame.stage++
    return frame.stage < tune.length ? this.run(block, frame, context) : done
  },
  python: (py) => {
    for (const [hertz, ms] of tunes[Number(py.field('FILE', '0'))] ?? py.gap('problem.unknownChoice'))
      py.line(py.robot.tone(String(hertz), String(ms)))
  },
  example: [start, { type, fields: { FILE: '0' } }],
}
