import { samePose, type Pose, type RobotState, type Simulation } from '@botgarten/simulation'
import type { Run } from './run.ts'
import { newTrack } from './timeline/tracks.ts'

interface Placed {
  readonly id: string
  readonly pose: Pose
}

type Poses = { readonly [id: string]: Pose }

/**
 * What is in both worlds with the same start pose stays where it stands; the rest is put down where it `stood` once, else
 * at its start pose. Returns where that is, for what came to its start.
 */
export function carryOver(from: Simulation, to: Simulation, stood: Poses = {}): Poses {
  const [was, next] = [from.keyframe(), to.keyframe()]
  const before = new Map(everything(from).map(({ id, pose }) => [id, pose]))
  const isNew = everything(to).filter(({ id, pose }) => {
    const was = before.get(id)
    return !was || !samePose(was, pose)
  })
  const news = new Set(isNew.map(({ id }) => id))
  const ids = new Set(['edge', ...everything(to).map(({ id }) => id)])
  const things = new Map(was.obstacles.map((thing) => [thing.id, thing]))
  const robots = next.robots.map((robot, index) => {
    const { id } = to.world.robots[index]!
    const old = was.robots[from.world.robots.findIndex((one) => one.id === id)]
    if (!old) return robot
    const { x, y, heading } = robot
    return touchingOnly(news.has(id) ? { ...old, x, y, heading } : old, ids)
  })
  const obstacles = next.obstacles.map((thing) => (news.has(thing.id) ? thing : things.get(thing.id)!))
  to.restore({ ...next, tick: was.tick, noise: was.noise, robots, obstacles })
  const came = isNew.map(({ id, pose }) => [id, to.place(id, stood[id] ?? pose)] as const)
  to.settle()
  return Object.fromEntries(came.filter(([id]) => !stood[id]))
}

const everything = ({ world }: Simulation): readonly Placed[] => [...world.obstacles, ...world.robots]

const touchingOnly = (robot: RobotState, ids: ReadonlySet<string>): RobotState => ({
  ...robot,
  touching: robot.touching.filter((id) => ids.has(id)),
})

/** A run goes on from one whose document was changed under it: what is in both goes on as it was. */
export function goOnFrom(before: Run, run: Run): void {
  run.tick = before.tick
  run.hash = [...before.hash]
  run.watches = structuredClone(before.watches)
  run.endedAt = before.endedAt
  run.trials.state = structuredClone(before.trials.state)
  run.tracks = run.robots.map(({ id }) => before.tracks[indexIn(before, id)] ?? newTrack())
  for (const robot of run.robots) {
    const was = before.robots[indexIn(before, robot.id)]
    if (was?.program !== robot.program) run.endedAt = null
    else robot.thread = structuredClone(was.thread)
    for (const [id, last] of was?.brains.lastRuns ?? []) robot.brains.lastRuns.set(id, last)
  }
}

const indexIn = ({ robots }: Run, robot: string) => robots.findIndex(({ id }) => id === robot)
