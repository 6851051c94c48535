import type { NetworkLayout } from '#drawing/network.ts'
import { clamp, type Point, type Size } from '#drawing/points.ts'
import { stagger, type Track } from '#drawing/track.ts'

const radius = { smallest: 22, largest: 34 }
/** Label and room between rows. */
const belowNode = 46
/** Between nodes of hidden layers, whose names are one line. */
const betweenNodes = 24
/** Over the first row: weights of level links, and what makes a layer larger and smaller. */
const above = { plain: 34, tools: 56 }
const side = 68
const narrowest = 150
/** Of one resting knob. */
const target = 46

/**
 * Node places for layers of so many neurons. Columns keep so far apart that every resting knob of a gap has room of its
 * own; the stage grows beyond its room for that, and is panned.
 */
export function layoutDeep(room: Size, counts: readonly number[], tools: boolean): NetworkLayout {
  const top = tools ? above.tools : above.plain
  const ends = Math.max(1, counts[0] ?? 0, counts.at(-1) ?? 0)
  const between = Math.max(1, ...counts.slice(1, -1))
  const free = room.height - top
  const size = clamp(
    Math.min(free / ends - belowNode, free / between - betweenNodes) / 2,
    radius.smallest,
    radius.largest,
  )
  const height = top + Math.max(free, ends * (2 * size + belowNode), between * (2 * size + betweenNodes))
  const xs = columnsAt(room.width, gapsFor(counts, size, height))
  const column = (count: number, x: number, at: number) => {
    const share = (height - top) / count
    const named = at === 0 || at === counts.length - 1
    const middle = (share - (named ? belowNode : betweenNodes)) / 2
    return Array.from({ length: count }, (_, k) => ({ x, y: top + k * share + middle }))
  }
  return {
    radius: size,
    columns: counts.map((count, k) => column(count, xs[k]!, k)),
    stage: { width: Math.max(room.width, Math.round((xs.at(-1) ?? 0) + side)), height },
    labels: 'below',
    labelWidth: 2 * side - 4,
    places: true,
  }
}

const gapsFor = (counts: readonly number[], size: number, height: number): readonly number[] =>
  counts.slice(1).map((to, k) => {
    const links = to * counts[k]!
    return Math.max(narrowest, 2 * size + 40, 2 * size + (links * target * target * 2.2) / height)
  })

/** What a wide room has to spare goes between the columns. */
function columnsAt(width: number, gaps: readonly number[]): readonly number[] {
  const least = gaps.reduce((sum, gap) => sum + gap, 2 * side)
  const spare = gaps.length > 0 ? Math.max(0, width - least) / gaps.length : 0
  const xs = [gaps.length > 0 ? side : width / 2]
  for (const gap of gaps) xs.push(xs.at(-1)! + gap + spare)
  return xs
}

// More links than this are settled one after the other.
const few = 30

/** Keeps resting knobs apart: a few links as well as can be, many as well as one pass can. */
export function settleDeep(tracks: readonly Track[]): readonly Track[] {
  const settled: Track[] = [...tracks]
  for (const links of byColumn(tracks)) {
    const own = links.map((k) => tracks[k]!)
    const done = own.length <= few ? stagger(own) : settleMany(own)
    links.forEach((k, at) => (settled[k] = done[at]!))
  }
  return settled
}

/** Links stand column after column: a new column begins where one starts further right than others end. */
function byColumn(tracks: readonly Track[]): readonly (readonly number[])[] {
  const columns: number[][] = []
  let end = -Infinity
  tracks.forEach(({ from, to }, k) => {
    if (from.x > end) {
      columns.push([])
      end = to.x
    }
    columns.at(-1)!.push(k)
  })
  return columns
}

/** Each link takes, of the places on its track, the one that is farthest from the knobs that rest already. */
function settleMany(tracks: readonly Track[]): readonly Track[] {
  const taken = new Map<string, { x: number; y: number }[]>()
  const cell = (x: number, y: number) => `${Math.floor(x / target)} ${Math.floor(y / target)}`
  const nearest = (x: number, y: number) => {
    let least = 2 * target
    for (const dx of [-target, 0, target])
      for (const dy of [-target, 0, target])
        for (const other of taken.get(cell(x + dx, y + dy)) ?? [])
          least = Math.min(least, Math.hypot(other.x - x, other.y - y))
    return least
  }
  return tracks.map((track) => {
    const { from, to, least } = track
    const [first, last] = least < 0 ? [0.2, 0.76] : [0.08, 0.7]
    let best = { zero: first, gap: -1, x: 0, y: 0 }
    for (let zero = first; zero <= last; zero += 0.02) {
      const [x, y] = [from.x + (to.x - from.x) * zero, from.y + (to.y - from.y) * zero]
      const gap = nearest(x, y)
      if (gap > best.gap + 0.5) best = { zero, gap, x, y }
      if (gap >= target) break
    }
    const key = cell(best.x, best.y)
    taken.set(key, [...(taken.get(key) ?? []), best])
    return { ...track, zero: best.zero }
  })
}

/** From so many links on, only those are drawn that are near what is seen. */
const many = 300
const step = 240

/** Where a big net is looked at, in steps, so that what is drawn changes seldom. */
export const stepOf = ({ x, y }: Point): Point => ({
  x: Math.round(x / step) * step,
  y: Math.round(y / step) * step,
})

/** What of a stage is painted: all that can be seen before it is looked at from the next step. */
export function sightOf(room: Size, stage: Size, at: Point): Size & Point {
  const along = (from: number, seen: number, all: number) => {
    const first = clamp(from - step, 0, all)
    return [first, clamp(from + seen + step, first, all) - first] as const
  }
  const [x, width] = along(at.x, room.width, stage.width)
  const [y, height] = along(at.y, room.height, stage.height)
  return { x, y, width, height }
}

/** Is a link near the part of the stage that is seen? */
export function nearTo(room: Size, at: Point, links: number): ((track: Track) => boolean) | undefined {
  if (links <= many) return undefined
  const [left, right] = [at.x - step, at.x + room.width + step]
  const [top, bottom] = [at.y - step, at.y + room.height + step]
  return ({ from, to }) => {
    if (to.x < left || from.x > right) return false
    const heightAt = (x: number) => from.y + (to.y - from.y) * clamp((x - from.x) / (to.x - from.x), 0, 1)
    const [a, b] = [heightAt(left), heightAt(right)]
    return Math.max(a, b) >= top && Math.min(a, b) <= bottom
  }
}
