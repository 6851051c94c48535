import type * as Blockly from 'blockly/core'
import type { Finding } from '@botgarten/blocks'
import type { Words } from '#words/message.ts'
import { showMarks, type Marks } from './marks.ts'
import { showFindings } from './finding-icon.ts'

/** What is shown at blocks and is no part of the program: what runs, what belongs together, what is wrong, stop points. */
export class Showing {
  readonly #workspace: Blockly.WorkspaceSvg
  /** In the language that the pane speaks now. */
  readonly #words: () => Words
  readonly #open: (finding: Finding) => void
  #findings: readonly Finding[] = []
  #lit: string | null = null
  #highlight: readonly string[] = []
  #marks: Marks | null = null

  constructor(workspace: Blockly.WorkspaceSvg, words: () => Words, open: (finding: Finding) => void) {
    this.#workspace = workspace
    this.#words = words
    this.#open = open
  }

  findings(findings: readonly Finding[]): void {
    this.#findings = findings
    const words = this.#words()
    const label = ({ problem, facts }: Finding) =>
      words('editor.finding', { title: words(`${problem}.title`, facts) })
    showFindings(this.#workspace, findings, label, this.#open)
  }

  /** The block that runs. Touches two class lists and nothing else. */
  lit(id: string | null): void {
    if (this.#lit !== null) this.#classOf(this.#lit, 'editor-lit', false)
    if (id !== null) this.#classOf(id, 'editor-lit', true)
    this.#lit = id
  }

  /** Blocks that light up together with their nodes and with parts of the robot. */
  highlight(ids: readonly string[]): void {
    for (const id of this.#highlight) this.#classOf(id, 'editor-highlight', false)
    for (const id of ids) this.#classOf(id, 'editor-highlight', true)
    this.#highlight = ids
  }

  /** Stop points, and values at their blocks. */
  marks(marks: Marks): void {
    if (!this.#marks && marks.stops.length === 0 && marks.values.size === 0) return
    this.#marks = marks
    showMarks(this.#workspace, marks)
  }

  /** All of it once more, on blocks that were built again. */
  again(): void {
    this.lit(this.#lit)
    this.highlight(this.#highlight)
    this.findings(this.#findings)
    if (this.#marks) this.marks(this.#marks)
  }

  #classOf(id: string, name: string, on: boolean) {
    this.#workspace.getBlockById(id)?.getSvgRoot().classList.toggle(name, on)
  }
}
