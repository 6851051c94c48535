import { content } from '@botgarten/content/files'
import { createLab, type Document, type Lab } from '@botgarten/lab'
import { paintFloor, type Floor, type World } from '@botgarten/simulation'
import { Blocks } from '../e2e/runs/blocks.ts'
import { behaviours } from '../e2e/runs/programs.ts'
import { pushingWorld } from '../e2e/runs/worlds.ts'
import { median, type Table } from './bench.ts'

const minute = 60 * 60

interface Course {
  readonly name: string
  readonly goal: number | null
  readonly document: Document
  readonly floor: Floor
}

function friendship(name: string, goal: number | null, change: (document: Document) => Document): Course {
  const { world } = content.card('friendship')!
  const program = content.program('friendship', 'solution')!
  const floor = content.floorOf(world)
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

/** A long floor: the network drives straight on and has boxes before it all the time. */
function pushing(name: string, goal: number | null, boxes: number): Course {
  const { robots, obstacles } = pushingWorld(0)
  const box = { ...obstacles[0]!, shape: { kind: 'rectangle', width: 24, height: 24 } as const }
  const world: World = {
    ...{ size: { width: 3000, height: 300 }, floor: { colour: '#FFFFFF' }, areas: [], lines: [] },
    robots: robots.map((robot) => ({ ...robot, pose: { x: 30, y: 150, heading: 0 } })),
    obstacles: Array.from({ length: boxes }, (_, index) => ({
      ...{ ...box, id: `box${index}` },
      pose: { x: 60 + 26 * index, y: 150, heading: 0 },
    })),
  }
  const document = { ...straightOn(), world }
  return { name, goal, document, floor: paintFloor(world) }
}

function straightOn() {
  const make = new Blocks()
  const inputs = [make.eye('2'), make.eye('3'), make.brightness()]
  const outputs = [make.wheel('C'), make.wheel('B')]
  const { block, brain } = make.net(inputs, outputs, [[], [], [0.4, 0.4]])
  return { programs: { main: make.program(make.forever(block)) }, brains: { [block.id]: brain } }
}

/** In the end it is jammed in a corner with a box: the hardest that can happen to the physics. */
function jammed(): Course {
  const document = { ...behaviours.followsEyes(1), world: pushingWorld(0) }
  return { name: 'network, in a crowd of eight', goal: null, document, floor: paintFloor(document.world) }
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
    pushing('network, pushing one box', 1000, 1),
    pushing('network, pushing three boxes in a row', null, 3),
    jammed(),
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
      'In the crowd it is soon jammed in a corner with a box: the hardest that can happen to the physics.',
    ],
  }
}
