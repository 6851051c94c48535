import { missing } from '../parts/python.ts'
import { number, start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, value, words } from '../parts/looks.ts'
import { ask, done } from '../parts/next.ts'
import { pictureField } from '../parts/pictures.ts'
import { afterAsking } from '../parts/steps.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_display_picture'

/** An old block: X and Y are asked and mean nothing, as in Open Roberta today. */
export const robActions_display_picture: Definition = {
  type,
  pack: 'expert',
  outsideToolbox: 'old',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [pictureField],
    inputs: [value('X', 'Number'), value('Y', 'Number')],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  uses: 'display',
  run: afterAsking([ask('X'), ask('Y')], (_frame, { robot }, block) => {
    robot.picture(field(block, 'PICTURE', 'EYESOPEN'))
    return done
  }),
  python: missing('picture'),
  example: [start, { type, fields: { PICTURE: 'EYESOPEN' }, values: { X: number(0), Y: number(0) } }],
}
