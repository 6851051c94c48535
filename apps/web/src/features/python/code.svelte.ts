import type { Finding } from '@botgarten/blocks'
import { tryingIn } from '@botgarten/programs'
import {
  centresIn,
  fileName,
  pythonFrom,
  type Dialect,
  type Learned,
  type PythonFile,
} from '@botgarten/programs/python'
import type { LabSession } from '#lab/session.svelte.ts'
import { readSetting, writeSetting } from '#storage/settings.ts'
import { message } from '#words/message.ts'

const empty = { stacks: [], config: { stacks: [] } }

/** The program of the robot that is shown, as Python: it follows every change. */
export class Code {
  readonly #session: LabSession
  readonly #title: () => string
  #dialect = $state(readSetting<Dialect>('dialect', 'pybricks'))
  #gaps = $state(readSetting('code-gaps', true))
  #learner = $state(readSetting('code-learner', false))
  #learned = $state.raw<Learned>({})

  /** @param title name of the project */
  constructor(session: LabSession, title: () => string) {
    this.#session = session
    this.#title = title
  }

  get dialect(): Dialect {
    return this.#dialect
  }
  set dialect(dialect: Dialect) {
    this.#dialect = dialect
    writeSetting('dialect', dialect)
  }

  /** Does the file raise an error where the program has a gap? Else it has a comment there. */
  get gaps(): boolean {
    return this.#gaps
  }
  set gaps(gaps: boolean) {
    this.#gaps = gaps
    writeSetting('code-gaps', gaps)
  }

  /** Does the robot go on learning by trying, on a floor with stations? */
  get learner(): boolean {
    return this.#learner
  }
  set learner(learner: boolean) {
    this.#learner = learner
    writeSetting('code-learner', learner)
  }

  /** Could it? */
  get canLearn(): boolean {
    const tries = (tryingIn(this.#program)?.minutes ?? 0) > 0
    return tries || (this.#session.learns && this.#learned.lesson !== undefined)
  }

  get #program() {
    return this.#session.lab.document.programs[this.#session.robot.program] ?? empty
  }

  readonly file: PythonFile = $derived.by(() => {
    const { brain, config } = this.#session.robot
    const { brains, tables } = this.#session.lab.document
    return pythonFrom(
      {
        ...{ name: this.#title(), program: this.#program, config, brains, set: brain },
        ...{ dialect: this.dialect, gaps: this.gaps, ...(tables && { tables }) },
        learner: this.learner,
        learned: { ...this.#learned, centres: centresIn(this.#session.project.sorting) },
      },
      message,
    )
  })

  /** What the brick lacks, to be shown at its blocks. */
  readonly missing: readonly Finding[] = $derived(
    this.file.notes
      .filter(({ gap }) => !gap)
      .map(({ block, text }) => ({
        ...{ block, problem: 'python.atBlock', facts: { what: text } },
        ...{ stops: false, mark: 'robot' },
      })),
  )

  /** Has the program gaps? */
  get unfinished(): boolean {
    return this.file.notes.some(({ gap }) => gap)
  }

  /** What was learned by trying goes along. */
  async learn(): Promise<void> {
    const [program, course] = [this.#program, this.#session.project.q?.[this.#session.robot.program]]
    if (!this.#session.learns) return
    const { learnedIn } = await import('./learned.ts')
    this.#learned = await learnedIn(program, course, this.#session.maps)
  }

  get name(): string {
    return fileName(this.#title())
  }

  /** Numbers of the lines that run with a block, from 0. */
  runningLines(block: string | null): readonly number[] {
    return this.linesOf(block).filter((line) => line >= this.file.head)
  }

  /** Numbers of the lines that belong to a block, from 0. */
  linesOf(block: string | null): readonly number[] {
    if (block === null) return []
    return this.file.lines.flatMap((blocks, line) => (blocks.includes(block) ? [line] : []))
  }
}
