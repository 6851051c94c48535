import { definitions, isBlockType, type Block, type Facts } from '@botgarten/blocks'
import { calledBy, nameProblems, namesIn, within, type Names } from '../check/names.ts'
import { declaredIn, functionBlocks, startingStacks } from '../run/index-program.ts'
import type { Program } from '../types.ts'

const writing = ['variables_set', 'robMath_change', 'robText_append', 'robActions_outputneuron']

/** Names that blocks give values to. */
export const assignedIn = (blocks: readonly Block[]): readonly string[] =>
  blocks.flatMap(within).flatMap(({ type, fields, values }) => {
    if (!writing.includes(type)) return []
    const target = type === 'variables_set' ? fields : (values?.VAR ?? values?.VALUE)?.fields
    return target?.VAR === undefined ? [] : [target.VAR]
  })

const acting = (block: Block) => isBlockType(block.type) && definitions[block.type].acts

/** What can be told about a program's blocks before they are written. */
export class Usage {
  readonly program: Program
  readonly start: Block | undefined
  readonly main: readonly Block[]
  readonly functions: readonly Block[]
  readonly globals: readonly string[]
  /** Names where the block that is written stands. */
  names: Names
  readonly #written = new Map<string, Readonly<Record<string, Block>>>()
  readonly #loops = new Map<string, readonly Block[]>()

  constructor(program: Program) {
    this.program = program
    const [start, ...main] = startingStacks(program)[0]?.blocks ?? []
    this.start = start
    this.main = main
    this.functions = functionBlocks(program)
    this.globals = declaredIn(start?.statements?.ST).map(({ fields }) => fields?.VAR ?? '')
    this.names = namesIn(program, start, main)
  }

  /** From now on blocks of a function are written. */
  inside(block: Block): void {
    this.names = { ...namesIn(this.program, this.start, [block], block), inLoop: true }
  }

  inMain(): void {
    this.names = { ...namesIn(this.program, this.start, this.main), inLoop: true }
  }

  problemOf(block: Block): { readonly problem: string; readonly facts?: Facts } | undefined {
    return nameProblems(block, { ...this.names, inLoop: true })[0]
  }

  /** A block that is written in another as text. */
  written(block: Block, input: string): Block | undefined {
    const known = this.#written.get(block.id)
    if (known) return known[input]
    const written = isBlockType(block.type) ? definitions[block.type].written?.(block) : undefined
    const values = written && 'values' in written ? written.values : {}
    this.#written.set(block.id, values)
    return values[input]
  }

  /** Does anything in a block sense, drive, show, sound or run a net? Functions that it calls included. */
  acts(block: Block): boolean {
    const inside = within(block)
    if (inside.some(acting)) return true
    return calledBy(this.program, [block]).some((called) => within(called).some(acting))
  }

  /** Does a variable belong to a loop that counts alone? Then nobody sees what it is afterwards. */
  counts(loop: Block, name: string): boolean {
    const own = new Set(within(loop))
    const mine = (block: Block) => block.fields?.VAR === name && !own.has(block)
    return !assignedIn([loop]).includes(name) && !this.#everyBlock().some(mine)
  }

  #everyBlock(): readonly Block[] {
    const known = this.#loops.get('')
    if (known) return known
    const all = this.program.stacks.flatMap(({ blocks }) => blocks.flatMap(within))
    this.#loops.set('', all)
    return all
  }
}
