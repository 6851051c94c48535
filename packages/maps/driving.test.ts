import { content } from '@botgarten/content/files'
import { createLab } from '@botgarten/lab'
import { addBlocks, blockFrom, toolbox, type Template } from '@botgarten/blocks'
import { learning as blocks, learningToolbox } from '@botgarten/blocks/packs/learning'
import { cardConfig, paintFloor, TICKS_PER_SECOND, type Pose } from '@botgarten/simulation'
import { describe, expect, test } from 'vitest'
import { followerProgram } from './follower.ts'
import {
  drawWay,
  driveSeconds,
  liesOn,
  readMap,
  wayFault,
  wayThrough,
  withLearnedWay,
  type MapFile,
} from './index.ts'
import { addRoad, addStation, emptyMap, writeMap } from './own/index.ts'

const mapNamed = (id: string): MapFile => content.mapFile(id)!

const start: Template = { type: 'robControls_start', mutation: { attrs: { declare: 'false' } } }
addBlocks(blocks, learningToolbox)
const templates = toolbox.find(({ category }) => category === 'q-learning')!.blocks

function documentOf(...rows: readonly Template[]) {
  let next = 0
  const blocks = [start, ...rows].map((row) => blockFrom(row, () => `b${next++}`))
  const robot = {
    id: 'bo',
    pose: { x: 20, y: 20, heading: 0 },
    program: 'main',
    brain: '',
    config: cardConfig,
  }
  return {
    programs: { main: { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } } },
    brains: {},
    world: {
      ...{ size: { width: 100, height: 100 }, floor: { colour: '#FFFFFF' } },
      ...{ areas: [], lines: [], obstacles: [], robots: [robot] },
    },
  }
}

const learning = ['states_and_actions_map', 'config', 'rule', 'draw', 'drive'].map((part) =>
  templates.find(({ type }) => type.includes(part))!,
)

function run(document: ReturnType<typeof documentOf>, seconds: number): Pose {
  const lab = createLab()
  lab.load(document, paintFloor(document.world), { seed: 1, checks: [] })
  lab.start()
  lab.advance(seconds * TICKS_PER_SECOND)
  return lab.view().robots[0]!.pose
}

describe('a way over stations', () => {
  test('leaves the middle of a bend, never bends tighter than 12 cm, and ends on the goal', () => {
    const { points, heading } = wayThrough(mapNamed('city'), [0, 1, 2, 7, 9, 11, 14, 15])
    const chords = points
      .slice(1)
      .map((point, index) => Math.hypot(point.x - points[index]!.x, point.y - points[index]!.y))
    expect(Math.max(...chords)).toBeLessThan(1.5)
    const turns = chords.slice(1).map((chord, index) => {
      const [a, b, c] = points.slice(index, index + 3) as [Pose, Pose, Pose]
      const turn = Math.atan2(c.y - b.y, c.x - b.x) - Math.atan2(b.y - a.y, b.x - a.x)
      return Math.abs(Math.atan2(Math.sin(turn), Math.cos(turn))) / ((chord + chords[index]!) / 2)
    })
    // Where arcs meet short pieces are measured: 11 cm leaves room for that.
    expect(1 / Math.max(...turns)).toBeGreaterThan(11)
    expect(heading).toBeGreaterThan(-180)
  })

  test('over a road that is not there is refused', () => {
    expect(() => drawWay(mapNamed('railway'), [0, 3])).toThrow('No road leads from 0 to 3.')
  })

  test('that crosses itself or turns on the spot is none that the robot can drive', () => {
    const places = [[200, 700], [1200, 700], [1200, 200], [600, 900], [700, 700]] // prettier-ignore
    const stations = places.reduce((map, [x, y]) => addStation(map, { x: x!, y: y! }), emptyMap('bridge'))
    const pairs = [[0, 1], [1, 2], [2, 3], [3, 4]] as const // prettier-ignore
    const drawn = pairs.reduce((map, [from, to]) => addRoad(map, from, to), stations)
    const map = readMap(writeMap(drawn, 'bridge')).map!
    expect(wayFault(map, [0, 1, 2])).toBeNull()
    expect(wayFault(map, [0, 1, 2, 3])).toEqual({ kind: 'crosses' })
    expect(wayFault(map, [2, 3, 4])).toEqual({ kind: 'turn', station: 3 })
  })

  test('lies on the map that it was drawn from, and on no other floor', () => {
    const map = mapNamed('railway')
    const { scene } = drawWay(map, [3, 5, 0, 1])
    expect(liesOn(map, scene)).toBe(true)
    expect(liesOn(mapNamed('forest'), scene)).toBe(false)
    expect(liesOn(map, { ...scene, areas: [] })).toBe(false)
    const [disc, ...discs] = scene.areas
    const moved = { ...disc!, pose: { ...disc!.pose, x: disc!.pose.x + 1 } }
    expect(liesOn(map, { ...scene, areas: [moved, ...discs] })).toBe(false)
  })
})

describe('the line follower from the toolbox', () => {
  test.each([
    ['railway', [3, 5, 0, 1]],
    ['railway', [1, 0, 5, 3]],
    ['forest', [0, 2, 3, 5, 7]],
    ['mars', [0, 3, 4, 5, 8]],
  ] as const)('%s: drives %s and stands on the goal', (id, stations) => {
    const map = mapNamed(id)
    const { scene, points } = drawWay(map, stations)
    const { starts, ...floor } = scene
    const plain = documentOf()
    const robots = plain.world.robots.map((robot) => ({ ...robot, pose: starts[0]! }))
    const world = { ...plain.world, ...floor, robots } as never
    const document = { ...plain, programs: { main: followerProgram() as never }, world }
    const end = run(document, 90)
    expect(Math.hypot(end.x - points.at(-1)!.x, end.y - points.at(-1)!.y)).toBeLessThan(4)
    // What is said before about how long it takes is true.
    const seconds = driveSeconds(map, stations)
    const almost = run(document, Math.round(0.85 * seconds))
    const there = run(document, Math.round(1.15 * seconds))
    expect(Math.hypot(almost.x - end.x, almost.y - end.y)).toBeGreaterThan(4)
    expect(Math.hypot(there.x - end.x, there.y - end.y)).toBeLessThan(1)
  })

  test('learns, draws and drives as the blocks come from the toolbox', () => {
    const document = withLearnedWay(documentOf(...learning), mapNamed)
    const { stations, cmPerUnit, size } = mapNamed('railway')
    const goal = { x: stations[1]!.x * cmPerUnit, y: (size.height - stations[1]!.y) * cmPerUnit }
    const end = run(document, 90)
    expect(Math.hypot(end.x - goal.x, end.y - goal.y)).toBeLessThan(4)
  })

  test('nothing is drawn where nothing was learned', () => {
    const [map, ...others] = learning
    const closedOff = { ...map!, fields: { ...map!.fields, FINISH: '3' } }
    const document = documentOf(closedOff, ...others)
    expect(withLearnedWay(document as never, mapNamed)).toBe(document)
  })
})
