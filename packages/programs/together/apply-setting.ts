import * as v from 'valibot'
import { brainSchema } from '../project/schema-brain.ts'
import { worldSchema } from '../project/schema-world.ts'
import { getIn, setIn } from './settings.ts'
import type { State } from './state.ts'
import type { Entry, Json, Setting } from './types.ts'

/** How many names lead to what is deleted as a whole: a network, or a thing of a list of the world. */
const depth = { knob: 1, thing: 2 } as const

/** Sets a part of a network or of the world, unless it would be none then. */
export function applySetting(state: State, entry: Entry, op: Setting, seq: number): void {
  const unit = op.path.slice(0, depth[op.kind])
  const key = [op.kind, ...unit].join('/')
  if (op.path.length <= depth[op.kind] && op.value === null) remove(state, entry, op, key, seq)
  else change(state, entry, op, unit, key, seq)
}

function remove(state: State, { by, base }: Entry, op: Setting, key: string, seq: number): void {
  const other = by === 'a' ? 'b' : 'a'
  if ((state.touched.get(key)?.[other] ?? -1) >= base) return
  const value = getIn(rootOf(state, op), op.path)
  if (value === undefined) return
  if (set(state, op)) state.lost.set(key, { value, at: seq, by })
}

function change(
  state: State,
  { by, base }: Entry,
  op: Setting,
  unit: readonly string[],
  key: string,
  seq: number,
): void {
  const lost = state.lost.get(key)
  const isUnknown = lost && lost.by !== by && lost.at >= base
  const isThere = getIn(rootOf(state, op), unit) !== undefined
  // An edit wins over a deletion that its author did not know of.
  if (!isThere && isUnknown) set(state, { ...op, path: unit, value: lost.value })
  else if (!isThere && op.path.length > unit.length) return
  if (!set(state, op)) return
  state.lost.delete(key)
  state.touched.set(key, { ...state.touched.get(key), [by]: seq })
}

const rootOf = ({ doc }: State, { kind }: Setting): Json => (kind === 'knob' ? doc.brains : doc.world)

/** @returns whether it is still a network, or a world */
function set(state: State, { kind, path, value }: Setting): boolean {
  const { doc } = state
  if (kind === 'knob') {
    const brains = setIn(doc.brains, path, value) as typeof doc.brains | undefined
    const [name] = path
    if (!brains || (Object.hasOwn(brains, name!) && !v.is(brainSchema, brains[name!]))) return false
    state.doc = { ...doc, brains }
    return true
  }
  const world = setIn(doc.world, path, value)
  if (!isWorld(world) || !world.robots.every(({ program }) => Object.hasOwn(doc.programs, program)))
    return false
  state.doc = { ...doc, world }
  return true
}

/** No photo goes from one child to another here: the floor is one of the product's. */
const isWorld = (world: Json): world is State['doc']['world'] =>
  v.is(worldSchema, world) && isOfProduct((world as State['doc']['world']).floor)

const isOfProduct = (floor: State['doc']['world']['floor']) =>
  !('asset' in floor) || floor.asset.startsWith('content:')
