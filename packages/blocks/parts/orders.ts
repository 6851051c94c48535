import type { Order, Robot, Value } from '../types.ts'
import { percent } from './numbers.ts'
import { nothing } from './texts.ts'

type Kind = Order['order']

/** A tone neuron's level 1 sounds so many hertz high. */
export const hertzPerLevel = 5

// Plain loops, no closures: a net runs in every tick.
const isOrder = (value: Value | undefined): value is Order =>
  typeof value === 'object' && value !== null && 'order' in value

function has(kind: Kind, values: readonly Value[]): boolean {
  for (const value of values) if (isOrder(value) && value.order === kind) return true
  return false
}

/** Of several above 0 the highest wins; of equals the upper one. null: none is above 0. */
function highest<K extends Kind>(kind: K, values: readonly Value[]): Extract<Order, { order: K }> | null {
  let best: Order | null = null
  for (const value of values) {
    if (isOrder(value) && value.order === kind && value.level > (best?.level ?? 0)) best = value
  }
  return best as Extract<Order, { order: K }> | null
}

function drive(values: readonly Value[], robot: Robot) {
  for (const value of values) {
    if (isOrder(value) && value.order === 'motor') robot.motor(value.port, percent(value.level))
  }
}

/** Each word has its own row, top to bottom. */
function show(values: readonly Value[], robot: Robot) {
  let row = 0
  for (const value of values) {
    if (isOrder(value) && value.order === 'text')
      robot.display(row++, 0, value.level > 0 ? value.text : nothing)
  }
}

/** What the output neurons want, together: all motors and words, of lamps and tones one each. */
export function executeOrders(values: readonly Value[], robot: Robot): void {
  drive(values, robot)
  show(values, robot)
  if (has('led', values)) robot.led(highest('led', values)?.colour ?? null)
  if (has('sound', values)) robot.tone((highest('sound', values)?.level ?? 0) * hertzPerLevel, null)
}
