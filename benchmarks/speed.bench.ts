import { readFileSync } from 'node:fs'
import { createLab, type Document, type Lab } from '@botgarten/lab'
import { paintFloor, type Floor, type World } from '@botgarten/simulation'
import { behaviours } from '../e2e/runs/programs.ts'
import { pushingWorld } from '../e2e/runs/worlds.ts'
import { median, type Table } from './bench.ts'

const minute = 60 * 60
const content = new URL('../content/', import.meta.url)
const readJson = (path: string) => JSON.parse(readFileSync(new URL(path, content), 'utf8')) as unknown

interface Course {
  readonly name: string
  readonly goal: number | null
  readonly document: Document
  readonly floor: Floor
}

function friendship(name: string, goal: number | null, change: (document: Document) => Document): Course {
  const world = readJson('worlds/friendship/world.json') as World
  const program = readJson('cards/network/05-friendship/solution.json') as Omit<Document, 'world'>
  const floor = paintFloor(world, readFileSync(new URL('worlds/friendship/floor.png', content)))
  return { name, goal, floor, document: change({ ...program, world }) }
}

/** Both wheels follow one eye, unequally: it circles on the free floor for ever. */
function circling(document: Document): Document {
  const brains = Object.entries(document.brains).map(([id, brain]) => {
    const weights = { eyeLeft: { wheelLeft: 0.6, wheelRight: 0.25 } }
    return [id, { ...brain, weights }]
  })
  return { ...document, brains: Object.fromEntries(brains) as Document['brains'] }
}

/** The network drives and always has things before it. */
function pushing(name: string, things: number): Course {
  const crowd = pushingWorld(0)
  const obstacles = crowd.obstacles.filter(({ fixed }) => !fixed).slice(-things)
  const document = { ...behaviours.followsEyes(1), world: { ...crowd, obstacles } }
  return { name, goal: 1000, document, floor: paintFloor(document.world) }
}

function begin({ document, floor }: Course): Lab {
  const lab = createLab()
  lab.load(document, floor, { seed: 1, checks: [] })
  lab.start()
  return lab
}

function timesRealTime(course: Course): number {
  const lab = begin(course)
  const before = process.threadCpuUsage()
  lab.advance(minute)
  const { user, system } = process.threadCpuUsage(before)
  return 60e6 / (user + system)
}

/** Share of ticks of the minute in which it drove, and in which it touched something. */
function shares(course: Course) {
  const lab = begin(course)
  let [driving, touching] = [0, 0]
  for (let tick = 0; tick < minute; tick += 1) {
    lab.advance(1)
    const robot = lab.view().robots[0]!
    if (Object.values(robot.motors).some((percent) => percent !== 0)) driving += 1
    if (robot.touching.length > 0) touching += 1
  }
  return [driving, touching].map((ticks) => `${Math.round((100 * ticks) / minute)} %`)
}

/** How much faster than a clock a lab runs without a screen. */
export default function speed(): Table {
  const courses = [
    friendship('Friendship, its solution', null, (document) => document),
    friendship('Friendship, circling on the free floor', 2000, circling),
    pushing('network, pushing one thing', 1),
    pushing('network, pushing three things', 3),
    pushing('network, pushing in a crowd of seven', 7),
  ]
  for (const course of courses) timesRealTime(course)
  const rows = courses.map((course) => {
    const runs = Array.from({ length: 9 }, () => timesRealTime(course))
    const goal = course.goal === null ? '' : `≥ ${course.goal} ×`
    return [course.name, `${Math.round(median(runs))} ×`, goal, ...shares(course)]
  })
  return {
    title: 'Speed without a screen',
    how: 'One simulated minute with interpreter, network, rays, trail and hash on one core (processor time of the thread); median of nine runs after a warm-up.',
    columns: ['run', 'times real time', 'goal', 'driving', 'touching'],
    rows,
    notes: [
      'driving, touching: share of the ticks in which a motor ran, and in which the body touched something.',
    ],
  }
}
