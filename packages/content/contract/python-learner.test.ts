import { addBlocks, knowMaps } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { courseStream } from '@botgarten/learning/q-learning'
import { learnedFor, placeOf } from '@botgarten/maps'
import { fastDraw, fastStream } from '@botgarten/numbers'
import { learningIn, type Program } from '@botgarten/programs'
import { dialects, pythonFrom, type Dialect } from '@botgarten/programs/python'
import { runPython, tracingRobot } from '@botgarten/programs/python/testing'
import { cardConfig } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'

addBlocks(expert)
addBlocks(learning)
knowMaps(content)

const mapNamed = (id: string) => content.mapFile(id)
const programs = ['railway', 'forest', 'city'].map((id): readonly [string, Program] => {
  const { programs } = content.program(id, 'solution')!
  return [id, Object.values(programs)[0]!]
})

/** The file of a robot that knows nothing and is to learn. */
function learnerFile(program: Program, dialect: Dialect): string {
  const { lesson } = learnedFor(program, mapNamed)
  const input = { name: 'learner', program, config: cardConfig, brains: {}, dialect, learner: true }
  return pythonFrom({ ...input, learned: lesson ? { lesson } : {} }, (key) => key).text
}

/** Where a robot is, told by what it was told. */
interface Place {
  x: number
  y: number
  /** Degrees clockwise from the right. */
  heading: number
}

/** A robot that notes each turn and each way, with a hand that puts it on the station it shows. */
function onFloor(stations: readonly { readonly x: number; readonly y: number }[]) {
  const { robot: bare } = tracingRobot()
  const at: Place = { x: 0, y: 0, heading: 0 }
  /** How far from a station the robot turned. */
  const astray: number[] = []
  let [pressed, shown] = [false, 0]
  const offStation = (one: Place) => Math.min(...stations.map(({ x, y }) => Math.hypot(x - one.x, y - one.y)))
  const go = (left: number, degrees: number, turns: boolean) => {
    const cm = ((degrees * Math.sign(left)) / 360) * Math.PI * cardConfig.wheelDiameter
    if (turns) {
      astray.push(offStation(at))
      at.heading += ((cm * 2) / cardConfig.trackWidth / Math.PI) * 180
    } else {
      at.x += cm * Math.cos((at.heading * Math.PI) / 180)
      at.y -= cm * Math.sin((at.heading * Math.PI) / 180)
    }
  }
  const robot: typeof bare = {
    ...bare,
    read: () => (offStation(at) < 3 ? '#B30006' : '#FFFFFF'),
    motor: () => {},
    display: (_row, _column, text) => void (shown = Number(text)),
    move: ({ left, right, degrees = 0 }) => go(left, degrees, left !== right),
    key() {
      Object.assign(at, stations[shown], { heading: 0 })
      return (pressed = !pressed)
    },
  }
  return { robot, astray }
}

describe.each(dialects)('a robot that goes on learning, with %s', (dialect) => {
  it.each(programs)('learns on %s the table that the lab learns from the same dice', async (_id, program) => {
    const outline = learningIn(program)!
    const map = mapNamed(outline.map)!
    const { table } = learnedFor(program, mapNamed, { seed: 1, moves: Infinity })
    const dice = fastStream(courseStream(1))
    const { robot, astray } = onFloor(map.stations.map((_, station) => placeOf(map, station)))
    const { error, printed } = await runPython(
      learnerFile(program, dialect).replace(/^drive_best_way\(\)$/m, ''),
      robot,
      { tick: () => {}, random: () => fastDraw(dice) },
    )
    expect(error).toBe(null)
    const learned = JSON.parse(printed.at(-1)!.replace(/(\d+):/g, '"$1":')) as typeof table
    for (const [from, row] of Object.entries(table!))
      for (const [to, value] of Object.entries(row))
        expect(learned![Number(from)]![Number(to)]).toBeCloseTo(value, 9)
    expect(Math.max(...astray)).toBeLessThan(2)
  })
})
