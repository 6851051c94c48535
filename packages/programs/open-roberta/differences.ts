import { plugged, type Block, type CheckContext } from '@botgarten/blocks'
import { check } from '../check/check.ts'
import { calledBy, within } from '../check/names.ts'
import { startingStacks } from '../run/index-program.ts'
import type { Program } from '../types.ts'

/** What ends a program here where Open Roberta's simulation goes on (semantics.md, "Where programs end here"). */
type DifferenceKind = 'dividing' | 'place' | 'port' | 'unknown'

export interface Difference {
  readonly kind: DifferenceKind
  /** The first block that may end the program in this way. */
  readonly block: string
}

/** Where a program may end here and goes on in Open Roberta, as far as its blocks tell, each kind once. */
export function differencesOf(program: Program, sockets: CheckContext): readonly Difference[] {
  const rows = startingStacks(program)[0]?.blocks ?? []
  const reached = [...rows, ...calledBy(program, rows)].flatMap(within)
  const findings = check(program, sockets)
  const found: readonly (readonly [DifferenceKind, string | undefined])[] = [
    ['dividing', reached.find(mayDivideByZero)?.id],
    ['place', reached.find(asksForPlace)?.id],
    ['port', findings.find(({ problem }) => /^problem\.no[A-Z]\w*Sensor/.test(problem))?.block],
    ['unknown', findings.find(({ problem }) => problem === 'problem.unknownBlock')?.block],
  ]
  return found.flatMap(([kind, block]) => (block === undefined ? [] : [{ kind, block }]))
}

function mayDivideByZero(block: Block): boolean {
  const { type, fields } = block
  if (type === 'math_arithmetic') return fields?.['OP'] === 'DIVIDE' && mayBeZero(plugged(block, 'B'))
  if (type === 'math_modulo') return mayBeZero(plugged(block, 'DIVISOR'))
  return type === 'math_number_property' && fields?.['PROPERTY'] === 'DIVISIBLE_BY'
    ? mayBeZero(plugged(block, 'DIVISOR'))
    : false
}

const mayBeZero = (divisor: Block | undefined): boolean =>
  divisor !== undefined && !(divisor.type === 'math_number' && Number(divisor.fields?.['NUM']) !== 0)

const asksForPlace = ({ type, fields }: Block): boolean =>
  type === 'robLists_getIndex' || (type === 'robLists_setIndex' && fields?.['MODE'] === 'SET')
