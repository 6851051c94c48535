import * as Blockly from 'blockly/core'
import type { Template } from '@botgarten/blocks'
import type { Program } from '@botgarten/programs'
import type { CardNetwork } from '@botgarten/content'
import type { Colour, RobotConfig } from '@botgarten/simulation'
import { setClosed } from '../model/closed-roads.ts'
import { inject } from './audio.ts'
import { keepEscape, listen, type Reports } from './events.ts'
import { show, type Fill } from './large/fill.ts'
import * as layers from './layers.ts'
import { letAsk, letPaste } from './menus.ts'
import { addNeuron } from '../model/network.ts'
import type { NetworkDrop } from '#lab/blocks.ts'
import { takeNetworks } from './network-drop.ts'
import * as on from './on-workspace.ts'
import { forgetParted, part, tidy } from '../model/positions.ts'
import { restore, statesOn, toProgram } from '../model/program.ts'
import { putIn, putNetworkIn, switchOn } from '../model/put-in.ts'
import { fontReady, options, rescale, scaleOf, spaceLetters, type Looks } from './looks.ts'
import { nameParts, setUp, speak } from './setup.ts'
import { explain } from './toolbox/explain.ts'
import { Toolbox } from './toolbox/toolbox.ts'
import { Showing } from './showing.ts'
import { knowRobot } from '../model/fresh.ts'
import { themeFor } from './theme.ts'
import type { Locale } from '#words/language.svelte.ts'
import { wordsIn } from '#words/message.ts'

/** One Blockly workspace in a pane, with the verbs that the page needs. */
export class Pane {
  readonly #workspace: Blockly.WorkspaceSvg
  readonly #reports: Reports
  readonly #stops: (() => void)[]
  readonly #host: HTMLElement
  /** A pane that is not shown has no size: the view finds its place when it is. */
  #placed: boolean
  #locale: Locale
  #looks: Looks
  #program: Program
  readonly toolbox: Toolbox
  /** What is shown at blocks. */
  readonly showing: Showing
  #fill: Fill | undefined

