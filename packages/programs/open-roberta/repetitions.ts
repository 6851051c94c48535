import type { Block } from '@botgarten/blocks'

/** Blocks that grow branches; `robControls_ifElse` always has one more. */
const branching = new Set([
  'robControls_if',
  'robControls_ifElse',
  'robControls_wait_for',
  'robControls_wait',
])
const growing = ['elseif', 'else', 'wait']

/** Do this block's inputs sit in one `<repetitions>`? */
export function isWrapped({ type, mutation, flags }: Pick<Block, 'type' | 'mutation' | 'flags'>): boolean {
  return flags?.[flag] === undefined ? wrapsByItself({ type, mutation }) : flags[flag] === 'true'
}

/** Named in a block's flags where its file does it otherwise than `wrapsByItself` says. */
export const flag = 'repetitions'

export function wrapsByItself({
  type,
  mutation,
}: {
  type: string
  mutation?: Block['mutation'] | undefined
}) {
  if (type === 'robProcedures_defreturn' || type === 'robControls_ifElse') return true
  return branching.has(type) && growing.some((name) => mutation?.attrs[name] !== undefined)
}

interface Input {
  readonly kind: 'value' | 'statement'
  readonly name: string
}

/** IF0, DO0, IF1, DO1 …, ELSE; ST, STACK, RETURN. */
export const inBranches = <Part extends Input>(inputs: readonly Part[]): Part[] =>
  inputs.toSorted((a, b) => branchOf(a) - branchOf(b) || kindOf(a) - kindOf(b))

function branchOf({ name }: Input): number {
  const digits = /\d+$/.exec(name)?.[0]
  return digits === undefined ? Number.MAX_VALUE : Number(digits)
}

/** In a numbered branch the condition is first; without a number the value comes last. */
const kindOf = ({ kind, name }: Input) => (kind === 'value' ? (/\d$/.test(name) ? 0 : 2) : 1)
