import type { Block, Finding } from '@botgarten/blocks'
import { declaredIn, functionBlocks } from '../run/index-program.ts'
import type { Program } from '../types.ts'
import { definitionOf } from './places.ts'

type Said = Omit<Finding, 'block'>

/** What a block may name where it stands. */
export interface Names {
  readonly variables: ReadonlySet<string>
  /** How many values each function wants. */
  readonly functions: ReadonlyMap<string, number>
  readonly inLoop: boolean
  readonly inFunction: boolean
}

/** Blocks inside a block, those that are written as text included. */
function inside(block: Block): readonly Block[] {
  const written = definitionOf(block)?.written?.(block)
  return [
    ...Object.values(block.values ?? {}),
    ...(written && 'values' in written ? Object.values(written.values) : []),
    ...Object.values(block.statements ?? {}).flat(),
  ]
}

/** A block with all that is in it, outer before inner; what is switched off is left out. */
export function within(block: Block): readonly Block[] {
  const found: Block[] = []
  const waiting = [block]
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    if (next.disabled === true) continue
    found.push(next)
    waiting.push(...inside(next))
  }
  return found
}

const nameIn = ({ fields }: Block): string => fields?.VAR ?? ''
const parametersOf = (block: Block) => declaredIn(block.statements?.ST).map(nameIn)
const counters = (blocks: readonly Block[]) =>
  blocks
    .flatMap(within)
    .filter(({ type }) => /^robControls_for/.test(type))
    .map(nameIn)

/** Names in the program's own rows, or in those of one of its functions. */
export function namesIn(
  program: Program,
  start: Block | undefined,
  rows: readonly Block[],
  own?: Block,
): Names {
  const parameters = own ? parametersOf(own) : []
  const ofProgram = declaredIn(start?.statements?.ST).map(nameIn)
  const functions = functionBlocks(program).map(
    (block) => [block.fields?.NAME ?? '', parametersOf(block).length] as const,
  )
  return {
    variables: new Set([...ofProgram, ...parameters, ...counters(rows)]),
    functions: new Map(functions),
    inLoop: false,
    inFunction: own !== undefined,
  }
}

/** The functions that these rows call, and those that are called by them, each once. */
export function calledBy(program: Program, rows: readonly Block[]): readonly Block[] {
  const all = functionBlocks(program)
  const called: Block[] = []
  const waiting = [...rows]
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    for (const { type, mutation } of within(next)) {
      if (!/^robProcedures_call/.test(type)) continue
      const found = all.find(({ fields }) => fields?.NAME === mutation?.attrs.name)
      if (!found || called.includes(found)) continue
      called.push(found)
      waiting.push(found)
    }
  }
  return called
}

const stop = (name: string, facts?: Finding['facts']): Said => ({
  problem: `problem.${name}`,
  ...(facts && { facts }),
  stops: true,
})

function callProblem({ mutation }: Block, { functions }: Names): readonly Said[] {
  const name = mutation?.attrs.name ?? ''
  const wanted = functions.get(name)
  if (wanted === undefined) return [stop('noSuchFunction', { name })]
  return wanted === (mutation?.args?.length ?? 0) ? [] : [stop('wrongArguments', { name })]
}

/** Variables, functions and loops that a block names and that are not there. */
export function nameProblems(block: Block, names: Names): readonly Said[] {
  const name = nameIn(block)
  if (/^variables_/.test(block.type) && !names.variables.has(name)) return [stop('noSuchVariable', { name })]
  if (/^robProcedures_call/.test(block.type)) return callProblem(block, names)
  if (block.type === 'controls_flow_statements' && !names.inLoop) return [stop('notInLoop')]
  return block.type === 'robProcedures_ifreturn' && !names.inFunction ? [stop('notInFunction')] : []
}

/** Two variables, parameters or functions with one name: said at the second. */
export function doubledNames(program: Program, start: Block | undefined): readonly Finding[] {
  const functions = functionBlocks(program)
  const groups = [start, ...functions].map((block) => declaredIn(block?.statements?.ST))
  return [
    ...groups.map((group) => doubled(group, nameIn)),
    doubled(functions, ({ fields }) => fields?.NAME ?? ''),
  ].flat()
}

function doubled(blocks: readonly Block[], nameOf: (block: Block) => string): readonly Finding[] {
  const seen = new Set<string>()
  return blocks.flatMap((block) => {
    const name = nameOf(block)
    const again = seen.has(name)
    seen.add(name)
    return again ? [{ block: block.id, ...stop('sameName', { name }) }] : []
  })
}
