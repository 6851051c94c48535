import { exp, ln } from '@botgarten/numbers'
import { BLOCK, takeRows } from './block.ts'
import { forwardBlock } from './forward-block.ts'
import { forwardOver } from './forward.ts'
import type { Practice, Rows } from './types.ts'

/** What a network is measured with. */
export type Measured = Pick<Practice, 'net' | 'parameters' | 'sums' | 'values' | 'block'>

/** L of the row that ran last: (1/m) Σ (y − t)², or −Σ t ln y. */
export function lossOf({ net, sums, values }: Measured, { targets }: Rows, row: number): number {
  const layer = net.layers.at(-1)
  if (!layer) return 0
  const { to, outputs } = layer
  if (net.shares) return entropy(sums, to, outputs, targets, row)
  let loss = 0
  for (let j = 0; j < outputs; j++) {
    const off = values[to + j]! - targets[row * outputs + j]!
    loss += off * off
  }
  return loss / outputs
}

/** −Σ t ln softmax(z), with ln softmax(z) = z − ln Σ exp z, from the largest down. */
function entropy(sums: Float64Array, at: number, count: number, targets: Float64Array, row: number): number {
  let most = -Infinity
  for (let j = at; j < at + count; j++) if (sums[j]! > most) most = sums[j]!
  let all = 0
  for (let j = at; j < at + count; j++) all += exp(sums[j]! - most)
  const whole = most + ln(all)
  let loss = 0
  for (let j = 0; j < count; j++) loss += targets[row * count + j]! * (whole - sums[at + j]!)
  return loss
}

/** The mean loss over rows with the weights of now; null where there are none. Writes over the values of the last run. */
export function meanLoss(practice: Measured, rows: Rows): number | null {
  if (rows.count === 0) return null
  const sum = practice.net.shares ? lossOneByOne(practice, rows) : lossInBlocks(practice, rows)
  return sum / rows.count
}

function lossOneByOne(practice: Measured, rows: Rows): number {
  let sum = 0
  for (let row = 0; row < rows.count; row++) {
    forwardOver(practice, rows.inputs, row)
    sum += lossOf(practice, rows, row)
  }
  return sum
}

/** The same bits, several rows at once. */
function lossInBlocks(practice: Measured, rows: Rows): number {
  const width = practice.net.layers[0]?.inputs ?? 0
  let sum = 0
  for (let from = 0; from < rows.count; from += BLOCK) {
    const size = Math.min(BLOCK, rows.count - from)
    takeRows(practice.block, rows, width, from, size)
    forwardBlock(practice, size)
    for (let r = 0; r < size; r++) sum += lossInBlock(practice, rows, from, r)
  }
  return sum
}

function lossInBlock({ net, block }: Measured, { targets }: Rows, from: number, r: number): number {
  const { to, outputs } = net.layers[net.layers.length - 1]!
  let loss = 0
  for (let j = 0; j < outputs; j++) {
    const off = block.values[(to + j) * BLOCK + r]! - targets[(from + r) * outputs + j]!
    loss += off * off
  }
  return loss / outputs
}

/** How far off outputs typically are: the root of the mean square, in percent. Of cross-entropy there is none. */
export const percentOff = (loss: number): number => 100 * Math.sqrt(loss)

/**
 * How many rows are right. `one`: of several lamps the highest above 0 is the one that was shown, or none is above 0 where none
 * was shown; `each`: every word is above 0 where it was shown, and no other.
 */
export function rightRows(practice: Measured, rows: Rows, kind: 'one' | 'each'): number {
  const { to = 0, outputs = 0 } = practice.net.layers.at(-1) ?? {}
  let right = 0
  for (let row = 0; row < rows.count; row++) {
    forwardOver(practice, rows.inputs, row)
    const found = practice.values.subarray(to, to + outputs)
    const wanted = rows.targets.subarray(row * outputs, (row + 1) * outputs)
    const same =
      kind === 'one'
        ? highest(found) === highest(wanted)
        : found.every((value, j) => value > 0 === wanted[j]! > 0)
    if (same) right++
  }
  return right
}

/** The first of the highest values, −1 where none is above 0. */
function highest(values: Float64Array): number {
  let best = -1
  values.forEach((value, j) => {
    if (value > (best < 0 ? 0 : values[best]!)) best = j
  })
  return best
}
