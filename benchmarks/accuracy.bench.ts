import type { Block } from '@botgarten/blocks'
import { createLab } from '@botgarten/lab'
import { paintFloor, type Pose, type World } from '@botgarten/simulation'
import { Blocks } from '../e2e/runs/blocks.ts'
import { pushingWorld } from '../e2e/runs/worlds.ts'
import type { Table } from './bench.ts'

const start: Pose = { x: 100, y: 150, heading: 0 }
const powers = [10, 50, 100]

function emptyWorld(): World {
  const world = pushingWorld(0)
  const robots = world.robots.map((robot) => ({ ...robot, pose: start }))
  return { ...world, obstacles: [], robots }
}

/** Where the robot stands after one block and what it still rolls. */
function after(order: (make: Blocks) => Block): Pose {
  const make = new Blocks()
  const world = emptyWorld()
  const lab = createLab()
  const document = { programs: { main: make.program(order(make)) }, brains: {}, world }
  lab.load(document, paintFloor(world), { seed: 1, checks: [] })
  lab.start()
  lab.advance(60 * 60)
  return lab.view().robots[0]!.pose
}

const right = (heading: number) => (((start.heading - heading) % 360) + 360) % 360
const row = (what: string, power: number, wanted: number, got: number, bound: number) => [
  ...[what, `${power} %`, wanted, got.toFixed(6)],
  ...[Math.abs(got - wanted).toExponential(1), bound],
]

/** How exactly moves by angle and by distance end. */
export default function accuracy(): Table {
  const turns = powers.map((power) => {
    const { heading } = after((make) => make.turnRight(power, 90))
    return row('turn right, °', power, 90, right(heading), 0.5)
  })
  const ways = powers.map((power) => {
    const { x, y } = after((make) => make.drive(power, 100))
    return row('drive forwards, cm', power, 100, Math.hypot(x - start.x, y - start.y), 0.5)
  })
  return {
    title: 'Accuracy of moves',
    how: 'One block on an empty floor, run by the interpreter; the pose after it has ended.',
    columns: ['block', 'power', 'wanted', 'reached', 'off by', 'at most'],
    rows: [...turns, ...ways],
    notes: ['A move that would overshoot in a tick scales its last tick (running.md 4).'],
  }
}
