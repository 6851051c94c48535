import { missing } from '../parts/python.ts'
import { start } from '../parts/examples.ts'
import { field } from '../parts/fields.ts'
import { rows, words } from '../parts/looks.ts'
import { done } from '../parts/next.ts'
import { pictureField } from '../parts/pictures.ts'
import type { Definition } from '../types.ts'

const type = 'robActions_display_picture_new'

/** A picture in place of all that is on the display. */
export const robActions_display_picture_new: Definition = {
  type,
  pack: 'expert',
  look: {
    category: 'action',
    shape: 'statement',
    fields: [pictureField],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: true,
  uses: 'display',
  run(block, _frame, { robot }) {
    robot.picture(field(block, 'PICTURE', 'EYESOPEN'))
    return done
  },
  python: missing('picture'),
  example: [start, { type, fields: { PICTURE: 'EYESOPEN' } }],
}
