import { moveAll } from './move.ts'
import type { Points, Rounds } from './types.ts'

/**
 * Points and groups in two tables of their own, so that the loop below reaches all it needs from two places.
 *
 * `rows`, 4 numbers a point: x, y · as far at least every other centre is, plus what its group's `gone` was when that was
 * seen · where its group begins on the board.
 *
 * `board`, 8 numbers a group: x, y of its centre · `gone`: how far the others have come nearer at most, over all rounds,
 * were they to run straight at it · how many points it has, and their sums along x and y.
 */
interface Tables {
  readonly rows: Float64Array
  readonly board: Float64Array
}

/** Lloyd's rounds on a plane, with straight distances. */
export function roundsOnPlane(points: Points, groups: number): Rounds {
  const tables = { rows: rowsFor(points), board: new Float64Array(8 * groups) }
  let first = true
  const labels = () => labelsIn(tables.rows)
  return {
    labels,
    next(centres) {
      putCentres(tables.board, centres)
      const found = assignOn(tables)
      const moved = means(tables.board) ?? moveAll(points, labels(), centres, 'euclidean').centres
      noteGone(tables.board, moved)
      const changed = first || found.changed
      first = false
      return { inertia: found.inertia, changed, centres: moved }
    },
  }
}

function rowsFor({ values, count }: Points): Float64Array {
  const rows = new Float64Array(4 * count)
  for (let point = 0; point < count; point++) {
    rows[4 * point] = values[2 * point]!
    rows[4 * point + 1] = values[2 * point + 1]!
    rows[4 * point + 2] = -Infinity
  }
  return rows
}

function labelsIn(rows: Float64Array): Int32Array {
  const labels = new Int32Array(rows.length / 4)
  for (let point = 0; point < labels.length; point++) labels[point] = rows[4 * point + 3]! / 8
  return labels
}

function putCentres(board: Float64Array, centres: Float64Array): void {
  for (let at = 0; at < board.length; at += 8) {
    board[at] = centres[at / 4]!
    board[at + 1] = centres[at / 4 + 1]!
    board.fill(0, at + 3, at + 6)
  }
}

/**
 * A point stays where it is when no other centre can be nearer: all of them were farther away and have not come that near
 * since (the bounds of G. Hamerly, _Making k-means even faster_, 2010). They are held a little low, for what rounding does
 * and for squares too small to be told apart. All in one loop: this is what thousands of points wait for.
 */
function assignOn({ rows, board }: Tables): { readonly inertia: number; readonly changed: boolean } {
  let inertia = 0
  let changed = false
  for (let at = 0; at < rows.length; at += 4) {
    const x = rows[at]!
    const y = rows[at + 1]!
    const own = rows[at + 3]! | 0
    let best = own
    let least = squareTo(x, y, board, own)
    const room = rows[at + 2]! - board[own + 2]!
    if (!(least < room * Math.abs(room) - 1e-280)) {
      let second = (least = Infinity)
      best = 0
      for (let group = 0; group < board.length; group += 8) {
        const away = squareTo(x, y, board, group)
        if (away < least) {
          second = least
          least = away
          best = group
        } else if (away < second) second = away
      }
      rows[at + 2] = Math.sqrt(second) * (1 - 1e-9) + board[best + 2]!
      rows[at + 3] = best
      if (best !== own) changed = true
    }
    inertia += least
    board[best + 3]! += 1
    board[best + 4]! += x
    board[best + 5]! += y
  }
  return { inertia, changed }
}

function squareTo(x: number, y: number, board: Float64Array, group: number): number {
  const right = x - board[group]!
  const up = y - board[group + 1]!
  return right * right + up * up
}

/** The middles of all groups; null where one has no points. */
function means(board: Float64Array): Float64Array | null {
  const found = new Float64Array(board.length / 4)
  for (let at = 0; at < board.length; at += 8) {
    const count = board[at + 3]!
    if (count === 0) return null
    found[at / 4] = board[at + 4]! / count
    found[at / 4 + 1] = board[at + 5]! / count
  }
  return found
}

/** For each group, the farthest that any other one goes is added. */
function noteGone(board: Float64Array, after: Float64Array): void {
  const ways = Array.from({ length: after.length / 2 }, (_, group) =>
    Math.sqrt(squareTo(after[2 * group]!, after[2 * group + 1]!, board, 8 * group)),
  )
  ways.forEach((_, group) => {
    const most = ways.reduce((most, way, other) => (other === group ? most : Math.max(most, way)), 0)
    board[8 * group + 2] = (board[8 * group + 2]! + most) * (1 + 1e-9)
  })
}
