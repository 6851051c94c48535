import type { RobotKey } from '@botgarten/simulation'
import type { Run } from '../run.ts'
import type { Lab } from '../types.ts'
import type { DriveKey, Hand, Input, Recording, Wheels } from './input.ts'

/** What hands need of a lab. */
export interface Grip {
  readonly run: () => Run
  /** Has a run begun that is not over? */
  readonly isOn: () => boolean
  readonly branch: () => void
  readonly give: (input: Input) => void
}

type Verbs = Pick<
  Lab,
  'setWeight' | 'setBrain' | 'setTraining' | 'drive' | 'record' | 'remember' | 'press' | 'pressButton'
>

/** Turns what hands do into inputs of the run, and knows what they hold, whatever moment is shown. */
export class HandsOnLab implements Verbs {
  readonly #grip: Grip
  #keys: readonly DriveKey[] = []
  /** On the pad, and what is recorded: as it was asked for. */
  #hand: Hand | null = null
  #recording: Recording | null = null
  #buttons: readonly { readonly robot: number; readonly key: RobotKey }[] = []
  /** Has a hand driven a robot while no run was on? Then that is where it starts. */
  drove = false

  constructor(grip: Grip) {
    this.#grip = grip
  }

  get #run(): Run {
    return this.#grip.run()
  }

  setWeight: Lab['setWeight'] = (brain, from, to, weight, set = '') => {
    this.#grip.branch()
    this.#grip.give({ kind: 'weight', brain, from, to, weight, set })
  }

  setBrain: Lab['setBrain'] = (brain, value) => {
    this.#grip.branch()
    this.#grip.give({ kind: 'brain', brain, value })
  }

  setTraining: Lab['setTraining'] = (brain, change) => {
    this.#grip.branch()
    this.#grip.give({ kind: 'training', brain, ...change })
  }

  remember: Lab['remember'] = (row) => {
    this.#grip.branch()
    const rows = () => this.#run.brains[row.network]?.examples?.rows.length ?? 0
    const before = rows()
    this.#grip.give({ kind: 'remember', ...row, robot: this.#run.robotAt(row.robot) })
    return rows() > before
  }

  drive: Lab['drive'] = (wheels, others = {}, robot) => {
    const index = this.#run.robotAt(robot)
    this.#hand = wheels && { robot: index, ...wholePercent(wheels), others }
    if (this.#run.inPast) return
    this.drove ||= wheels !== null && !this.#grip.isOn()
    this.#giveHand(index)
  }

  #giveHand(robot: number): void {
    this.#grip.give({ kind: 'drive', ...(this.#hand ?? { robot, left: null, right: null }) })
  }

  record: Lab['record'] = (recording) => {
    this.#recording = recording && { ...recording, robot: this.#run.robotAt(recording.robot) }
    if (!this.#run.inPast) this.#giveRecording()
  }

  #giveRecording(): void {
    const recording = this.#recording
    if (recording !== this.#run.school.state.recording) this.#grip.give({ kind: 'record', recording })
  }

  press: Lab['press'] = (key, down, robot) => {
    this.#keys = [...this.#keys.filter((held) => held !== key), ...(down ? [key] : [])]
    // In the past nobody drives; a key that is let go of there is let go of when it is over.
    if (this.#run.inPast) return
    this.drove ||= down && !this.#grip.isOn()
    this.#grip.give({ kind: 'key', key, down, robot: this.#run.robotAt(robot) })
  }

  pressButton: Lab['pressButton'] = (key, down, robot) => {
    if (down) this.#grip.branch()
    const index = this.#run.robotAt(robot)
    this.#buttons = this.#buttons.filter((held) => held.key !== key || held.robot !== index)
    if (down) this.#buttons = [...this.#buttons, { robot: index, key }]
    if (!this.#run.inPast) this.#grip.give({ kind: 'button', key, down, robot: index })
  }

  /** Brings a run that has come to another moment to what hands hold now. */
  takeHold(): void {
    this.#releaseButtons()
    const { hand } = this.#run.school.state
    if (!isSameHand(this.#hand, hand)) this.#giveHand(hand?.robot ?? 0)
    this.#giveRecording()
    this.#takeKeys()
  }

  /** Keys of a panel that were let go of while the past was shown. */
  #releaseButtons(): void {
    this.#run.simulation.state.robots.forEach(({ keys }, robot) => {
      for (const key of keys)
        if (!this.#buttons.some((held) => held.key === key && held.robot === robot))
          this.#grip.give({ kind: 'button', key, down: false, robot })
    })
  }

  #takeKeys(): void {
    for (const key of new Set([...this.#run.keys, ...this.#keys])) {
      const down = this.#keys.includes(key)
      if (down !== this.#run.keys.includes(key))
        this.#grip.give({ kind: 'key', key, down, robot: this.#run.driven })
    }
  }
}

const wholePercent = ({ left, right }: Wheels): Wheels => ({ left: wholeOf(left), right: wholeOf(right) })

const wholeOf = (percent: number) => Math.max(-100, Math.min(100, Math.round(percent))) + 0

const isSameHand = (a: Hand | null, b: Hand | null) =>
  a?.robot === b?.robot && a?.left === b?.left && a?.right === b?.right && a?.others === b?.others
