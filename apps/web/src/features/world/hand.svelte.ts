import type { Pose } from '@botgarten/simulation'
import { fullTurn, headingTo } from '#drawing/things.ts'
import type { Phase } from '#drawing/nudge.ts'
import { distance, tenth, type Point } from '#drawing/points.ts'

interface Hold {
  readonly id: string
  readonly pointer: number
  readonly kind: 'move' | 'turn'
  /** Where the finger came down, and the pose at that moment. */
  readonly down: Point
  readonly pose: Pose
  readonly moved: boolean
}

// A finger that trembles less far than this (cm) has tapped.
const slop = 2

/** A child's hand in the world: what is selected, and what is being dragged or turned. Points in cm, y up. */
export class Hand {
  selected = $state<string | null>(null)
  #hold = $state.raw<Hold | null>(null)
  #onplace: (id: string, pose: Pose, phase: Phase) => void
  #at: Pose | null = null

  constructor(onplace: (id: string, pose: Pose, phase: Phase) => void) {
    this.#onplace = onplace
  }

  /** The thing that is on the move in the hand, or null. */
  get dragging(): string | null {
    return this.#hold?.moved ? this.#hold.id : null
  }

  /** Where the hand wants the thing to be. */
  get wanted(): Pose | null {
    return this.dragging ? this.#at : null
  }

  grab(id: string, pose: Pose, kind: 'move' | 'turn', pointer: number, down: Point): void {
    if (this.#hold) return
    this.selected = id
    this.#hold = { id, pose, kind, pointer, down, moved: false }
  }

  move(pointer: number, at: Point): void {
    const hold = this.#hold
    if (hold?.pointer !== pointer) return
    if (!hold.moved) {
      if (distance(hold.down, at) < slop) return
      this.#hold = { ...hold, moved: true }
      this.#onplace(hold.id, hold.pose, 'start')
    }
    this.#at = hold.kind === 'move' ? shifted(hold, at) : turned(hold, at)
    this.#onplace(hold.id, this.#at, 'move')
  }

  /** The world went on under the hand: the thing is held where it is wanted. */
  keep(): void {
    if (this.wanted && this.#hold) this.#onplace(this.#hold.id, this.wanted, 'move')
  }

  release(pointer: number): void {
    const hold = this.#hold
    if (hold?.pointer !== pointer) return
    this.#hold = null
    if (hold.moved && this.#at) this.#onplace(hold.id, this.#at, 'end')
    this.#at = null
  }
}

const shifted = ({ pose, down }: Hold, at: Point): Pose => ({
  ...pose,
  x: tenth(pose.x + at.x - down.x),
  y: tenth(pose.y + at.y - down.y),
})

const turned = ({ pose, down }: Hold, at: Point): Pose => ({
  ...pose,
  heading: Math.round(fullTurn(pose.heading + headingTo(pose, at) - headingTo(pose, down))) % 360,
})
