import type { Phase } from '#drawing/nudge.ts'
import type { Pose } from '@botgarten/simulation'
import type { LabUi } from '#lab/ui.svelte.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { Viewport } from '#figures/world/viewport.svelte.ts'
import { asksForColours, goalsOf } from './goals.ts'
import { Hand } from './hand.svelte.ts'
import type { Workshop } from './workshop.ts'

/** The world's pane: where it looks, what is in the hand, and whether a child builds. */
export class BuildMode {
  readonly session: LabSession
  readonly ui: LabUi
  readonly viewport: Viewport
  readonly hand: Hand
  readonly #loadTools: LoadTools
  #shop = $state.raw<Opened | null>(null)
  #on = $state(false)

  constructor(session: LabSession, ui: LabUi, loadTools: LoadTools) {
    this.session = session
    this.ui = ui
    this.#loadTools = loadTools
    const checks = session.opened.card?.card.checks ?? []
    const goals = goalsOf(checks)
    this.viewport = new Viewport(
      () => this.shop?.world ?? session.lab.document.world,
      () => session.robotId,
      () => session.learns,
      () => goals,
      () => session.tries,
      asksForColours(checks),
    )
    this.hand = new Hand((id, pose, phase) => this.place(id, pose, phase))
  }

  get on(): boolean {
    return this.#on
  }

  /** Set while a child builds. */
  get shop(): Workshop | null {
    return this.#on ? this.#shop : null
  }

  /** Who builds moves what is drawn; else a robot or a thing is put somewhere. */
  place(id: string, pose: Pose, phase: Phase): void {
    if (this.shop) this.shop.place(id, pose, phase)
    else this.session.apply({ kind: 'place', id, after: pose }, phase)
  }

  async toggle(): Promise<void> {
    this.#on = !this.#on
    this.hand.selected = null
    if (!this.#on) return
    // Bo would drive out of sight, and the camera stands still.
    this.session.lab.pause()
    await this.#open()
  }

  /** A picture for the floor or a scene, dropped onto the world. */
  async take(file: File): Promise<void> {
    const shop = await this.#open()
    await shop.take(file)
  }

  async #open(): Promise<Opened> {
    if (this.#shop) return this.#shop
    const open = await this.#loadTools(() => (this.#on = false))
    this.#shop ??= await open(this)
    return this.#shop
  }
}

type Opened = Workshop & { take(file: File): Promise<void> }

/** Loads the tools for building; `failed` is called where they cannot come. */
type LoadTools = (failed: () => void) => Promise<(mode: BuildMode) => Promise<Opened>>