  constructor(
    host: HTMLElement,
    locale: Locale,
    program: Program,
    media: string,
    looks: Looks,
    reports: Reports,
  ) {
    setUp()
    speak(locale)
    this.#locale = locale
    this.#program = program
    this.#reports = reports
    this.#looks = looks
    this.#workspace = inject(host, options(locale, media, looks))
    this.toolbox = new Toolbox(this.#workspace, () => wordsIn(this.#locale), {
      speak: () => speak(this.#locale),
      redraw: () => this.#redraw(),
    })
    this.showing = new Showing(
      this.#workspace,
      () => wordsIn(this.#locale),
      (finding) => reports.finding(finding),
    )
    spaceLetters(looks.letters)
    this.#workspace.MAX_UNDO = Infinity
    this.#host = host
    this.#placed = host.clientWidth > 0
    this.#show(program)
    if (program.raw) part(this.#workspace)
    if (this.#placed) this.#place()
    nameParts(this.#workspace, wordsIn(this.#locale))
    letPaste(this.#workspace, () => this.toolbox.learn())
    letAsk(this.#workspace, (type) => void explain(this.#workspace, type))
    this.#stops = [listen(this.#workspace, reports, () => this.#emit()), keepEscape(host, this.#workspace)]
  }

  dispose(): void {
    for (const stop of this.#stops) stop()
    this.#fill?.stop()
    this.#workspace.dispose()
  }

  /** Shows another program. The one that this pane gave out itself is on the screen already. */
  load(program: Program, shared = false): void {
    const shown = program === this.#program || JSON.stringify(program) === JSON.stringify(this.#program)
    this.#program = program
    if (shown) return
    if (shared) return this.#follow(program)
    this.#refill(() => this.#show(program))
    this.#workspace.clearUndo()
    this.#workspace.setScale(scaleOf(this.#looks))
    this.#place()
  }

  /** Another child has done something: a child that looks on, or types elsewhere, is not disturbed. */
  #follow(program: Program): void {
    this.toolbox.catchUp()
    const focused = this.#host.contains(document.activeElement)
    on.stays(this.#workspace, () => this.#refill(() => this.#show(program), focused))
  }

  /** What was done to the blocks is told now; false while a hand holds one, or a field is open. */
  settle(): boolean {
    if (on.isInHand(this.#workspace)) return false
    const now = JSON.stringify(toProgram(this.#workspace, this.#program).stacks)
    if (now !== JSON.stringify(this.#program.stacks)) this.#emit()
    return true
  }

  /** With all its blocks: a large program is built in slices. */
  get #whole(): Blockly.WorkspaceSvg {
    this.#fill?.finish()
    return this.#workspace
  }

  /** The workspace with the blocks, for what comes late. */
  get workspace(): Blockly.WorkspaceSvg {
    return this.#workspace
  }

  #redraw() {
    this.#rebuild(() => {
      speak(this.#locale)
      this.toolbox.fill()
    })
  }

  /** Builds every block again, as it looks after a change of looks or words. */
  #rebuild(change: () => void) {
    const states = statesOn(this.#whole)
    change()
    this.#refill(() => restore(states, this.#workspace))
  }

  setLocale(locale: Locale): void {
    if (locale === this.#locale) return
    this.#locale = locale
    this.#redraw()
  }

  /** Draws the blocks again where their font or their size is another. */
  async setLooks(looks: Looks): Promise<void> {
    const { letters, large } = this.#looks
    this.#looks = looks
    if (looks.large !== large) {
      rescale(this.#workspace, looks)
      this.resize()
    }
    if (looks.letters === letters) return
    await fontReady(looks.letters)
    if (this.#looks !== looks) return
    this.#rebuild(() => {
      spaceLetters(looks.letters)
      this.#workspace.setTheme(themeFor(looks.letters))
    })
  }

  /** The type of the block that an element of the pane belongs to, on the workspace or on the open toolbox. */
  typeAt(element: Element): string | null {
    return on.typeAt(this.#workspace, element)
  }

  typeOf(id: string): string | null {
    return this.#workspace.getBlockById(id)?.type ?? null
  }

  /** Takes back one step of the blocks; false where there is none, or a hand holds a block. */
  undo(): boolean {
    return on.step(this.#whole, false)
  }

  redo(): boolean {
    return on.step(this.#whole, true)
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
    return addNeuron(this.#whole, networkId, layer, template)
  }

  addLayer(network: string, neurons: number): void {
    layers.addLayer(this.#workspace, network, neurons)
  }
  setNeurons(layer: string, neurons: number): void {
    layers.setNeurons(this.#workspace, layer, neurons)
  }
  setLayerActivation(layer: string, activation: layers.LayerActivation): void {
    layers.setLayerActivation(this.#workspace, layer, activation)
  }

  /** Puts a block among those that run: a network into the loop. */
  putIn(id: string): void {
    putIn(this.#whole, this.#program, id)
    this.#seen(id)
  }

  /** Puts in the network of the card, or the one of the toolbox. */
  putNetworkIn(wanted?: CardNetwork): void {
    this.#seen(putNetworkIn(this.#whole, this.#program, wanted))
  }

  switchOn(id: string): void {
    switchOn(this.#whole, id)
  }

  /** Networks that are dropped there go into the loop. Returns how to measure the place again. */
  takeNetworks(drop: NetworkDrop): () => void {
    return takeNetworks(this.#workspace, drop, (network) => this.putIn(network))
  }

  #seen(id: string): void {
    void Blockly.renderManagement.finishQueuedRenders().then(() => on.reveal(this.#workspace, id))
  }

  /** Makes these the closed roads of a map block. */
  setClosed(map: string, roads: readonly (readonly [number, number])[]): void {
    setClosed(this.#whole, map, roads)
  }

  deleteSelected(): void {
    this.#fill?.finish()
    on.deleteSelected()
  }

  /** Brings a block into sight; with `focus` the keyboard goes there as well. */
  reveal(id: string, focus = false): void {
    this.#fill?.finish()
    this.resize()
    on.reveal(this.#workspace, id, focus)
  }

  /** Puts all stacks below each other, as one step, and the first of them into sight. */
  tidy(): void {
    tidy(this.#whole)
    this.#place()
  }

  /** Tells the robot's plugged-in parts and the colours of its floor: new neurons take ports and colours that fit. */
  setRobot(config: RobotConfig, onFloor?: () => readonly Colour[]): void {
    knowRobot(this.#workspace, config, onFloor)
  }

  /** Several fields of a block, as one step. */
  setFields(blockId: string, fields: { readonly [name: string]: string }): void {
    on.setFields(this.#whole, blockId, fields)
  }

  #place() {
    on.place(this.#workspace)
    this.#placed = this.#host.clientWidth > 0
  }

  #emit() {
    const program = toProgram(this.#workspace, this.#program)
    this.#program = program
    this.#reports.change(program)
  }

  /** Builds all blocks again under their ids: what is chosen, lit or marked is so again. */
  #refill(fill: () => void, focus = true) {
    this.#fill?.drop()
    const build = () => {
      this.#workspace.clear()
      fill()
    }
    on.unseen(this.#workspace, build, () => this.#filled(), focus)
  }

  #show(program: Program) {
    forgetParted(this.#workspace)
    this.#fill = show(program, this.#workspace, this.#fill, () => this.#filled())
  }

  /** Blocks were built: stacks of a foreign file may lie on each other, since they are higher here. */
  #filled() {
    if (this.#program.raw) part(this.#workspace)
    this.#markAll()
  }

  #markAll() {
    nameParts(this.#workspace, wordsIn(this.#locale))
    this.showing.again()
  }
}
