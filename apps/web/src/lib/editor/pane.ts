import * as Blockly from 'blockly/core'
import type { Finding, Template } from '@botgarten/blocks'
import type { Program } from '@botgarten/programs'
import { listen, type Reports } from './events.ts'
import { showFindings } from './finding-icon.ts'
import { keepEscape } from './escape.ts'
import { grouped } from './list.ts'
import { addNeuron } from './network.ts'
import { restore, statesOn, toProgram, toWorkspace } from './program.ts'
import { rendererName } from './renderer.ts'
import { setUp, speak } from './setup.ts'
import { font, theme } from './theme.ts'
import { shelfPlugins, toolboxInfo } from './toolbox.ts'
import { wordsIn, type Locale } from './words.ts'

const startScale = 0.76

/** What the pane tells the page. */
export interface PaneReports extends Reports {
  finding(finding: Finding): void
}

/** Resolves when blocks can be measured: Blockly asks once how wide its words are. */
export async function fontReady(): Promise<void> {
  await document.fonts.load(`700 16px ${font}`)
}

function options(locale: Locale, media: string): Blockly.BlocklyOptions {
  return {
    toolbox: toolboxInfo(wordsIn(locale)),
    renderer: rendererName,
    theme,
    media,
    plugins: shelfPlugins,
    sounds: false,
    trashcan: false,
    comments: false,
    collapse: false,
    disable: false,
    grid: { spacing: 29, length: 3, colour: '#E6D6BA', snap: false },
    move: { scrollbars: true, drag: true, wheel: true },
    zoom: {
      controls: false,
      wheel: false,
      pinch: true,
      startScale,
      minScale: 0.4,
      maxScale: 2,
      scaleSpeed: 1.2,
    },
  }
}

/** One Blockly workspace in a pane, with the verbs that the page needs. */
export class Pane {
  readonly #workspace: Blockly.WorkspaceSvg
  readonly #reports: PaneReports
  readonly #stops: (() => void)[]
  /** Where the view stands at first: the paper's upper left corner beside the shelf. */
  readonly #origin: { readonly x: number; readonly y: number }
  #locale: Locale
  #program: Program
  #findings: readonly Finding[] = []
  #lit: string | null = null

  constructor(host: HTMLElement, locale: Locale, program: Program, media: string, reports: PaneReports) {
    setUp()
    speak(locale)
    this.#locale = locale
    this.#program = program
    this.#reports = reports
    this.#workspace = Blockly.inject(host, options(locale, media))
    this.#workspace.MAX_UNDO = Infinity
    this.#origin = { x: this.#workspace.scrollX, y: this.#workspace.scrollY }
    toWorkspace(program, this.#workspace)
    this.#stops = [listen(this.#workspace, reports, () => this.#emit()), keepEscape(host, this.#workspace)]
  }

  dispose(): void {
    for (const stop of this.#stops) stop()
    this.#workspace.dispose()
  }

  /** Shows another program. The one that this pane gave out itself is on the screen already. */
  load(program: Program): void {
    const shown = program === this.#program || JSON.stringify(program) === JSON.stringify(this.#program)
    this.#program = program
    if (shown) return
    this.#refill(() => toWorkspace(program, this.#workspace))
    this.#workspace.clearUndo()
    this.#workspace.setScale(startScale)
    this.#workspace.scroll(this.#origin.x, this.#origin.y)
  }

  setLocale(locale: Locale): void {
    if (locale === this.#locale) return
    this.#locale = locale
    const states = statesOn(this.#workspace)
    speak(locale)
    this.#workspace.updateToolbox(toolboxInfo(wordsIn(locale)))
    this.#refill(() => restore(states, this.#workspace))
  }

  setFindings(findings: readonly Finding[]): void {
    this.#findings = findings
    const words = wordsIn(this.#locale)
    const label = ({ problem, facts }: Finding) =>
      words('editor.finding', { title: words(`${problem}.title`, facts) })
    showFindings(this.#workspace, findings, label, (finding) => this.#reports.finding(finding))
  }

  /** Lets the block that runs glow. Touches two class lists and nothing else. */
  setLit(id: string | null): void {
    this.#mark(this.#lit, false)
    this.#mark(id, true)
    this.#lit = id
  }

  undo(): void {
    this.#workspace.undo(false)
  }

  redo(): void {
    this.#workspace.undo(true)
  }

  zoomBy(direction: 1 | -1): void {
    this.#workspace.zoomCenter(direction)
  }

  resize(): void {
    Blockly.svgResize(this.#workspace)
  }

  /**
   * Adds a neuron to a network's layer; without a template one more of what is there, at the next free port. The id of
   * its block, null where the layer is full or there is no such network.
   */
  addNeuron(networkId: string, layer: 'input' | 'output', template?: Template): string | null {
    return addNeuron(this.#workspace, networkId, layer, template)
  }

  deleteSelected(): void {
    const selected = Blockly.common.getSelected()
    if (selected instanceof Blockly.BlockSvg && selected.isDeletable()) selected.checkAndDelete()
  }

  focusBlock(id: string): void {
    const block = this.#workspace.getBlockById(id)
    if (block) Blockly.getFocusManager().focusNode(block)
  }

  setField(blockId: string, field: string, value: string): void {
    grouped(() => this.#workspace.getBlockById(blockId)?.setFieldValue(value, field))
  }

  #emit() {
    const program = toProgram(this.#workspace, this.#program)
    this.#program = program
    this.#reports.change(program)
  }

  /** Builds all blocks anew under their ids: what is chosen, lit or marked is so again. */
  #refill(fill: () => void) {
    const selected = Blockly.common.getSelected()?.id
    Blockly.Events.disable()
    try {
      this.#workspace.clear()
      fill()
    } finally {
      Blockly.Events.enable()
    }
    this.setLit(this.#lit)
    this.setFindings(this.#findings)
    if (selected !== undefined) this.focusBlock(selected)
  }

  #mark(id: string | null, lit: boolean) {
    if (id !== null) this.#workspace.getBlockById(id)?.getSvgRoot().classList.toggle('editor-lit', lit)
  }
}
