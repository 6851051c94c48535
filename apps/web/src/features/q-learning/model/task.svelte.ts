import { learningKey } from '@botgarten/maps'
import { learningIn } from '@botgarten/programs'
import type { LabSession } from '#lab/session.svelte.ts'
import { mapName } from '#figures/map/names.ts'
import { loadStage, type Stage } from '#figures/map/stage.ts'
import { type Blocks, BlockEdits } from './block-edits.ts'
import { taskKey } from './guess.ts'

/** The map that a card begins with; undefined where it learns on none. */
const mapOfCard = (card: LabSession['opened']['card']): string | undefined =>
  Object.values(card?.start.programs ?? {}).flatMap((program) => learningIn(program)?.map ?? [])[0]

/** What the blocks want learned, and the map that they name. */
export class Task {
  readonly #session: LabSession
  readonly edits: BlockEdits
  #stage = $state.raw<Stage | null>(null)
  readonly outline = $derived.by(() => learningIn(this.#session.program))
  /** Of everything that decides what is learned. */
  readonly key = $derived(this.outline ? learningKey(this.outline) : '')
  /** Map, start, goal and closed roads: what a guess is about. */
  readonly question = $derived(this.outline ? taskKey(this.outline) : '')

  /** The map that is learned on instead of that of the card, with its start and goal; null: it is the card's. */
  readonly elsewhere = $derived.by(() => {
    const { outline } = this
    const ours = mapOfCard(this.#session.opened.card)
    if (!outline || ours === undefined || outline.map === ours) return null
    const { map, start, goal } = outline
    return { map: mapName(map, this.#session.maps), start, goal }
  })

  constructor(session: LabSession, blocks: Blocks) {
    this.#session = session
    this.edits = new BlockEdits(() => this.outline, blocks)
  }

  get stage() {
    return this.#stage
  }

  /** Is the map there that the blocks name? */
  get hasMap(): boolean {
    return this.#stage?.id === this.outline?.map
  }

  /** Loads the map that the blocks name, unless they say something else by then. */
  async loadMap(): Promise<void> {
    const { key, outline } = this
    const stage = outline && (await this.#load(outline.map))
    if (key === this.key) this.#stage = stage
  }

  #load = (id: string) => loadStage(id, this.#session.maps)

  /** Another map, from where it begins to where it ends. */
  async chooseMap(id: string): Promise<void> {
    const stage = await this.#load(id)
    if (!stage || this.outline?.map === id) return
    const { start = 0, goal = stage.map.stations.length - 1 } = stage.map
    this.edits.setMap(id, start, goal)
  }
}
