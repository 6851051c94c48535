import { actions_bricklight_on_ev3 as plain } from '../action/actions_bricklight_on_ev3.ts'
import { choice, worded } from '../parts/looks.ts'
import type { Definition } from '../types.ts'

/** MODE FLASH and DOUBLE_FLASH as well. */
export const actions_bricklight_on_ev3: Definition = {
  ...plain,
  look: {
    ...plain.look,
    fields: [
      ...plain.look.fields.filter(({ name }) => name !== 'MODE'),
      choice('MODE', [
        worded('ON', 'lampOn'),
        worded('FLASH', 'flash'),
        worded('DOUBLE_FLASH', 'doubleFlash'),
      ]),
    ],
    rows: ['richer.actions_bricklight_on_ev3.row0'],
  },
}
