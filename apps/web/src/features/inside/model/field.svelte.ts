import { gridOf, readingsAt } from '@botgarten/lab/why'
import type { Pose } from '@botgarten/simulation'
import type { Inside } from '../inside.svelte.ts'
import { inSlices } from './slices.ts'

/** What the sensors read all over the floor. */
export interface Readings {
  readonly poses: readonly Pose[]
  /** cm from pose to pose. */
  readonly spacing: number
  /** Inputs of the network by pose; null where Bo has no room. */
  readonly inputs: readonly (readonly number[] | null)[]
}

const COUNT = 400
/** The way Bo looks is taken in steps of so many degrees: while it turns, not every degree is read again. */
const TURN = 5

/** What Bo would do anywhere on the floor. Readings are kept until the world or the robot changes; weights play no part in them. */
export class Field {
  readonly #inside: Inside
  on = $state(false)
  #readings = $state.raw<Readings | null>(null)
  #busy = false
  #read: readonly unknown[] = []

  constructor(inside: Inside) {
    this.#inside = inside
  }

  get readings() {
    return this.#readings
  }

  /** Reads again where something has changed, one reading at a time. Depends on what is shown. */
  follow(): void {
    const now = this.#state
    if (!this.on || this.#busy || now.every((part, index) => part === this.#read[index])) return
    this.#busy = true
    inSlices(this.#all(now), (readings) => {
      this.#busy = false
      this.#readings = readings
      this.follow()
    })
  }

  /** All that readings depend on. */
  get #state(): readonly unknown[] {
    const { session, net, view } = this.#inside
    const { world, programs } = session.lab.document
    const things = view.obstacles.map(({ pose }) => [pose.x, pose.y, pose.heading].map(Math.round))
    const heading = this.#heading
    return [
      world.areas,
      world.lines,
      world.size,
      world.floor,
      session.config,
      programs,
      net?.id,
      heading,
      String(things),
    ]
  }

  get #heading(): number {
    const { view, session } = this.#inside
    const robot = view.robots.find(({ id }) => id === session.robotId)
    return Math.round((robot?.pose.heading ?? 0) / TURN) * TURN
  }

  *#all(state: readonly unknown[]): Generator<undefined, Readings> {
    const { session, net } = this.#inside
    const { poses, spacing } = gridOf(session.lab.document.world.size, COUNT, this.#heading)
    const ids = net?.inputs.map(({ id }) => id) ?? []
    const inputs = yield* readingsAt(this.#inside.standpoint(), session.robotId, ids, poses)
    this.#read = state
    return { poses, spacing, inputs }
  }
}
