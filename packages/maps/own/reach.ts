import type { RoadMap } from '@botgarten/programs'

/** What can be said of a map before anybody learns on it. */
export interface Reach {
  /** Stations of a way of fewest roads from the start to a goal; null: there is none. */
  readonly way: readonly number[] | null
  /** Stations to which no open road leads from the start. */
  readonly lost: readonly number[]
  /** Stations, not goals, from which there is no way but back, or none at all. */
  readonly deadEnds: readonly { readonly station: number; readonly out: boolean }[]
  /** A shortest circle of three stations or more, ending where it begins; null: there is none. */
  readonly circle: readonly number[] | null
}

/** By station, to which others open roads lead, in the order of their numbers. */
export function openRoads({ stations, roads }: Pick<RoadMap, 'stations' | 'roads'>): readonly number[][] {
  const exits: number[][] = stations.map(() => [])
  for (const { from, to, oneWay, closed } of roads) {
    if (closed !== 'both' && closed !== 'there') exits[from]!.push(to)
    if (!oneWay && closed !== 'both' && closed !== 'back') exits[to]!.push(from)
  }
  return exits.map((list) => list.toSorted((a, b) => a - b))
}

/** Can the robot get there? */
export function reachOf(map: RoadMap): Reach {
  const exits = openRoads(map)
  const before = searchFrom(exits, map.start)
  const goals = map.goals.filter((goal) => before.has(goal)).map((goal) => wayTo(before, goal))
  return {
    way: goals.toSorted((a, b) => a.length - b.length)[0] ?? null,
    lost: exits.flatMap((_, station) => (before.has(station) ? [] : [station])),
    deadEnds: deadEndsOf(map, exits),
    circle: circleIn(exits),
  }
}

/** Breadth first: by station that was reached, from where. */
function searchFrom(exits: readonly (readonly number[])[], start: number): Map<number, number> {
  const before = new Map<number, number>(start < exits.length ? [[start, -1]] : [])
  for (const station of before.keys())
    for (const next of exits[station]!) if (!before.has(next)) before.set(next, station)
  return before
}

function wayTo(before: ReadonlyMap<number, number>, goal: number): number[] {
  const way: number[] = []
  for (let station = goal; station >= 0; station = before.get(station)!) way.unshift(station)
  return way
}

function deadEndsOf({ goals, start }: RoadMap, exits: readonly (readonly number[])[]): Reach['deadEnds'] {
  return exits.flatMap((list, station) => {
    const entries = exits.flatMap((others, from) => (others.includes(station) ? [from] : []))
    const around = new Set([...list, ...entries])
    if (goals.includes(station) || station === start || around.size !== 1) return []
    return [{ station, out: list.length > 0 }]
  })
}

function circleIn(exits: readonly (readonly number[])[]): readonly number[] | null {
  let best: readonly number[] | null = null
  for (let start = 0; start < exits.length; start++) {
    for (const first of exits[start]!) {
      // Not straight back: the road to the first station is left out on the way home.
      const others = exits.map((list, from) => (from === first ? list.filter((to) => to !== start) : list))
      const before = searchFrom(others, first)
      if (!before.has(start)) continue
      const circle = [start, ...wayTo(before, start)]
      if (circle.length > 3 && (best === null || circle.length < best.length)) best = circle
    }
  }
  return best
}
