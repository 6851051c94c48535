import * as Blockly from 'blockly/core'
import type { Finding, Template } from '@botgarten/blocks'
import type { Program } from '@botgarten/programs'
import type { RobotConfig } from '@botgarten/simulation'
import { setClosed } from './closed-roads.ts'
import { listen, type Reports } from './events.ts'
import { showFindings } from './finding-icon.ts'
import type { Marks } from './debug/marks.ts'
import { keepEscape } from './escape.ts'
import { grouped } from './list.ts'
import { letPaste } from './menus.ts'
import { nameParts } from './name-parts.ts'
import { addNeuron } from './network.ts'
import { restore, statesOn, toProgram, toWorkspace } from './program.ts'
import { bringExpert, expertParts } from './packs.ts'
import { fontReady, options, scaleOf, spaceLetters, type Looks } from './looks.ts'
import { setUp, speak } from './setup.ts'
import { knowRobot } from './sockets.ts'
import { themeFor } from './theme.ts'
import { toolboxInfo } from './toolbox.ts'
import type { Locale } from '#lib/words/language.svelte.ts'
import { wordsIn } from '#lib/words/say.ts'

/** What the pane tells the page. */
export interface PaneReports extends Reports {
  finding(finding: Finding): void
}

/** One Blockly workspace in a pane, with the verbs that the page needs. */
export class Pane {
  readonly #workspace: Blockly.WorkspaceSvg
  readonly #reports: PaneReports
  readonly #stops: (() => void)[]
  readonly #host: HTMLElement
  /** A pane that is not shown has no size: the view finds its place when it is. */
  #placed: boolean
  #locale: Locale
  /** Is the shelf with everything shown? */
  #all = false
  /** Are its blocks drawn as the whole language draws them? */
  #knowsAll = expertParts() !== null
  #looks: Looks
  #program: Program
  #findings: readonly Finding[] = []
  #lit: string | null = null
  #glow: readonly string[] = []
  #marks: Marks | null = null

