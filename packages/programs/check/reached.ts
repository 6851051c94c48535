import type { Block } from '@botgarten/blocks'
import { functionBlocks, startingStacks } from '../run/index-program.ts'
import type { Program } from '../types.ts'
import { definitionOf } from './places.ts'
import { within } from './names.ts'

const forever = 'robControls_loopForever'

/** Ids of the blocks that the start block comes to, as far as can be told without running: those in functions that are called too. */
export function reachedIn(program: Program): ReadonlySet<string> {
  const functions = functionBlocks(program)
  const reached = new Set<string>()
  const waiting: (readonly Block[])[] = [startingStacks(program)[0]?.blocks ?? []]
  for (let row = waiting.pop(); row; row = waiting.pop())
    for (const block of upToEndless(row)) {
      if (reached.has(block.id)) continue
      reached.add(block.id)
      waiting.push(...Object.values(block.statements ?? {}), Object.values(block.values ?? {}))
      if (/^robProcedures_call/.test(block.type))
        waiting.push(
          functions.filter(({ fields }) => fields?.NAME === block.mutation?.attrs.name).slice(0, 1),
        )
    }
  return reached
}

/** What of a row runs: nothing comes after a loop that never ends. */
function upToEndless(row: readonly Block[]): readonly Block[] {
  const running = row.filter(({ disabled }) => disabled !== true)
  const loop = running.findIndex(isEndless)
  return loop < 0 ? running : running.slice(0, loop + 1)
}

export const isEndless = (block: Block): boolean => block.type === forever && !isLeft(block)

/** Is there a block in it that leaves a loop? Perhaps only an inner one. */
const isLeft = (loop: Block) =>
  within(loop).some(({ type, fields }) => type === 'controls_flow_statements' && fields?.FLOW !== 'CONTINUE')

/**
 * Where a block goes that is to run again and again. `loop`: the loop that never ends, of several in each other the
 * innermost, else the first loop there is; null: one has to be made. `start`: null: that too.
 */
export function spotIn(program: Program): { readonly start: string | null; readonly loop: string | null } {
  const [start, ...row] = startingStacks(program)[0]?.blocks ?? []
  return { start: start?.id ?? null, loop: loopIn(row) }
}

function loopIn(row: readonly Block[]): string | null {
  const loops = row.filter((block) => block.disabled !== true && definitionOf(block)?.loops)
  const endless = loops.find(({ type }) => type === forever)
  const inner = Object.values(endless?.statements ?? {}).flat()
  const deeper = inner.some(({ type, disabled }) => type === forever && disabled !== true)
  return (deeper ? loopIn(inner) : null) ?? (endless ?? loops[0])?.id ?? null
}
