import { learningKey } from '@botgarten/maps'
import { learningIn } from '@botgarten/programs'
import type { LabSession } from '#lab/session.svelte.ts'
import { mapName } from '#figures/map/names.ts'
import { loadStage, type Stage } from '#figures/map/stage.ts'
import { type Blocks, BlockEdits } from './block-edits.ts'
import { taskKey } from './guess.ts'

/** Map of the card's start program; undefined if that learns on no map. */
const mapOfCard = (card: LabSession['opened']['card']): string | undefined =>
  Object.values(card?.start.programs ?? {}).flatMap((program) => learningIn(program)?.map ?? [])[0]

/** The learning task as the blocks describe it, and its map. */
export class Task {
  readonly #session: LabSession
  readonly edits: BlockEdits
  #stage = $state.raw<Stage | null>(null)
  readonly outline = $derived.by(() => learningIn(this.#session.program))
  /** Identifies the task: it changes with every setting that changes what is learned. */
  readonly key = $derived(this.outline ? learningKey(this.outline) : '')
  /** Identifies map, start, goal and closed roads: a guess is void when one of them changes. */
  readonly question = $derived(this.outline ? taskKey(this.outline) : '')

  /** Map, start and goal if the map is not the one of the card; else null. */
  readonly elsewhere = $derived.by(() => {
    const { outline } = this
    const ours = mapOfCard(this.#session.opened.card)
    if (!outline || ours === undefined || outline.map === ours) return null
    const { map, start, goal } = outline
    return { map: mapName(map, this.#session.maps), start, goal }
  })

  constructor(session: LabSession, blocks: Blocks) {
    this.#session = session
    this.edits = new BlockEdits(
      () => this.outline,
      blocks,
      () => session.settleBlocks(),
    )
  }

  get stage() {
    return this.#stage
  }

  /** Is the loaded map the one that the blocks name? */
  get hasMap(): boolean {
    return this.#stage?.id === this.outline?.map
  }

  /** Loads the map that the blocks name; drops it if the task has changed by then. */
  async loadMap(): Promise<void> {
    const { key, outline } = this
    const stage = outline && (await this.#load(outline.map))
    if (key === this.key) this.#stage = stage
  }

  #load = (id: string) => loadStage(id, this.#session.maps)

  /** Chooses another map, with its own start and goal. */
  async chooseMap(id: string): Promise<void> {
    const stage = await this.#load(id)
    if (!stage || this.outline?.map === id) return
    const { start = 0, goal = stage.map.stations.length - 1 } = stage.map
    this.edits.setMap(id, start, goal)
  }
}
