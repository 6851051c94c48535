import type { Block } from '@botgarten/blocks'
import type { Program } from '../types.ts'
import { apply } from './apply.ts'
import { differences, same } from './settings.ts'
import { beginning, type State } from './state.ts'
import { blocksIn, indexOf, pruned, spotsIn, type Spot } from './tree.ts'
import { parts, type Operation, type Place, type Shared } from './types.ts'

/** What makes the second of the first. */
export function diff(before: Shared, after: Shared): readonly Operation[] {
  const names = Object.keys(after.programs)
  const gone = Object.keys(before.programs).filter((name) => !Object.hasOwn(after.programs, name))
  return [
    ...names.flatMap((name) => inProgram(name, before.programs[name], after.programs[name]!)),
    ...differences(before.brains, after.brains, 2).map((one) => ({ kind: 'knob' as const, ...one })),
    ...differences(before.world, after.world, 99).map((one) => ({ kind: 'thing' as const, ...one })),
    ...gone.map((program) => ({ kind: 'program' as const, program, value: null })),
  ]
}

function inProgram(program: string, before: Program | undefined, after: Program): readonly Operation[] {
  if (!before) return [{ kind: 'program', program, value: after }]
  return before.stacks === after.stacks ? [] : new Steps(program, before).to(after)
}

/** The way from one program to another, tried out on the way. */
class Steps {
  private readonly program: string
  private readonly state: State
  private readonly found: Operation[] = []

  constructor(program: string, before: Program) {
    this.program = program
    this.state = beginning({ programs: { [program]: before }, brains: {}, world: {} as Shared['world'] })
  }

  private get index() {
    return indexOf(this.state.doc.programs[this.program]!.stacks)
  }

  private step(op: Operation): void {
    this.found.push(op)
    apply(this.state, { by: 'a', n: 0, base: Infinity, op }, 0)
  }

  to(after: Program): readonly Operation[] {
    const wanted = indexOf(after.stacks)
    const isGone = ({ id }: Block) => !wanted.has(id)
    this.delete((block) => blocksIn(block).every(isGone))
    for (const spot of spotsIn(after.stacks)) this.bring(spot, wanted)
    this.delete(isGone)
    return this.found
  }

  private delete(isMeant: (block: Block) => boolean): void {
    for (const [id, { block }] of this.index)
      if (isMeant(block))
        if (this.index.has(id)) this.step({ kind: 'delete', program: this.program, block: id })
  }

  private bring(spot: Spot, wanted: ReadonlyMap<string, Spot>): void {
    const { program } = this
    const { id } = spot.block
    const here = this.index.get(id)
    if (!here) {
      const block = pruned(spot.block, (one) => this.index.has(one))
      this.step({ kind: 'add', program, block, place: this.entrance(spot) })
    } else if (!same(this.remaining(here, wanted), spot.place))
      this.step({ kind: 'move', program, block: id, place: this.entrance(spot) })
    // Put before others, it stands where they stood.
    const now = this.index.get(id)
    if (now && 'x' in spot.place && !same(now.place, spot.place))
      this.step({ kind: 'move', program, block: id, place: spot.place })
    if (here) this.edit(here.block, spot.block)
  }

  /** Before the stack that it is to begin. */
  private entrance({ block, place, next }: Spot): Place {
    const follows = next !== null && !this.index.has(block.id) ? this.index.get(next) : undefined
    return follows && 'x' in place && 'x' in follows.place ? { before: next! } : place
  }

  /** Where a block is once those before it are gone that go. */
  private remaining({ place }: Spot, wanted: ReadonlyMap<string, Spot>): Place {
    if (!('after' in place) || wanted.has(place.after)) return place
    return this.remaining(this.index.get(place.after)!, wanted)
  }

  private edit(before: Block, after: Block): void {
    const { program } = this
    const block = after.id
    const [was, is] = [before.fields ?? {}, after.fields ?? {}]
    for (const name of new Set([...Object.keys(was), ...Object.keys(is)]))
      if (was[name] !== is[name]) this.step({ kind: 'field', program, block, name, value: is[name] ?? null })
    for (const name of parts)
      if (!same(before[name], after[name]))
        this.step({ kind: 'part', program, block, name, value: after[name] ?? null })
  }
}
