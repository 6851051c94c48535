import { math_arithmetic as plain } from '../math/math_arithmetic.ts'
import { pow } from '@botgarten/numbers'
import { field } from '../parts/fields.ts'
import { choice, worded } from '../parts/looks.ts'
import { finite, numberAt } from '../parts/numbers.ts'
import type { Definition } from '../types.ts'

const [operators] = plain.look.fields
const options = operators?.kind === 'choice' ? operators.options : []

/** OP POWER as well. */
export const math_arithmetic: Definition = {
  ...plain,
  look: { ...plain.look, fields: [choice('OP', [...options, worded('POWER', 'power')])] },
  run: (block, frame, context) =>
    frame.stage === 2 && field(block, 'OP', 'ADD') === 'POWER'
      ? finite(pow(numberAt(frame, 0), numberAt(frame, 1)), frame)
      : plain.run(block, frame, context),
}
