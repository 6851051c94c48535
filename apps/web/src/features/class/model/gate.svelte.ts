import type { Picture } from '@botgarten/classroom/pictures'
import { arrive, beginning, stayHere, whenQuiet } from './here.ts'
import type { Refused } from './joining.svelte.ts'
import type { Member } from './member.svelte.ts'

/**
 * What stands before the page. `asks`: "Are you …?" at a start · `quiet`: after ten minutes · `back`: the child has just come
 * back, and its work comes · `pictures` · `locked` · `signedOut` · `ended` · `hidden`; null: nothing, the page is the child's.
 */
type Question = 'asks' | 'quiet' | 'back' | 'pictures' | 'locked' | 'signedOut' | 'ended' | 'hidden' | null

/** Lets only the pupil of this device to its work. */
export class Gate {
  readonly member: Member
  #question = $state<Question>(null)
  #busy = $state(false)
  #refused = $state.raw<Refused | null>(null)
  /** How the work of who came back is coming. */
  #coming = $state<'comes' | 'here' | 'cannotCome'>('comes')
  shown = $state.raw<readonly Picture[]>([])
  #through: () => void
  #stops: (() => void)[] = []

  /** @param through is called when the child is in, once */
  constructor(member: Member, through: () => void) {
    this.member = member
    this.#through = through
    member.whenOver = () => void this.#askAgain()
    const at = beginning(member.account.pupil)
    this.#question = at === 'here' ? null : at
    if (at === 'back') void this.#fetch()
    else if (at === 'here') void this.#enter(true)
  }

  get question() {
    return this.#question
  }
  get busy() {
    return this.#busy
  }
  get refused() {
    return this.#refused
  }
  get coming() {
    return this.#coming
  }

  async #fetch(): Promise<void> {
    this.#coming = (await this.member.fetchWork()) === null ? 'here' : 'cannotCome'
  }

  /** "Yes, that is me." */
  async yes(): Promise<void> {
    if (this.#busy) return
    this.#busy = true
    await this.#enter(false)
    this.#busy = false
  }

  /** @param open the page is shown already: only what the class forbids is asked */
  async #enter(open: boolean): Promise<void> {
    if (open) this.#letThrough()
    const passage = await this.member.enter()
    if (passage === 'ended') await this.member.end()
    if (passage === 'through') {
      if (!open) this.#letThrough()
      void this.member.fetchWork()
    } else this.#stop(passage)
  }

  /** The class has signed this pupil out, or has closed: what it wants to be shown first. */
  async #askAgain(): Promise<void> {
    const passage = await this.member.enter()
    if (passage === 'ended') await this.member.end()
    if (passage === 'through') this.member.live.start()
    else this.#stop(passage)
  }

  #stop(question: Question): void {
    this.member.live.stop()
    this.#question = question
  }

  #letThrough(): void {
    this.member.live.start()
    stayHere(this.member.account.pupil)
    this.#question = null
    this.#through()
    this.#stops.push(whenQuiet(() => (this.#question = 'quiet')))
  }

  /** Who came back has seen that its work is there. */
  goOn(): void {
    this.#letThrough()
  }

  async show(picture: Picture): Promise<void> {
    if (this.#busy || this.shown.includes(picture)) return
    this.shown = [...this.shown, picture]
    if (this.shown.length < 3) return
    this.#busy = true
    this.#refused = await this.member.showPictures(this.shown)
    this.#busy = false
    this.shown = []
    if (this.#refused) return
    arrive(this.member.account.pupil, 'back')
    this.#question = 'back'
    void this.#fetch()
    // What the signed out page could not send goes now.
    void this.member.outbox.flush()
  }

  async leave(): Promise<void> {
    this.#busy = true
    await this.member.leave()
  }

  /** Calls back no more. */
  close(): void {
    for (const stop of this.#stops) stop()
  }
}
