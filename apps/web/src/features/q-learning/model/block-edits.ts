import { mapField } from '@botgarten/blocks'
import { ownText, type LearningOutline } from '@botgarten/programs'

/** Fields and closed roads are blocks: who holds the blocks changes them. Each call is one step to undo. */
export interface Blocks {
  setFields(block: string, fields: { readonly [name: string]: string }): void
  setClosed(map: string, roads: LearningOutline['closed']): void
}

/** What the map and the sliders change in the blocks. */
export class BlockEdits {
  readonly #outline: () => LearningOutline | null
  readonly #blocks: Blocks
  readonly #settle: () => unknown

  /** @param settle takes over pending changes of the blocks, so that an edit that depends on the task does not undo them */
  constructor(outline: () => LearningOutline | null, blocks: Blocks, settle: () => unknown) {
    this.#outline = outline
    this.#blocks = blocks
    this.#settle = settle
  }

  /** The task with every change of the blocks: the editor reports them up to a frame later. */
  #latest(): LearningOutline | null {
    this.#settle()
    return this.#outline()
  }

  /** Another map, with where it begins and ends; signs and rewards of the map before are gone. */
  setMap(map: string, start: number, goal: number): void {
    const outline = this.#latest()
    if (!outline) return
    if (outline.closed.length > 0) this.#blocks.setClosed(outline.blocks.map, [])
    const fields = { MAP: mapField(map), START: String(start), FINISH: String(goal), REWARDS: '' }
    this.#blocks.setFields(outline.blocks.map, fields)
  }

  /** Start and goal change places rather than become one. */
  setStation(field: 'START' | 'FINISH', station: number): void {
    const outline = this.#latest()
    if (!outline) return
    const { start, goal } = outline
    const [other, own] = field === 'START' ? [goal, start] : [start, goal]
    const swapped = other === station ? own : other
    const [from, to] = field === 'START' ? [station, swapped] : [swapped, station]
    this.#blocks.setFields(outline.blocks.map, { START: String(from), FINISH: String(to) })
  }

  isClosed(from: number, to: number): boolean {
    return this.#outline()?.closed.some(([a, b]) => a === from && b === to) ?? false
  }

  /** Closes or opens a road, in one direction or in both. */
  setRoad(from: number, to: number, there: boolean, back: boolean): void {
    const outline = this.#latest()
    if (!outline) return
    const others = outline.closed.filter(([a, b]) => !((a === from && b === to) || (a === to && b === from)))
    const own = [...(there ? [[from, to] as const] : []), ...(back ? [[to, from] as const] : [])]
    this.#blocks.setClosed(outline.blocks.map, [...others, ...own])
  }

  /** Whether a move costs its length, and what every move costs. */
  setPay(fields: { readonly LENGTH?: 'TRUE' | ''; readonly STEP_COST?: string }): void {
    const outline = this.#outline()
    if (outline) this.#blocks.setFields(outline.blocks.map, fields)
  }

  /** What stations and roads pay beside the goal; 0: nothing. */
  setOwn(places: readonly string[], value: number): void {
    const outline = this.#latest()
    if (!outline) return
    const others = Object.entries(outline.pay?.own ?? {}).filter(([place]) => !places.includes(place))
    const own = Object.fromEntries(
      [...others, ...places.map((place) => [place, value] as const)].filter(([, paid]) => paid !== 0),
    )
    this.#blocks.setFields(outline.blocks.map, { REWARDS: ownText(own) })
  }

  /** A number 0..1 of an expert, a decay, or the rule set. */
  setBehaviour(field: string, value: string): void {
    const id = this.#outline()?.blocks.behaviour
    if (id !== undefined) this.#blocks.setFields(id, { [field]: value })
  }
}
