import { emptyBrain, type Brain } from '@botgarten/learning/neural-network/brain'
import {
  afterLesson,
  beginLesson,
  freshDrive,
  practiceChoice,
  stepSettings,
  type Drive,
  type Lesson,
} from '@botgarten/learning/neural-network/examples'
import { practiseFor } from '@botgarten/learning/neural-network/train'
import type { Hands } from '../inputs/hands.ts'
import type { Hand, Input, Recording, Remembered, TrainingChange } from '../inputs/input.ts'
import { doneOutputs, heldOutputs, inputsNow, networkOf, readInputs, showHeld } from './columns.ts'
import { exerciseOf } from './exercise.ts'
import { isFull, recorded, withExample, type Recorder } from './recorder.ts'

/** A run in which something is shown. */
export interface Ground extends Recorder, Pick<Hands, 'keys' | 'driven'> {
  readonly seconds: number
  /** Another brain takes a network's place. */
  use(network: string, brain: Brain): void
  /** The same, where its weights are as before. */
  show(network: string, brain: Brain): void
}

/** Rounds that a program has asked for: they are done before the next tick. */
export interface Wanted {
  /** Index of the robot. */
  readonly robot: number
  readonly network: string
  readonly rounds: number
}

/** What of showing and practising decides how a run goes on, as plain data. */
export interface SchoolState {
  /** On the pad. */
  readonly hand: Hand | null
  readonly recording: Recording | null
  readonly wanted: readonly Wanted[]
  /** By network: the drive into which this run's program writes. */
  readonly drives: { readonly [network: string]: Drive }
}

const nothing: SchoolState = { hand: null, recording: null, wanted: [], drives: {} }

type SchoolInput = Extract<Input, { kind: 'drive' | 'record' | 'remember' | 'training' }>

/** Hands on the pad, rows that are written, and practice that a program asks for (running.md 14 to 19). */
export class School {
  readonly #ground: Ground
  state: SchoolState = nothing
  /** Practice under way; begun again where it is lost, it does the same. */
  #lesson: Lesson | null = null

  constructor(ground: Ground) {
    this.#ground = ground
  }

  restore(state: SchoolState): void {
    this.state = state
    this.#lesson = null
  }

  take(input: SchoolInput): void {
    if (input.kind === 'drive') this.#set({ hand: input.left === null ? null : handOf(input) })
    else if (input.kind === 'record') this.#set({ recording: input.recording })
    else if (input.kind === 'remember') this.#rememberHeld(input)
    else this.#train(input.brain, input)
  }

  #set(state: Partial<SchoolState>): void {
    this.state = { ...this.state, ...state }
  }

  get hands(): Hands {
    const { keys, driven } = this.#ground
    return { keys, driven, hand: this.state.hand }
  }

  /** After the programs and before the motors: what a hand holds is shown and written down (running.md 14, 16). */
  takeHands(): void {
    this.showHeld()
    const { recording } = this.state
    const brain = recording && recorded(this.#ground, recording, this.hands)
    if (brain) this.#ground.show(recording.network, brain)
  }

  showHeld(): void {
    const { hand } = this.state
    const robot = hand && this.#ground.robots[hand.robot]
    if (!robot || Object.keys(hand.others).length === 0) return
    for (const id of robot.networks) {
      const outline = networkOf(robot, id)
      if (outline) showHeld(robot, outline, hand.others)
    }
  }

  #train(id: string, { examples, practice }: TrainingChange): void {
    const { examples: shown, practice: note, ...rest } = this.#ground.brains[id] ?? emptyBrain
    const [table, next] = [
      examples === undefined ? shown : examples,
      practice === undefined ? note : practice,
    ]
    this.#ground.show(id, { ...rest, ...(table && { examples: table }), ...(next && { practice: next }) })
  }

  #rememberHeld({ robot: index, network, drive, wheels, others }: Remembered): void {
    const { robots, simulation, seconds } = this.#ground
    const robot = robots[index]
    const outline = robot && networkOf(robot, network)
    if (!outline) return
    robot.context.now = seconds
    const { config } = simulation.world.robots[index]!
    const outputs = heldOutputs(robot, outline, config.drive, wheels, others)
    const brain = withExample(
      this.#ground,
      { robot: index, network, drive },
      inputsNow(robot, outline),
      outputs,
    )
    if (brain) this.#ground.show(network, brain)
  }

  /** A program remembers what its network reads and what it does. Returns whether there is room. */
  rememberDone(index: number, network: string): boolean {
    const { robots, simulation, brains } = this.#ground
    const robot = robots[index]
    const outline = robot && networkOf(robot, network)
    if (!outline) return false
    const drive = this.#driveOf(network)
    if (isFull(brains, network, drive.id)) return false
    const into = { robot: index, network, drive }
    const outputs = doneOutputs(robot, outline, simulation.state.robots[index]!)
    const brain = withExample(this.#ground, into, readInputs(robot, outline), outputs)
    if (brain) this.#ground.show(network, brain)
    return true
  }

  #driveOf(network: string): Drive {
    const known = this.state.drives[network]
    if (known) return known
    const { examples } = this.#ground.brains[network] ?? emptyBrain
    const id = examples ? freshDrive(examples, 'program') : 'program-1'
    const drive: Drive = { id, by: 'program', seed: 0 }
    this.#set({ drives: { ...this.state.drives, [network]: drive } })
    return drive
  }

  want(wanted: Wanted): void {
    this.#set({ wanted: [...this.state.wanted, wanted] })
  }

  /**
   * Practises what programs have asked for, about so many examples of it. The weights are there before anything else of the next
   * tick. Returns whether all is done.
   */
  practise(examples: number): boolean {
    for (let next = this.state.wanted[0]; next; next = this.state.wanted[0]) {
      this.#lesson ??= this.#begin(next)
      if (this.#lesson && !practiseFor(this.#lesson.practice, this.#lesson.curve, examples)) return false
      this.#finish(next)
    }
    return true
  }

  #begin({ robot, network, rounds }: Wanted): Lesson | null {
    const { brains } = this.#ground
    const brain = brains[network]
    const exercise = brain && exerciseOf(this.#ground, robot, network)
    return exercise ? beginLesson(exercise, { ...stepSettings(practiceChoice(brain)), rounds }) : null
  }

  #finish({ robot, network }: Wanted): void {
    const brain = this.#ground.brains[network]
    const set = this.#ground.simulation.world.robots[robot]?.brain ?? ''
    if (this.#lesson && brain) this.#ground.use(network, afterLesson(brain, this.#lesson, set))
    this.#lesson = null
    this.#set({ wanted: this.state.wanted.slice(1) })
  }
}

const handOf = ({ robot, left, right, others }: Hand): Hand => ({ robot, left, right, others })
