import type { Block } from '@botgarten/blocks'
import type { Stack } from '../types.ts'
import type { Place } from './types.ts'

type Stacks = readonly Stack[]
type Row = readonly Block[]

/** A block and where it is. */
export interface Spot {
  readonly block: Block
  readonly place: Place
  /** The next in its row. */
  readonly next: string | null
  /** How many blocks it hangs in. */
  readonly depth: number
}

/** All blocks in reading order: a block before what hangs in it, and before what follows it. */
export function spotsIn(stacks: Stacks): readonly Spot[] {
  const found: Spot[] = []
  for (const { x, y, blocks } of stacks) row(blocks, { x, y }, 0)
  return found

  function row(blocks: Row, first: Place, depth: number) {
    blocks.forEach((block, k) => {
      const place = k === 0 ? first : { after: blocks[k - 1]!.id }
      spot(block, place, blocks[k + 1]?.id ?? null, depth)
    })
  }
  function spot(block: Block, place: Place, next: string | null, depth: number) {
    found.push({ block, place, next, depth })
    for (const [value, child] of Object.entries(block.values ?? {}))
      spot(child, { in: block.id, value }, null, depth + 1)
    for (const [statement, blocks] of Object.entries(block.statements ?? {}))
      row(blocks, { in: block.id, statement }, depth + 1)
  }
}

/** The block that a place is named by; '' where it is none. */
export function targetOf(place: Place): string {
  if ('x' in place) return ''
  return 'in' in place ? place.in : 'after' in place ? place.after : place.before
}

const indexes = new WeakMap<Stacks, ReadonlyMap<string, Spot>>()

/** All blocks by their ids. */
export function indexOf(stacks: Stacks): ReadonlyMap<string, Spot> {
  const known = indexes.get(stacks)
  if (known) return known
  const made = new Map(spotsIn(stacks).map((spot) => [spot.block.id, spot]))
  indexes.set(stacks, made)
  return made
}

/** The block and all that hangs in it. */
export const blocksIn = (block: Block): readonly Block[] =>
  spotsIn([{ x: 0, y: 0, blocks: [block] }]).map((spot) => spot.block)

/** How many levels of blocks hang in each other. */
export const heightOf = (block: Block): number =>
  1 + spotsIn([{ x: 0, y: 0, blocks: [block] }]).reduce((most, { depth }) => Math.max(most, depth), 0)

/** What becomes of a block: nothing, itself, or it with others beside it. */
type Visit = (block: Block) => Row

/** What is not changed stays the same object. */
function rewriteRow(row: Row, visit: Visit): Row {
  const next = row.flatMap((block) => visit(rewriteInside(block, visit)))
  return next.length === row.length && next.every((block, k) => block === row[k]) ? row : next
}

function rewriteInside(block: Block, visit: Visit): Block {
  const values = mapped(block.values, (child) => rewriteRow([child], visit)[0])
  const statements = mapped(block.statements, (row) => {
    const next = rewriteRow(row, visit)
    return next.length > 0 || next === row ? next : undefined
  })
  if (values === block.values && statements === block.statements) return block
  const { values: _values, statements: _statements, ...own } = block
  return { ...own, ...(values && { values }), ...(statements && { statements }) }
}

type Named<Part> = { readonly [name: string]: Part } | undefined

function mapped<Part>(record: Named<Part>, change: (part: Part) => Part | undefined): Named<Part> {
  if (!record) return record
  const before = Object.entries(record)
  const after = before.flatMap(([name, part]) => {
    const next = change(part)
    return next === undefined ? [] : [[name, next] as const]
  })
  if (after.length === 0) return before.length === 0 ? record : undefined
  const same = after.length === before.length && after.every(([, part], k) => part === before[k]![1])
  return same ? record : Object.fromEntries(after)
}

function rewrite(stacks: Stacks, visit: Visit): Stacks {
  const next = stacks.flatMap((stack) => {
    const blocks = rewriteRow(stack.blocks, visit)
    return blocks === stack.blocks ? [stack] : blocks.length > 0 ? [{ ...stack, blocks }] : []
  })
  return next.length === stacks.length && next.every((stack, k) => stack === stacks[k]) ? stacks : next
}

export const without = (stacks: Stacks, id: string): Stacks =>
  rewrite(stacks, (block) => (block.id === id ? [] : [block]))

export const changed = (stacks: Stacks, id: string, change: (block: Block) => Block): Stacks =>
  rewrite(stacks, (block) => (block.id === id ? [change(block)] : [block]))

/** A subtree without these blocks and what hangs in them. */
export const pruned = (block: Block, gone: (id: string) => boolean): Block =>
  rewriteInside(block, (one) => (gone(one.id) ? [] : [one]))

/** Moves the stack that begins with this block. */
export const shifted = (stacks: Stacks, id: string, x: number, y: number): Stacks =>
  stacks.map((stack) => (stack.blocks[0]?.id === id ? { ...stack, x, y } : stack))

const besides = 60
const below = 120

/** Where a block lies that has no place: below all others. */
export const loosePlace = (stacks: Stacks): Place => ({
  x: besides,
  y: stacks.reduce((low, { y }) => Math.max(low, y), 0) + below,
})

const alone = (stacks: Stacks, block: Block, place: Place): Stacks => {
  const { x, y } = ('x' in place ? place : loosePlace(stacks)) as { x: number; y: number }
  return [...stacks, { x, y, blocks: [block] }]
}

/** Only presets hang in it: they come back by themselves. */
const isPreset = (block: Block) => blocksIn(block).every(({ shadow }) => shadow === true)

/**
 * Puts a block where it belongs; a place that is not there any more is none: it lies alone then. What stood in its socket
 * lies alone too, a preset goes.
 */
export function inserted(stacks: Stacks, block: Block, place: Place): Stacks {
  if ('x' in place) return alone(stacks, block, place)
  const target = targetOf(place)
  const spot = indexOf(stacks).get(target)
  if (!spot) return alone(stacks, block, place)
  if ('value' in place) return plugged(stacks, block, spot.block, place.value)
  if ('statement' in place) return changed(stacks, target, (outer) => putFirst(outer, place.statement, block))
  // Nothing follows what is plugged into a socket.
  if ('value' in spot.place) return alone(stacks, block, place)
  return rewrite(stacks, (one) => {
    if (one.id !== target) return [one]
    return 'after' in place ? [one, block] : [block, one]
  })
}

const putFirst = (outer: Block, name: string, block: Block): Block => ({
  ...outer,
  statements: { ...outer.statements, [name]: [block, ...(outer.statements?.[name] ?? [])] },
})

function plugged(stacks: Stacks, block: Block, outer: Block, name: string): Stacks {
  const before = outer.values?.[name]
  const yields = !before || isPreset(before)
  if (!yields && isPreset(block)) return stacks
  const free = yields ? stacks : alone(stacks, before, { after: '' })
  return changed(free, outer.id, (one) => ({ ...one, values: { ...one.values, [name]: block } }))
}
