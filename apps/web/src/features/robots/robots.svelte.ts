import { weightsFor, withBeside } from './beside.ts'
import { withoutRobot, withRobot, type NewRobot } from '#lab/robots.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { most } from '@botgarten/programs'

/** The robots of a world, for the row of chips: who is there, whose program and network are shown. */
export class Robots {
  #session: LabSession
  /** Does the child choose what a new robot is to be? */
  asking = $state(false)
  /** Ids, joined: equal from frame to frame. */
  #ids = $derived.by(() => this.#session.lab.document.world.robots.map(({ id }) => id).join(' '))
  ids = $derived.by(() => this.#ids.split(' '))

  constructor(session: LabSession) {
    this.#session = session
  }

  get chosen() {
    return this.#session.robotId
  }
  get full() {
    return this.ids.length >= most.robots
  }

  /** Name of the weight set that a robot drives with, '' where it has none but its own. */
  setOf(id: string): string {
    const { brain } = this.#session.lab.document.world.robots.find((robot) => robot.id === id) ?? {}
    return brain === id || brain === undefined ? '' : brain
  }

  choose(id: string): void {
    this.#session.choose(id)
  }

  add(kind: NewRobot): void {
    this.asking = false
    if (this.full) return
    const { id, document } = withRobot(this.#session.lab.document, this.chosen, kind)
    this.#session.apply({ kind: 'robots', after: document })
    this.choose(id)
  }

  /** The card whose weights a second robot can bring, as long as Bo is alone. */
  get beside() {
    return this.ids.length > 1 ? undefined : this.#session.opened.card?.card.beside
  }

  /** The second robot with the weights of the other card, called `name`. */
  async addBeside(name: string): Promise<void> {
    const { beside } = this
    if (!beside) return
    this.asking = false
    const weights = await weightsFor(beside)
    if (!this.beside) return
    const { id, document } = withBeside(this.#session.lab.document, { ...beside, weights }, name)
    this.#session.apply({ kind: 'robots', after: document })
    this.choose(id)
  }

  /** The first robot stays: a card's goals look at it. */
  remove(): void {
    if (this.chosen === this.ids[0]) return
    const after = withoutRobot(this.#session.lab.document, this.chosen)
    this.#session.apply({ kind: 'robots', after })
  }
}
