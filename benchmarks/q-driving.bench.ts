import { content } from '@botgarten/content/files'
import { blockFrom, toolbox } from '@botgarten/blocks'
import { createLab, type Document } from '@botgarten/lab'
import { layOutWorld, type QWorld } from '@botgarten/learning/q-learning'
import { drawWay, type MapFile } from '@botgarten/maps'
import { inScene } from '@botgarten/programs'
import { cardConfig, paintFloor, TICKS_PER_SECOND } from '@botgarten/simulation'
import type { Table } from './bench.ts'

/** The maps, with what the cards close on them. */
const maps: readonly (readonly [id: string, closed: readonly (readonly [number, number])[]])[] = [
  ['railway', [[3, 2], [2, 3]]], // prettier-ignore
  ['forest', [[4, 6]]],
  ['city', [[16, 15]]],
  ['mars', []],
]
/** A robot arrives when it stands so near to the goal, in cm. */
const TOLERANCE = 4
const MOST_OFF = 4
const TICKS_A_LOOK = 3
/** Slower than any robot that follows a line, cm a second. */
const SLOWEST = 3

const mapNamed = (id: string): MapFile => content.mapFile(id)!

const program = () => {
  const shelf = toolbox.flatMap(({ blocks }) => blocks)
  const template = (type: string) => shelf.find((one) => one.type === type)!
  let next = 0
  const blocks = ['robControls_start', 'ai_q_drive_the_best_way'].map((type) =>
    blockFrom(template(type), () => `b${next++}`),
  )
  return { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } }
}

/** Stations of a shortest way by sections; null: there is none. */
function shortest({ start, goal, first, meant }: QWorld): readonly number[] | null {
  const before = new Map<number, number>([[start, -1]])
  const waiting = [start]
  for (const station of waiting)
    for (let road = first[station]!; road < first[station + 1]!; road++) {
      const to = meant[road]!
      if (before.has(to)) continue
      before.set(to, station)
      waiting.push(to)
    }
  if (!before.has(goal)) return null
  const way = [goal]
  while (way[0] !== start) way.unshift(before.get(way[0]!)!)
  return way
}

interface Drive {
  readonly way: string
  readonly off: number
  readonly atGoal: number
  readonly seconds: number
}

function drive(map: MapFile, stations: readonly number[]): Drive {
  const { scene, points } = drawWay(map, stations)
  const robot = { id: 'bo', pose: scene.starts[0]!, program: 'main', brain: '', config: cardConfig }
  const world = inScene({ ...scene, robots: [robot] }, scene)
  const document: Document = { programs: { main: program() }, brains: {}, world }
  const lab = createLab()
  lab.load(document, paintFloor(world), { seed: 1, checks: [] })
  lab.start()
  const end = points.at(-1)!
  let [off, near, still, last] = [0, 0, 0, robot.pose]
  for (
    let left = (points.length / SLOWEST) * TICKS_PER_SECOND;
    left > 0 && still < 20;
    left -= TICKS_A_LOOK
  ) {
    lab.advance(TICKS_A_LOOK)
    const { pose } = lab.view().robots[0]!
    let best = Infinity
    for (let at = Math.max(0, near - 10); at < Math.min(points.length, near + 25); at++) {
      const away = Math.hypot(points[at]!.x - pose.x, points[at]!.y - pose.y)
      if (away < best) [best, near] = [away, at]
    }
    off = Math.max(off, best)
    still = Math.hypot(last.x - pose.x, last.y - pose.y) < 1e-9 ? still + 1 : 0
    last = pose
  }
  const atGoal = Math.hypot(end.x - last.x, end.y - last.y)
  return { way: stations.join('-'), off, atGoal: still < 20 ? Infinity : atGoal, seconds: lab.view().seconds }
}

function drives(map: MapFile, closed: readonly (readonly [number, number])[]): readonly Drive[] {
  const all = map.stations.map((_, station) => station)
  const tasks = all.flatMap((start) => all.filter((goal) => goal !== start).map((goal) => ({ start, goal })))
  const ways = tasks.map((task) => shortest(layOutWorld({ map: map.map, ...task, closed })))
  return ways.flatMap((way) => (way ? [drive(map, way)] : []))
}

const worst = (all: readonly Drive[], by: 'off' | 'atGoal') => all.toSorted((a, b) => b[by] - a[by])[0]!

/** The robot drives what was learned: on every map, from every station to every other one. */
export default function qDriving(): Table {
  const rows = maps.flatMap(([id, closed]) =>
    [[], closed].slice(0, closed.length > 0 ? 2 : 1).map((roads) => {
      const all = drives(mapNamed(id), roads)
      const good = all.filter(({ off, atGoal }) => off <= MOST_OFF && atGoal <= TOLERANCE)
      const [far, late] = [worst(all, 'off'), worst(all, 'atGoal')]
      const named = roads.map((road) => road.join('-')).join(', ')
      return [
        named === '' ? id : `${id}, ${named} closed`,
        ...[all.length, good.length],
        `${far.off.toFixed(2)} cm (${far.way})`,
        `${late.atGoal.toFixed(2)} cm (${late.way})`,
        `${Math.max(...all.map(({ seconds }) => seconds)).toFixed(0)} s`,
      ]
    }),
  )
  return {
    title: 'Driving what was learned',
    how: 'For every pair of stations that a way joins, the shortest way is drawn on the floor and the line follower drives it as it comes from the toolbox, headless, with the robot of the cards.',
    columns: ['map', 'ways', 'driven', 'furthest from the line', 'furthest from the goal', 'longest drive'],
    rows,
    notes: [
      `Driven: the middle of the axle is never more than ${MOST_OFF} cm from the way, and the robot comes to stand at most ${TOLERANCE} cm from the goal.`,
      'The way: 4 cm white on the left, 4 cm black on the right, bends of 12 cm and more, a red bar behind the goal; one wheel at a time with power 30. A black line of 4 cm in white, followed at its edge, was tried too: 2.8 cm off on the railway, where this one is 0.85 cm.',
    ],
  }
}
