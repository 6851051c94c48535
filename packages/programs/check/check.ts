import type { Block, CheckContext, Definition, Finding } from '@botgarten/blocks'
import { startingStacks } from '../run/index-program.ts'
import { shapeOf } from '../run/shape-of.ts'
import { learningIn } from '../learning.ts'
import { networksByUse } from '../networks.ts'
import type { Program } from '../types.ts'
import { calledBy, doubledNames, nameProblems, namesIn, type Names } from './names.ts'
import { definitionOf, holesOf, outputOf, type Hole, type Output } from './places.ts'
import { isEndless, reachedIn, spotIn } from './reached.ts'
import { rules } from './rules.ts'

/**
 * What a child should change before the program runs, in the order of the blocks. Only what a start block reaches is
 * looked at, functions that are called included: other blocks may lie about half done. But a network that no start block
 * comes to has knobs on the screen that do nothing: that is said.
 * @param sockets the robot's configuration, or as much of it as says which sensors it has
 */
export function check(program: Program, sockets: CheckContext): Finding[] {
  const stacks = startingStacks(program)
  const idle = idleFindings(program)
  if (stacks.length === 0) return [{ block: '', problem: 'problem.noStart', stops: true }, ...idle]
  const [first, ...others] = stacks
  const seconds = others.map(({ blocks }) => said(blocks[0], 'secondStart'))
  const rows = first?.blocks ?? []
  const names = namesIn(program, rows[0], rows)
  return [
    ...seconds,
    ...doubledNames(program, rows[0]),
    ...rowsFindings(rows, 'hat', { sockets, names }),
    ...calledBy(program, rows).flatMap((block) => {
      const own = namesIn(program, rows[0], [block], block)
      return blockFindings(block, 'function', { sockets, names: own })
    }),
    ...idle,
  ]
}

/** Networks, and learning by trying, that never run: their playgrounds are on the screen all the same. */
function idleFindings(program: Program): Finding[] {
  const { loop } = spotIn(program)
  const putIn = loop === null ? 'problem.fix.intoNewLoop' : 'problem.fix.intoLoop'
  const networks = networksByUse(program).flatMap(({ id, idle }) => {
    if (idle === null || idle === 'off') return []
    const problem = idle === 'loose' ? 'problem.looseNetwork' : 'problem.networkBehind'
    return [{ block: id, problem, putIn, stops: false }]
  })
  const map = learningIn(program)?.blocks.map
  if (map === undefined || reachedIn(program).has(map)) return networks
  return [
    ...networks,
    { block: map, problem: 'problem.looseLearning', putIn: 'problem.fix.underStart', stops: false },
  ]
}

const said = (block: Block | undefined, name: string, stops = true): Finding => ({
  block: block?.id ?? '',
  problem: `problem.${name}`,
  stops,
})

type Place = Definition['look']['shape']

interface Around {
  readonly sockets: CheckContext
  readonly names: Names
}

function rowsFindings(rows: readonly Block[], top: Place, around: Around): Finding[] {
  const running = rows.filter(({ disabled }) => disabled !== true)
  return [
    ...running.flatMap((block, k) => blockFindings(block, k === 0 ? top : 'statement', around)),
    ...neverReached(running),
  ]
}

function neverReached(rows: readonly Block[]): Finding[] {
  const loop = rows.findIndex(isEndless)
  const next = loop < 0 ? undefined : rows[loop + 1]
  return next ? [said(next, 'neverReached', false)] : []
}

function blockFindings(block: Block, place: Place, around: Around): Finding[] {
  const definition = definitionOf(block)
  // A file may hold blocks that are unknown here: its program runs up to the first of them that is reached.
  if (!definition) return [said(block, 'unknownBlock', false)]
  if (shapeOf(block, definition.look) !== place) return [said(block, 'wrongKind')]
  const own = [
    ...rules.flatMap((rule) => rule(block, definition, around.sockets)),
    ...nameProblems(block, around.names),
  ]
  const inner = definition.loops ? { ...around, names: { ...around.names, inLoop: true } } : around
  return [
    ...own.map((finding) => ({ block: block.id, ...finding })),
    ...holesOf(block, definition).flatMap((hole) => holeFindings(hole, around)),
    ...writtenFindings(block, definition, around),
    ...Object.values(block.statements ?? {}).flatMap((rows) => rowsFindings(rows, 'statement', inner)),
  ]
}

function holeFindings({ child, accepts, target }: Hole, around: Around): Finding[] {
  if (!child) return []
  if (target && child.type !== 'variables_get') return [said(child, 'wrongKind')]
  return valueFindings(child, accepts, around)
}

function valueFindings(child: Block, accepts: Hole['accepts'], around: Around): Finding[] {
  const definition = definitionOf(child)
  const output = definition && outputOf(child, definition)
  if (output && !fits(output, accepts)) return [said(child, 'wrongKind')]
  return blockFindings(child, 'value', around)
}

/** May this be plugged in there, as far as that can be told before the run? */
export const fits = (output: Output, accepts: Hole['accepts']): boolean =>
  output === 'any' || accepts === 'any' || accepts.includes(output)

/** What is written as text is said at the block it is written in. */
function writtenFindings(block: Block, definition: Definition, around: Around): Finding[] {
  const written = definition.written?.(block)
  if (!written) return []
  if ('error' in written) return [{ block: block.id, ...written.error }]
  const output = outputOf(block, definition) ?? 'any'
  return Object.values(written.values).flatMap((child) =>
    valueFindings(child, output === 'any' ? 'any' : [output], around).map((finding) => ({
      ...finding,
      block: block.id,
    })),
  )
}
