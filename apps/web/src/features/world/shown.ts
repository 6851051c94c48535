import type { View } from '@botgarten/lab'
import type { Pose, World } from '@botgarten/simulation'
import type { Badge } from '#drawing/badges.ts'
import type { Point, Size } from '#drawing/points.ts'
import type { Slots } from '#lab/slots.ts'

/** What the world's pane shows. */
export interface Shown {
  readonly world: World
  /** A new object once a frame. */
  readonly view: View
  /** Id of the robot whose rays are shown. */
  readonly robot: string
  readonly showRays: boolean
  /** Ports whose sensors are shown; null: all. */
  readonly ports: readonly string[] | null
  /** What is written beside the robot. */
  readonly badges: readonly Badge[]
  readonly showTrail: boolean
  readonly gap: GapOnFloor | null
  readonly inside: Slots['inside'] | null
  readonly senses: Slots['senses'] | null
  /** What is seen of the floor, in px of its box. */
  readonly place: Size & Point
}

/** From one place to another, in cm, with what is written at it. */
export interface GapOnFloor {
  readonly from: Point
  readonly to: Point
  readonly label: string
  /** Where the run began, as the next one will; null: near where it ended, or nothing to say. */
  readonly began: Pose | null
}
