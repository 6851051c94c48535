import { actions_bricklight_off_ev3 as plain } from '../action/actions_bricklight_off_ev3.ts'
import { choice, worded } from '../parts/looks.ts'
import type { Definition } from '../types.ts'

/** MODE RESET as well: off, too. */
export const actions_bricklight_off_ev3: Definition = {
  ...plain,
  look: {
    ...plain.look,
    fields: [choice('MODE', [worded('OFF', 'lampOff'), worded('RESET', 'lampReset')])],
    rows: ['richer.actions_bricklight_off_ev3.row0'],
  },
}
