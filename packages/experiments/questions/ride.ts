import { createLab, type Document, type RobotView } from '@botgarten/lab'
import { TICKS_PER_SECOND, type Floor, type Pose, type Seconds } from '@botgarten/simulation'

/** A run of the lab: where its first robot was at every tick, whether it ever touched anything, and how it ended. */
export interface Ride {
  readonly poses: readonly Pose[]
  readonly touched: boolean
  readonly end: RobotView
}

/** Always the same ride: nobody touches anything, and the seed is 1. */
export function rideOf(document: Document, floor: Floor, seconds: Seconds): Ride {
  const lab = createLab()
  lab.load(document, floor, { seed: 1, checks: [] })
  lab.start()
  const robot = () => lab.view().robots[0]!
  const poses = [robot().pose]
  let touched = false
  for (let tick = 0; tick < seconds * TICKS_PER_SECOND; tick++) {
    lab.advance(1)
    const { pose, touching } = robot()
    poses.push(pose)
    touched ||= touching.length > 0
  }
  return { poses, touched, end: robot() }
}
