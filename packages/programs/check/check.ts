import type { Block, CheckContext, Finding } from '@botgarten/blocks'
import { startingStacks } from '../run/index-program.ts'
import type { Program } from '../types.ts'
import { definitionOf, holesOf, outputOf, type Hole } from './places.ts'
import { rules } from './rules.ts'

/**
 * What a child should change before the program runs, in the order of the blocks. Only what a start block reaches is
 * looked at: other blocks may lie about half done.
 * @param sockets the robot's configuration, or as much of it as says which sensors it has
 */
export function check(program: Program, sockets: CheckContext): Finding[] {
  const stacks = startingStacks(program)
  if (stacks.length === 0) return [{ block: '', problem: 'problem.noStart', stops: true }]
  const [first, ...others] = stacks
  const seconds = others.map(({ blocks }) => said(blocks[0], 'secondStart'))
  return [...seconds, ...rowsFindings(first?.blocks ?? [], 'hat', sockets)]
}

const said = (block: Block | undefined, name: string, stops = true): Finding => ({
  block: block?.id ?? '',
  problem: `problem.${name}`,
  stops,
})

type Place = 'hat' | 'statement' | 'value'

function rowsFindings(rows: readonly Block[], top: Place, sockets: CheckContext): Finding[] {
  const running = rows.filter(({ disabled }) => disabled !== true)
  return [
    ...running.flatMap((block, k) => blockFindings(block, k === 0 ? top : 'statement', sockets)),
    ...neverReached(running),
  ]
}

function neverReached(rows: readonly Block[]): Finding[] {
  const loop = rows.findIndex(({ type }) => type === 'robControls_loopForever')
  const next = loop < 0 ? undefined : rows[loop + 1]
  return next ? [said(next, 'neverReached', false)] : []
}

function blockFindings(block: Block, place: Place, sockets: CheckContext): Finding[] {
  const definition = definitionOf(block)
  if (!definition) return [said(block, 'unknownBlock')]
  if (definition.look.shape !== place) return [said(block, 'wrongKind')]
  const own = rules.flatMap((rule) => rule(block, definition, sockets))
  return [
    ...own.map((finding) => ({ block: block.id, ...finding })),
    ...holesOf(block, definition).flatMap((hole) => holeFindings(hole, sockets)),
    ...Object.values(block.statements ?? {}).flatMap((rows) => rowsFindings(rows, 'statement', sockets)),
  ]
}

function holeFindings({ child, accepts }: Hole, sockets: CheckContext): Finding[] {
  if (!child) return []
  const definition = definitionOf(child)
  const output = definition && outputOf(child, definition)
  if (output && !accepts.includes(output)) return [said(child, 'wrongKind')]
  return blockFindings(child, 'value', sockets)
}
