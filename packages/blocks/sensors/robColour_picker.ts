import { whole } from '../python.ts'
import { forever, start } from '../parts/examples.ts'
import { colourField } from '../parts/colours.ts'
import { field } from '../parts/fields.ts'
import { rows, words } from '../parts/looks.ts'
import { give } from '../parts/next.ts'
import type { Definition } from '../types.ts'

const type = 'robColour_picker'
const preset = '#B30006'

export const robColour_picker: Definition = {
  type,
  pack: 'core',
  look: {
    category: 'sensors',
    shape: 'value',
    output: 'Colour',
    fields: [colourField(preset)],
    inputs: [],
    rows: rows(type, 1),
  },
  words: words(type),
  acts: false,
  run: (block) => give(field(block, 'COLOUR', preset).toUpperCase()),
  python: (py) => whole(py.robot.colour(py.field('COLOUR', preset))),
  example: [
    start,
    forever({
      type: 'robControls_if',
      values: {
        IF0: {
          type: 'logic_compare',
          fields: { OP: 'EQ' },
          values: {
            A: { type: 'robSensors_colour_getSample', fields: { MODE: 'COLOUR', SENSORPORT: '1' } },
            B: { type, fields: { COLOUR: preset } },
          },
        },
      },
      statements: {
        DO0: [{ type: 'actions_bricklight_on_ev3', fields: { COLOUR: 'RED', MODE: 'ON' } }],
      },
    }),
  ],
}
