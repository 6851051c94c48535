import type * as Blockly from 'blockly/core'
import { definitions, toolbox, type Category } from '@botgarten/blocks'
import type { Words } from '#words/message.ts'
import { loadExpert, loadLearning, expertParts } from '../../model/packs.ts'
import { only, toolboxInfo } from './info.ts'

interface DrawnBlocks {
  /** Gives blocks that have come their words. */
  speak(): void
  /** Builds all blocks again, and fills the toolbox. */
  redraw(): void
}

const typesNow = () => Object.keys(definitions).length

/** Which blocks a workspace offers: the plain ones, with hidden layers or without, or all of them. */
export class Toolbox {
  readonly #workspace: Blockly.WorkspaceSvg
  /** In the language that the pane speaks now. */
  readonly #words: () => Words
  readonly #blocks: DrawnBlocks
  #all = false
  /** Are blocks drawn as the whole language draws them? */
  #knowsAll = expertParts() !== null
  /** So many types of blocks are known to Blockly. */
  #known = typesNow()
  #layers = false
  /** Families that a card offers; null: all of them. */
  #families: readonly Category[] | null = null

  constructor(workspace: Blockly.WorkspaceSvg, words: () => Words, blocks: DrawnBlocks) {
    this.#workspace = workspace
    this.#words = words
    this.#blocks = blocks
  }

  /** Everything, or the plain toolbox. The language is brought first where it is not there yet. */
  async showAll(all: boolean): Promise<void> {
    if (all === this.#all) return
    this.#all = all
    if (all) await this.learn()
    this.fill()
  }

  /** Brings the whole language, for the workspace too. */
  async learn(): Promise<void> {
    if (this.#knowsAll) return
    await loadExpert()
    this.#knowsAll = true
    this.#blocks.redraw()
  }

  /** Blocks may have come with what a classmate has done: from now on they are drawn here. */
  catchUp(): void {
    const known = typesNow()
    if (known === this.#known) return
    this.#known = known
    if (this.#knowsAll || !expertParts()) return this.#blocks.speak()
    this.#knowsAll = true
    this.#blocks.redraw()
  }

  /** Offers hidden layers, or does not. */
  async offerLayers(offered: boolean): Promise<void> {
    if (offered === this.#layers) return
    this.#layers = offered
    if (offered) {
      await loadLearning()
      this.#blocks.speak()
    }
    this.fill()
  }

  /** Offers these families alone. */
  offerFamilies(families: readonly Category[] | null): void {
    if (String(families) === String(this.#families)) return
    this.#families = families
    this.fill()
  }

  fill(): void {
    const words = this.#words()
    const parts = this.#all ? expertParts() : null
    const info = parts
      ? parts.toolboxOf(words, this.#workspace)
      : toolboxInfo(words, toolbox, this.#layers ? '' : undefined)
    this.#workspace.updateToolbox(only(info, this.#families))
  }
}
