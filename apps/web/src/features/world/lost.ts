import type { RobotView, View } from '@botgarten/lab'
import type { World } from '@botgarten/simulation'

/** What is remembered of one robot from moment to moment. `since`: second from which it has been where it is. */
interface Trace {
  readonly since: number
  readonly x: number
  readonly y: number
  readonly heading: number
}

export type Traces = ReadonlyMap<string, Trace>

/** A robot that stays within these (cm, degrees) for so many seconds, pushing, is wedged. */
const slip = { cm: 1.5, degrees: 8, seconds: 3 }
/** Percent; slower motors stand. */
const standing = 3

/** Remembers where robots are and since when. The same map where nothing has changed. */
export function follow(before: Traces, { robots, seconds }: Pick<View, 'robots' | 'seconds'>): Traces {
  const next = robots.map((robot): [string, Trace] => {
    const old = before.get(robot.id)
    const { x, y, heading } = robot.pose
    const stays = old && seconds >= old.since && pushes(robot) && near(old, robot.pose)
    return [robot.id, stays ? old : { since: seconds, x, y, heading }]
  })
  const same = next.length === before.size && next.every(([id, trace]) => before.get(id) === trace)
  return same ? before : new Map(next)
}

/** Id of the first robot that is off the floor, or has pushed against something for seconds without getting anywhere. */
export function lostRobot(
  traces: Traces,
  { robots, seconds }: Pick<View, 'robots' | 'seconds'>,
  size: World['size'],
): string | null {
  const lost = robots.find(
    ({ id, pose }) => isOutside(pose, size) || seconds - since(traces, id) >= slip.seconds,
  )
  return lost?.id ?? null
}

const since = (traces: Traces, id: string) => traces.get(id)?.since ?? Infinity

const isOutside = ({ x, y }: RobotView['pose'], { width, height }: World['size']) =>
  !(x >= 0 && x <= width && y >= 0 && y <= height)

const pushes = ({ motors, touching }: RobotView) =>
  touching.length > 0 && Object.values(motors).some((percent) => Math.abs(percent) >= standing)

function near(trace: Trace, pose: RobotView['pose']): boolean {
  const turned = Math.abs(((pose.heading - trace.heading + 540) % 360) - 180)
  return Math.hypot(pose.x - trace.x, pose.y - trace.y) < slip.cm && turned < slip.degrees
}
