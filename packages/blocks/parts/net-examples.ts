import type { Template } from '../types.ts'
import { number } from './examples.ts'
import { declared } from './variables.ts'

/** A start block that carries a network from n1 to n2, and its input set. */
export const netStart: readonly Template[] = [
  declared('x', 'Number', number(0)),
  { type: 'robActions_set_inputneuron_val', fields: { NAME: 'n1' }, values: { VALUE: number(3) } },
]
