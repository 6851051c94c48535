import * as v from 'valibot'
import type { Block } from '@botgarten/blocks'
import { blockSchema } from '../project/schema-program.ts'
import type { Stack } from '../types.ts'
import { applySetting } from './apply-setting.ts'
import type { Grave, State } from './state.ts'
import {
  blocksIn,
  changed,
  heightOf,
  indexOf,
  inserted,
  loosePlace,
  pruned,
  shifted,
  targetOf,
  without,
} from './tree.ts'
import type { Entry, Operation, Place } from './types.ts'

// The common program is the first one with all entries applied in their order. An entry that was made without knowing
// another one meets it here: an edit wins over a deletion, a move into itself is dropped.

/** Blocks hang in each other at most so deep. */
const deepest = 150

type Of<Kind extends Operation['kind']> = Extract<Operation, { kind: Kind }>
type OnBlock = Exclude<Operation, { kind: 'knob' | 'thing' | 'program' }>

/** Changes the state by an entry that has this place in the common order. */
export function apply(state: State, entry: Entry, seq: number): void {
  const { op } = entry
  if (op.kind === 'knob' || op.kind === 'thing') applySetting(state, entry, op, seq)
  else if (op.kind === 'program') applyProgram(state, op)
  else if (Object.hasOwn(state.doc.programs, op.program)) new OnProgram(state, entry, op, seq).apply()
}

function applyProgram(state: State, { program, value }: Of<'program'>): void {
  const { doc } = state
  const { [program]: _, ...others } = doc.programs
  // A robot does not lose its program.
  if (value === null && doc.world.robots.some((robot) => robot.program === program)) return
  state.doc = { ...doc, programs: value === null ? others : { ...others, [program]: value } }
}

/** One entry on the blocks of one program. */
class OnProgram {
  private readonly state: State
  private readonly entry: Entry
  private readonly op: OnBlock
  private readonly seq: number

  constructor(state: State, entry: Entry, op: OnBlock, seq: number) {
    this.state = state
    this.entry = entry
    this.op = op
    this.seq = seq
  }

  apply(): void {
    const { op } = this
    if (op.kind === 'add') this.add(op)
    else if (op.kind === 'move') this.move(op)
    else if (op.kind === 'delete') this.delete(op)
    else if (op.kind === 'field') this.edit(op.block, (block) => withField(block, op))
    else this.edit(op.block, (block) => withPart(block, op))
  }

  private get stacks(): readonly Stack[] {
    return this.state.doc.programs[this.op.program]!.stacks
  }
  private set stacks(stacks: readonly Stack[]) {
    const { doc } = this.state
    const program = { ...doc.programs[this.op.program]!, stacks }
    this.state.doc = { ...doc, programs: { ...doc.programs, [this.op.program]: program } }
  }

  private has(id: string): boolean {
    return indexOf(this.stacks).has(id)
  }
  private key(id: string): string {
    return `${this.op.program}/${id}`
  }
  private touch(id: string): void {
    const { touched } = this.state
    touched.set(this.key(id), { ...touched.get(this.key(id)), [this.entry.by]: this.seq })
  }

  /** The deletion of a block that this entry's author did not know of. */
  private unknownGrave(id: string): Grave | null {
    const grave = this.state.graves.get(this.key(id))
    return grave && grave.by !== this.entry.by && grave.at >= this.entry.base ? grave : null
  }

  private add({ block, place }: Of<'add'>): void {
    if (this.has(block.id) || heightOf(block) > deepest) return
    const target = this.standing(place)
    // It may have come back with what it is put into.
    if (this.has(block.id)) return this.touch(block.id)
    const fresh = pruned(block, (id) => this.has(id))
    for (const { id } of blocksIn(fresh)) this.touch(id)
    this.forget(fresh)
    this.put(fresh, target)
  }

