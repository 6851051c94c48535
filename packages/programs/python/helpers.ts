import type { PythonAt } from '@botgarten/blocks'
import type { Draft } from './draft.ts'
import { general } from './helpers/general.ts'
import { learner } from './helpers/learner.ts'
import { network } from './helpers/network.ts'
import { sorting } from './helpers/sorting.ts'
import { trying } from './helpers/trying.ts'
import { ev3dev2 } from './robots/ev3dev2-helpers.ts'
import { pybricks } from './robots/pybricks-helpers.ts'
import { spike } from './robots/spike-helpers.ts'
import type { Dialect } from './types.ts'

/** What a helper may ask for while its lines are written. */
export interface HelperAt {
  readonly at: PythonAt
  readonly draft: Draft
  /** Another helper by its name in the file. */
  readonly call: (name: string) => string
  readonly math: (name: string) => string
}

/** Lines of a function after `def name`: `(arguments):` first. */
type Helper = (h: HelperAt) => readonly string[]
export type Helpers = { readonly [name: string]: Helper }

const shared: Helpers = { ...general, ...learner, ...network, ...sorting, ...trying }
const own: { readonly [dialect in Dialect]: Helpers } = {
  ...{ pybricks, ev3dev2 },
  spike: { ...pybricks, ...spike },
}

export const isHelper = (name: string): boolean =>
  [shared, ...Object.values(own)].some((helpers) => Object.hasOwn(helpers, name))

/** Brings a function along, and those that it calls before it. Gives its name in this file. */
export function helper(at: PythonAt, draft: Draft, wanted: string): string {
  const name = draft.names.of(`helper ${wanted}`, wanted)
  if (draft.helpers.has(name)) return name
  const write = own[draft.input.dialect][wanted] ?? shared[wanted]!
  const [head = '', ...body] = write({
    ...{ at, draft, math: (one) => at.from('math', one) },
    call: (other) => helper(at, draft, other),
  })
  const rows = [`def ${name}${head}`, ...commented(draft, wanted), ...body.map((row) => `    ${row}`)]
  draft.helpers.set(name, { rows, blocks: ofOneBlock.includes(wanted) ? [at.block.id] : [] })
  return name
}

/** Helpers that are what one block means: their lines light up with it. */
const ofOneBlock = ['learn', 'drive_best_way']

/** Helpers whose names do not say what they are for: words in the section `python.helper`. */
const explained = [
  ...['speed', 'straight', 'curve', 'distance', 'show', 'number_text', 'rgb', 'highest', 'find_groups'],
  ...['best_of', 'put_down', 'drive_to', 'learn', 'bucket', 'best_action'],
]

/** The same where the hub of SPIKE Prime is another. */
const onSpike: { readonly [wanted: string]: string } = { show: 'letters', rgb: 'hsv' }

function commented({ say, input }: Draft, wanted: string): readonly string[] {
  const key = (input.dialect === 'spike' && onSpike[wanted]) || wanted
  return explained.includes(wanted) ? [`    # ${say(`python.helper.${key}`)}`] : []
}
