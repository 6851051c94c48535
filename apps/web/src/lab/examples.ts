import type { Hand, Wheels } from '@botgarten/lab'
import {
  emptyBrain,
  withWeights,
  type Brain,
  type PracticeNote,
  type Weights,
} from '@botgarten/learning/neural-network/brain'
import {
  freshDrive,
  practiceChoice,
  withChoice,
  type Drive,
  type Examples,
  type PracticeChoice,
} from '@botgarten/learning/neural-network/examples'
import type { Part } from './change.ts'
import type { LabSession } from './session.svelte.ts'

/** Rows a second while a hand drives, where nobody has chosen another rate. */
const usualRate = 10
const ticksPerSecond = 60

/** Every run of the page has it. */
const runSeed = 1

/** What the networks of the chosen robot are shown, and how they practise, in a child's hands. */
export class HandOnExamples {
  readonly #session: Pick<LabSession, 'apply' | 'goOn' | 'lab' | 'noteExamples' | 'robot'>
  /** The table before the rows that are being written. */
  #before: { readonly network: string; readonly examples: Brain['examples'] } | null = null

  constructor(session: Pick<LabSession, 'apply' | 'goOn' | 'lab' | 'noteExamples' | 'robot'>) {
    this.#session = session
  }

  #brain = (id: string): Brain => this.#session.lab.document.brains[id] ?? emptyBrain

  /** Those of the moment that is shown. */
  shown(network: string): Examples | undefined {
    return this.#session.lab.facts.brains[network]?.examples
  }

  /** Those of the present, whatever moment is shown. */
  now(network: string): Examples | undefined {
    return this.#brain(network).examples
  }

  #drive(network: string, by: Drive['by']): Drive {
    const { examples } = this.#brain(network)
    const id = examples ? freshDrive(examples, by) : `${by}-1`
    const { phase } = this.#session.lab.facts
    return { id, by, seed: phase === 'running' || phase === 'paused' ? runSeed : 0 }
  }

  /** One row, which is a drive of its own: what the network reads where Bo stands, and these wheels. @returns was there room? */
  remember(network: string, wheels: Wheels, others: Hand['others'] = {}): boolean {
    const { lab, robot } = this.#session
    this.#session.goOn()
    const before = this.now(network)
    const drive = this.#drive(network, 'hand')
    const written = lab.remember({ robot: robot.id, network, drive, wheels, others })
    this.#session.noteExamples(network, before)
    return written
  }

  /** Writes rows from here on, while a hand drives, or by 'program' what the program does. The run has to be on for that. */
  record(network: string, by: Drive['by'], rate = usualRate): void {
    this.stop()
    this.#before = { network, examples: this.now(network) }
    const every = Math.min(60, Math.max(1, Math.round(ticksPerSecond / rate)))
    const drive = this.#drive(network, by)
    this.#session.lab.record({ robot: this.#session.robot.id, network, drive, every })
  }

  /** Writes no more rows; the drive is one step to take back. */
  stop(): void {
    if (!this.#before) return
    const { network, examples } = this.#before
    this.#before = null
    this.#session.lab.record(null)
    this.#session.noteExamples(network, examples)
  }

  /** Another table, as one step; the same one changes nothing. */
  change(network: string, change: (examples: Examples) => Examples | undefined, part: Part = 'whole'): void {
    this.#session.goOn()
    const before = this.now(network)
    const after = before && change(before)
    if (after !== before) this.#session.apply({ kind: 'examples', network, after }, part)
  }

  /** A table from elsewhere in the place of this one. */
  replace(network: string, after: Examples | undefined): void {
    this.#session.apply({ kind: 'examples', network, after })
  }

  /** How the network practises next. */
  choice(network: string): PracticeChoice {
    return practiceChoice(this.#brain(network))
  }

  choose(network: string, choice: PracticeChoice, part: Part = 'whole'): void {
    const after = withChoice(this.#brain(network).practice, choice)
    this.#session.apply({ kind: 'practice', network, after }, part)
  }

  /** It has practised: the weights that are on show, and how they came about, as one input of the run (running.md 19). */
  practised(network: string, weights: Weights, practice: PracticeNote): void {
    this.#session.goOn()
    const after = { ...withWeights(this.#brain(network), weights, this.#session.robot.brain), practice }
    this.#session.apply({ kind: 'brain', id: network, after })
  }
}
