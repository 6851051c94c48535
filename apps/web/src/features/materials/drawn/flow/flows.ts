import type { Flow } from './flow.ts'
import { qLearning } from './q-learning.ts'

/** Flow diagrams by the id that a text names. */
export const flows = { 'q-learning': qLearning } as const satisfies { readonly [id: string]: Flow }
