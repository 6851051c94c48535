import { tick } from 'svelte'
import type { PaneName } from '#lab/panes.ts'
import { focusOn } from '#parts/page/focus.ts'
import { arrangementOf, isLow, nextPane, scrollsAsPage } from './arrangement.ts'
import type { LabScreenState } from './screen.svelte.ts'

/** How the lab lies in the window: which panes are seen, and where their bars are. */
export class Layout {
  readonly #screen: LabScreenState
  width = $state(1366)
  height = $state(768)
  /** The world fills the lab by itself, because it is being built. */
  #made = false

  constructor(screen: LabScreenState) {
    this.#screen = screen
  }

  get #ui() {
    return this.#screen.ui
  }

  readonly arrangement = $derived.by(() => arrangementOf({ width: this.width, height: this.height }))
  /** One pane at a time, as on a phone. */
  readonly pages = $derived(this.arrangement === 'pages')
  /** A map would have no room in a low window: then the page scrolls, too. */
  readonly scrolls = $derived.by(() => {
    const window = { width: this.width, height: this.height }
    return scrollsAsPage(window) || (this.pages && isLow(window) && this.mapIsOpen)
  })
  /** On a phone the page that learns on a map. */
  readonly mapIsOpen = $derived.by(
    () => this.pages && this.#ui.page === 'network' && this.#screen.session.learns,
  )
  readonly panes = $derived.by<readonly PaneName[]>(() =>
    this.learning
      ? ['program', 'network']
      : this.#screen.hasNetworkPane
        ? ['program', 'world', 'network']
        : ['program', 'world'],
  )
  /** The heads of the panes hold the control bars. */
  readonly slim = $derived.by(
    () => this.arrangement === 'stacked' && !this.#ui.filled && this.#screen.hasNetworkPane && !this.learning,
  )
  /** Learning by trying fills the lab, until its code is looked at: its program is folded, and its world stands within it. */
  readonly learning = $derived.by(() => this.#screen.session.learns && !this.#screen.codeOpen && !this.pages)
  /** px of the folded program: what stands beside the map begins below it. */
  foldedHeight = $state(0)
  /** px of the folded program's width: that of the column at the left of the map. */
  rail = $state(150)
  #unfolded = $state<boolean | null>(null)
  /** Is the program open over the map? In a project of one's own it is, until a hand folds it; not over a map of one's own. */
  get unfolded() {
    const { card, session } = this.#screen
    return this.#unfolded ?? (card?.card.playground !== 'q-learning' && session.project.maps === undefined)
  }
  set unfolded(open: boolean) {
    this.#unfolded = open
  }
  readonly bars = $derived(!this.pages && !this.slim)
  readonly stripSize = $derived.by(() => {
    if (this.pages && this.width < 640) return 'phone'
    return this.height < 700 || this.#screen.task.goals.length === 0 ? 'line' : 'whole'
  })
  /** What Piep says stands above the panes where the program is not there to lie over. */
  readonly above = $derived.by(
    () => this.pages || (this.#ui.filled !== null && this.#ui.filled !== 'program'),
  )
  /** On a phone a small world stands above the network. */
  readonly compactWorld = $derived.by(
    () => this.pages && this.#ui.page === 'network' && !this.#screen.session.learns,
  )

  seen(pane: PaneName): boolean {
    if (this.pages) return pane === this.#ui.page || (pane === 'world' && this.compactWorld)
    // Learning has the whole lab already: only its program can fill it instead.
    const filled = this.learning && this.#ui.filled !== 'program' ? null : this.#ui.filled
    return filled === null || filled === pane
  }

  /** What a pane's frame is told. */
  paneOf(name: PaneName) {
    return {
      name,
      page: this.pages,
      visible: this.seen(name),
      filled: this.#ui.filled === name,
      onfill: () => (this.#ui.filled = this.#ui.filled === name ? null : name),
    }
  }

  /** Who builds needs room. */
  makeRoom(building: boolean): void {
    if (building && this.slim) [this.#made, this.#ui.filled] = [true, 'world']
    else if (!building && this.#made) [this.#made, this.#ui.filled] = [false, null]
  }

  turnTo = (pane: PaneName): void => {
    this.#ui.page = pane
    this.#ui.filled = null
  }

  /** Shows a pane, where only one is seen. */
  show(pane: PaneName): Promise<void> {
    this.#ui.page = pane
    if (this.#ui.filled) this.#ui.filled = pane
    return tick()
  }

  async goTo(pane: PaneName): Promise<void> {
    await this.show(pane)
    const section = sectionOf(pane)
    if (section) focusOn(section)
  }

  /** F6 goes round the panes, as it does in other programs. */
  keyDown = (event: KeyboardEvent): void => {
    if (event.key !== 'F6' || event.ctrlKey || event.altKey || event.metaKey) return
    if (document.querySelector('dialog[open]')) return
    event.preventDefault()
    const here = this.panes.find((pane) => sectionOf(pane)?.contains(document.activeElement)) ?? null
    void this.goTo(nextPane(this.panes, here, event.shiftKey))
  }
}

const sectionOf = (pane: PaneName) => document.querySelector<HTMLElement>(`.panes > section.${pane}`)