  private move({ block: id, place }: Of<'move'>): void {
    if (!this.has(id) && !this.unknownGrave(id)) return
    const target = this.standing(place)
    const block = indexOf(this.stacks).get(id)?.block ?? this.takeFromGrave(id)
    if (!block) return
    // A move into itself is none.
    if (blocksIn(block).some((one) => one.id === targetOf(target))) {
      if (!this.has(id)) this.put(block, loosePlace(this.stacks))
      return
    }
    this.touch(id)
    if ('x' in target && 'x' in (indexOf(this.stacks).get(id)?.place ?? {}))
      this.stacks = shifted(this.stacks, id, target.x, target.y)
    else {
      this.stacks = without(this.stacks, id)
      this.put(block, target)
    }
  }

  private put(block: Block, place: Place): void {
    if ('in' in place) this.touch(place.in)
    const depth = (indexOf(this.stacks).get(targetOf(place))?.depth ?? 0) + 1
    const fits = depth + heightOf(block) <= deepest
    this.stacks = inserted(this.stacks, block, fits ? place : loosePlace(this.stacks))
  }

  private delete({ block: id }: Of<'delete'>): void {
    const spot = indexOf(this.stacks).get(id)
    if (!spot) return
    const { by, base } = this.entry
    const other = by === 'a' ? 'b' : 'a'
    const blocks = blocksIn(spot.block)
    // The one who deletes it has not seen what the other one has just done to it.
    if (blocks.some((one) => (this.state.touched.get(this.key(one.id))?.[other] ?? -1) >= base)) return
    const place = 'x' in spot.place && spot.next !== null ? { before: spot.next } : spot.place
    const grave: Grave = { block: spot.block, place, at: this.seq, by }
    for (const one of blocks) this.state.graves.set(this.key(one.id), grave)
    this.stacks = without(this.stacks, id)
  }

  private edit(id: string, change: (block: Block) => Block): void {
    const grave = this.has(id) ? null : this.unknownGrave(id)
    if (grave) this.revive(grave)
    if (!this.has(id)) return
    this.touch(id)
    this.stacks = changed(this.stacks, id, change)
  }

  /** A place whose blocks are there: those that were deleted meanwhile come back, where something hangs in them. */
  private standing(place: Place): Place {
    if ('x' in place) return place
    const target = targetOf(place)
    if (this.has(target)) return place
    const grave = this.unknownGrave(target)
    if (!grave) return loosePlace(this.stacks)
    // Beside it is where it was.
    if (!('in' in place) && grave.block.id === target) return this.standingOf(grave)
    this.revive(grave)
    return place
  }

  private standingOf({ place }: Grave): Place {
    if ('x' in place) return place
    const target = targetOf(place)
    if (this.has(target)) return place
    const grave = this.state.graves.get(this.key(target))
    const beside = !('in' in place) && grave?.block.id === target
    return beside ? this.standingOf(grave) : loosePlace(this.stacks)
  }

  private revive(grave: Grave): void {
    if (this.has(grave.block.id)) return
    const block = pruned(grave.block, (id) => this.has(id))
    const place = this.standingOf(grave)
    this.forget(grave.block)
    this.put(block, place)
  }

  /** A part of what was deleted, out of it. */
  private takeFromGrave(id: string): Block | null {
    const grave = this.unknownGrave(id)
    const block = grave && blocksIn(grave.block).find((one) => one.id === id)
    if (!block) return null
    this.forget(block)
    const rest = { ...grave, block: pruned(grave.block, (one) => one === id) }
    if (block !== grave.block)
      for (const one of blocksIn(rest.block)) this.state.graves.set(this.key(one.id), rest)
    return pruned(block, (one) => this.has(one))
  }

  private forget(block: Block): void {
    for (const { id } of blocksIn(block)) this.state.graves.delete(this.key(id))
  }
}

function withField(block: Block, { name, value }: Of<'field'>): Block {
  const { [name]: _, ...others } = block.fields ?? {}
  const fields = value === null ? others : { ...block.fields, [name]: value }
  const { fields: _before, ...own } = block
  return Object.keys(fields).length > 0 ? { ...own, fields } : own
}

function withPart(block: Block, { name, value }: Of<'part'>): Block {
  const { [name]: _, ...own } = block
  if (value === null) return own
  const bare = { id: block.id, type: block.type, [name]: value }
  return v.is(blockSchema, bare) ? { ...own, [name]: bare[name] } : block
}