  constructor(
    host: HTMLElement,
    locale: Locale,
    program: Program,
    media: string,
    looks: Looks,
    reports: PaneReports,
  ) {
    setUp()
    speak(locale)
    this.#locale = locale
    this.#program = program
    this.#reports = reports
    this.#looks = looks
    this.#workspace = Blockly.inject(host, options(locale, media, looks))
    spaceLetters(looks.letters)
    this.#workspace.MAX_UNDO = Infinity
    this.#host = host
    this.#placed = host.clientWidth > 0
    toWorkspace(program, this.#workspace)
    // Blockly measures words on a canvas at the end of the body; it shows nothing.
    document.querySelector('.blocklyComputeCanvas')?.setAttribute('aria-hidden', 'true')
    nameParts(this.#workspace, wordsIn(this.#locale))
    letPaste(this.#workspace, () => this.#learn())
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
    this.#workspace.setScale(scaleOf(this.#looks))
    this.#place()
  }

  /** The paper with the blocks, for what comes late. */
  get paper(): Blockly.WorkspaceSvg {
    return this.#workspace
  }

  /** The shelf with everything, or the plain one. The language is brought first where it is not there yet. */
  async showAll(all: boolean): Promise<void> {
    if (all === this.#all) return
    this.#all = all
    if (all) await this.#learn()
    this.#fillShelf()
  }

  /** The whole language, on this paper too. */
  async #learn(): Promise<void> {
    if (this.#knowsAll) return
    await bringExpert()
    this.#knowsAll = true
    this.#redraw()
  }

  #fillShelf() {
    const words = wordsIn(this.#locale)
    const parts = this.#all ? expertParts() : null
    this.#workspace.updateToolbox(parts ? parts.expertShelf(words, this.#workspace) : toolboxInfo(words))
  }

  /** Every block anew, as it looks now. */
  #redraw() {
    const states = statesOn(this.#workspace)
    speak(this.#locale)
    this.#fillShelf()
    this.#refill(() => restore(states, this.#workspace))
  }

  setLocale(locale: Locale): void {
    if (locale === this.#locale) return
    this.#locale = locale
    this.#redraw()
  }

  /** Draws the blocks anew where their font or their size is another. */
  async setLooks(looks: Looks): Promise<void> {
    const { letters, large } = this.#looks
    this.#looks = looks
    if (looks.large !== large) {
      this.#workspace.setScale(scaleOf(looks))
      // Its shelf is wider then.
      this.#workspace.getToolbox()?.position()
      this.resize()
    }
    if (looks.letters === letters) return
    await fontReady(looks.letters)
    if (this.#looks !== looks) return
    spaceLetters(looks.letters)
    const states = statesOn(this.#workspace)
    this.#workspace.setTheme(themeFor(looks.letters))
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

  /** Lets blocks light up together with their nodes and with parts of the robot. */
  setGlow(ids: readonly string[]): void {
    for (const id of this.#glow) this.#classOf(id, 'editor-glow', false)
    for (const id of ids) this.#classOf(id, 'editor-glow', true)
    this.#glow = ids
  }

  /** Stop points, and values at their blocks. What draws them comes when there are any. */
  setMarks(marks: Marks): void {
    if (!this.#marks && marks.stops.length === 0 && marks.values.size === 0) return
    this.#marks = marks
    void import('./debug/later.ts').then(({ showMarks }) => showMarks(this.#workspace, marks))
  }

  /** The type of the block that an element of the pane belongs to, on the paper or on the open shelf. */
  typeAt(element: Element): string | null {
    const id = element.closest('.blocklyDraggable')?.getAttribute('data-id') ?? ''
    const shelf = this.#workspace.getFlyout()?.getWorkspace()
    const block = this.#workspace.getBlockById(id) ?? shelf?.getBlockById(id)
    return block?.type ?? null
  }

  typeOf(id: string): string | null {
    return this.#workspace.getBlockById(id)?.type ?? null
  }

  /** Takes back one step of the blocks; false where there is none, or a hand holds a block. */
  undo(): boolean {
    return this.#goBack(false, this.#workspace.getUndoStack().length)
  }

  redo(): boolean {
    return this.#goBack(true, this.#workspace.getRedoStack().length)
  }

  zoomBy(direction: 1 | -1): void {
    this.#workspace.zoomCenter(direction)
  }

  resize(): void {
    Blockly.svgResize(this.#workspace)
    if (!this.#placed) this.#place()
  }

  /**
   * Adds a neuron to a network's layer; without a template one more of what is there, at the next free port. The id of
   * its block, null where the layer is full or there is no such network.
   */
  addNeuron(networkId: string, layer: 'input' | 'output', template?: Template): string | null {
    return addNeuron(this.#workspace, networkId, layer, template)
  }

  /** Makes these the closed roads of a map block. */
  setClosed(map: string, roads: readonly (readonly [number, number])[]): void {
    setClosed(this.#workspace, map, roads)
  }

  deleteSelected(): void {
    const selected = Blockly.common.getSelected()
    if (selected instanceof Blockly.BlockSvg && selected.isDeletable()) selected.checkAndDelete()
  }

  /** Brings a block into sight. */
  reveal(id: string): void {
    this.resize()
    const block = this.#workspace.getBlockById(id)
    if (block) this.#workspace.scrollBoundsIntoView(block.getBoundingRectangle())
  }

  #focus(id: string) {
    const block = this.#workspace.getBlockById(id)
    if (block) Blockly.getFocusManager().focusNode(block)
  }

  /** What is plugged into the robot: new neurons take ports that fit. */
  setRobot(config: RobotConfig): void {
    knowRobot(this.#workspace, config)
  }

  /** Several fields of a block, as one step. */
  setFields(blockId: string, fields: { readonly [name: string]: string }): void {
    const block = this.#workspace.getBlockById(blockId)
    grouped(() => Object.entries(fields).forEach(([name, value]) => block?.setFieldValue(value, name)))
  }

  /** The paper's upper left corner beside the shelf. */
  #place() {
    this.#workspace.scroll(0, 0)
    this.#placed = this.#host.clientWidth > 0
  }

  #goBack(redo: boolean, steps: number): boolean {
    if (steps === 0 || this.#workspace.isDragging()) return false
    this.#workspace.hideChaff()
    this.#workspace.undo(redo)
    return true
  }

  #emit() {
    const program = toProgram(this.#workspace, this.#program)
    this.#program = program
    this.#reports.change(program)
  }

  /** Builds all blocks anew under their ids: what is chosen, lit or marked is so again. */
  #refill(fill: () => void) {
    const selected = Blockly.common.getSelected()?.id
    this.#workspace.hideChaff()
    Blockly.Events.disable()
    try {
      this.#workspace.clear()
      fill()
    } finally {
      Blockly.Events.enable()
    }
    nameParts(this.#workspace, wordsIn(this.#locale))
    this.setLit(this.#lit)
    this.setGlow(this.#glow)
    this.setFindings(this.#findings)
    if (this.#marks) this.setMarks(this.#marks)
    if (selected !== undefined) this.#focus(selected)
  }

  #mark(id: string | null, lit: boolean) {
    if (id !== null) this.#classOf(id, 'editor-lit', lit)
  }

  #classOf(id: string, name: string, on: boolean) {
    this.#workspace.getBlockById(id)?.getSvgRoot().classList.toggle(name, on)
  }
}
