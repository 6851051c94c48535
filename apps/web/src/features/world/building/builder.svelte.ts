import type { Phase } from '#drawing/nudge.ts'
import { distance, type Point } from '#drawing/points.ts'
import type { BuildMode } from '../build-mode.svelte.ts'
import type { Workshop } from '../workshop.ts'
import { most, sceneOf, type Project, type Scene } from '@botgarten/programs'
import {
  COLOURS,
  samePose,
  type Area,
  type Line,
  type Obstacle,
  type Pose,
  type Shape,
  type World,
} from '@botgarten/simulation'
import { freshId, itemOf, moved, poseOf, put, wallBetween, withItem, without } from './edits.ts'
import type { Item, Kind } from './edits.ts'
import { Floors } from '#lab/floor/floors.ts'
import { shapeOfLook, type Look } from './looks.ts'
import Over from './Over.svelte'
import Palette from './Palette.svelte'
import Properties from './Properties.svelte'
import { drawnTo, smoothed } from './strokes.ts'
import { takeFile } from './take.ts'
import Under from './Under.svelte'

export type Tool = 'wall' | 'line'

/** A tap on the last point ends a line (cm). */
const sameSpot = 4
const colours = { obstacles: COLOURS.blue, areas: COLOURS.yellow, lines: COLOURS.black }

/** Build mode: what is in the hand, what is being drawn, and every change of the world as one step. */
export class Builder implements Workshop {
  readonly Under = Under
  readonly Over = Over
  readonly Tools = Palette
  readonly Properties = Properties
  readonly mode: BuildMode
  readonly floors = new Floors()
  /** The pen in the hand. */
  tool = $state<Tool | null>(null)
  /** What the pen has drawn so far, in cm. */
  stroke = $state.raw<readonly Point[]>([])
  /** Name of words that are said below the world. */
  notice = $state.raw<'full' | null>(null)
  #draft = $state.raw<World | null>(null)
  #held: Item | null = null
  #strokeBefore: readonly Point[] = []

  constructor(mode: BuildMode) {
    this.mode = mode
  }

  async open(): Promise<void> {
    await this.floors.load(this.#document, this.mode.session.pictures)
    this.mode.session.paint = this.floors.paint
  }

  get #document(): World {
    return this.mode.session.lab.document.world
  }

  get world(): World {
    return this.#draft ?? this.#document
  }

  get draws(): boolean {
    return this.tool !== null
  }

  /** What is selected, where it stands now. */
  get item(): Item | null {
    const item = itemOf(this.world, this.mode.hand.selected)
    if (item?.kind !== 'obstacles') return item
    const now = this.#standing(item.thing.id)
    return now ? put(item, now) : item
  }

  /** Where an obstacle stands now, wherever its start is. */
  #standing = (obstacle: string): Pose | undefined =>
    this.mode.session.lab.view.obstacles.find(({ id }) => id === obstacle)?.pose

  /** One step: the world is another one from here on. */
  commit(world: World, pictures?: Project['assets']): void {
    this.#draft = null
    this.#held = null
    this.apply(sceneOf(world), pictures)
  }

  apply(scene: Scene, pictures?: Project['assets']): void {
    this.mode.session.apply({ kind: 'scene', after: scene, ...(pictures && { pictures }) })
  }

  /** Shows an item as the hand has it, and keeps it at the end of the move. */
  show(item: Item, phase: Phase): void {
    if (phase === 'end') this.commitItem(item)
    else if (phase === 'move') this.#draft = withItem(this.#document, item)
  }

  /** Changes what is selected, at once. */
  change(change: (item: Item) => Item): void {
    const { item } = this
    if (item) this.commitItem(change(item))
  }

  commitItem(item: Item): void {
    const was = itemOf(this.#document, item.thing.id)
    const now = this.#standing(item.thing.id)
    // What a run has pushed away keeps its start, unless a hand puts it elsewhere.
    const stays = was && now && samePose(now, poseOf(item))
    this.commit(withItem(this.#document, stays ? put(item, poseOf(was)) : item))
  }

  place(id: string, pose: Pose, phase: Phase): void {
    const item = itemOf(this.#document, id)
    if (!item || item.kind === 'obstacles')
      return void this.mode.session.apply({ kind: 'place', id, after: pose }, phase)
    if (phase === 'start') this.#held = item
    this.show(put(this.#held ?? item, pose), phase)
  }

  /** Puts something new down and selects it. */
  add(item: Item): void {
    if (this.world[item.kind].length >= most[item.kind]) {
      this.notice = 'full'
      return
    }
    this.notice = null
    this.commit(withItem(this.#document, item))
    this.mode.hand.selected = item.thing.id
  }

  /** A spot in the middle of what is seen, beside what is there. */
  #spot(kind: Kind): Point {
    const { width, height } = this.world.size
    const middle = this.mode.viewport.middle
    let at = { x: Math.min(width, Math.max(0, middle.x)), y: Math.min(height, Math.max(0, middle.y)) }
    const taken = (spot: Point) =>
      this.world[kind].some((thing) => distance(poseOf({ kind, thing } as Item), spot) < 3)
    for (let tries = 0; tries < 50 && taken(at); tries++) at = { x: at.x + 6, y: at.y - 6 }
    return { x: Math.round(at.x), y: Math.round(at.y) }
  }

  addShape(kind: 'obstacles' | 'areas', shape: Shape): void {
    const id = freshId(this.world, kind)
    const placed = { id, shape, pose: { ...this.#spot(kind), heading: 0 }, colour: colours[kind] }
    if (kind === 'areas') this.add({ kind, thing: placed satisfies Area })
    else this.add({ kind, thing: { ...placed, fixed: true } satisfies Obstacle })
  }

  /** A thing that looks like something, as large as such a thing is. */
  addLook(look: Look): void {
    const id = freshId(this.world, 'obstacles')
    const pose = { ...this.#spot('obstacles'), heading: 0 }
    this.add({ kind: 'obstacles', thing: { id, pose, ...shapeOfLook(look) } })
  }

  /** A pen is taken up or put away; from the keyboard it leaves a line of 1 m at once. */
  pen(tool: Tool, byKeys: boolean): void {
    if (byKeys) return this.#addStraight(tool)
    const next = this.tool === tool ? null : tool
    this.finish()
    this.tool = next
    this.mode.hand.selected = null
  }

  #addStraight(tool: Tool): void {
    const { x, y } = this.#spot(tool === 'wall' ? 'obstacles' : 'lines')
    const ends = [{ x: x - 40, y }, { x: x + 40, y }] // prettier-ignore
    if (tool === 'line') this.#addLine(ends)
    else this.#addWall(ends[0]!, ends[1]!)
  }

  #addWall(from: Point, to: Point): void {
    this.add({ kind: 'obstacles', thing: wallBetween(freshId(this.world, 'obstacles'), from, to) })
  }

  #addLine(points: readonly Point[]): void {
    const line: Line = { id: freshId(this.world, 'lines'), points, width: 3, colour: colours.lines }
    this.add({ kind: 'lines', thing: line })
  }

  draw(at: Point, phase: Phase): void {
    const { width, height } = this.world.size
    const on = { x: tenth(Math.min(width, Math.max(0, at.x))), y: tenth(Math.min(height, Math.max(0, at.y))) }
    if (phase === 'start') this.#strokeBefore = this.stroke
    if (this.tool === 'wall') this.#drawWall(on, phase)
    else this.#drawLine(on, phase)
  }

  /** From point to point: by a drag, or by tapping one after the other. */
  #drawWall(at: Point, phase: Phase): void {
    const from = this.#strokeBefore[0] ?? (phase === 'start' ? at : this.stroke[0]!)
    this.stroke = [from, at]
    if (phase !== 'end') return
    const far = distance(from, at) >= sameSpot
    if (far) this.#addWall(from, at)
    // A first tap waits for the second; after it the next wall begins where this one ends.
    if (this.#strokeBefore.length > 0) this.stroke = far ? [at] : []
    else this.stroke = far ? [] : [from]
  }

  #drawLine(at: Point, phase: Phase): void {
    const before = this.#strokeBefore
    if (phase !== 'end') {
      this.stroke = drawnTo(this.stroke, at)
      return
    }
    const drawn = this.stroke.slice(before.length)
    const tapped = drawn.every((point) => distance(point, at) < sameSpot)
    const isLast = before.length > 0 && distance(before.at(-1)!, at) < sameSpot
    if (!tapped) this.stroke = [...before, ...smoothed(drawn, most.points - before.length)]
    else if (!isLast) this.stroke = [...before, at]
    else this.stroke = before
    if (before.length === 0 ? !tapped : isLast) this.finish()
  }

  /** What was drawn point by point is a line now. */
  finish(): void {
    const points = this.stroke
    this.stroke = []
    this.#strokeBefore = []
    if (this.tool === 'line' && points.length > 1) this.#addLine(points)
  }

  copy(): void {
    const { item } = this
    if (!item) return
    const { x, y, heading } = poseOf(item)
    const { width } = this.world.size
    const beside = { x: x + (x + 12 > width ? -12 : 12), y: y + (y - 12 < 0 ? 12 : -12), heading }
    const twin = put(item, beside)
    this.add({ ...twin, thing: { ...twin.thing, id: freshId(this.world, item.kind) } } as Item)
  }

  remove(): void {
    const { item } = this
    if (!item) return
    this.mode.hand.selected = null
    this.notice = null
    this.commit(without(this.#document, item))
  }

  reorder(by: 1 | -1): void {
    const { item } = this
    if (!item) return
    const next = moved(this.#document, item, by)
    if (next !== this.#document) this.commit(next)
  }

  key(event: KeyboardEvent): boolean {
    const command = event.ctrlKey || event.metaKey
    if (event.key === 'Escape' || (event.key === 'Enter' && this.stroke.length > 0)) this.finish()
    if (event.key === 'Escape') this.tool = null
    if (!this.item) return false
    if (event.key === 'Delete' || event.key === 'Backspace') this.remove()
    else if (event.key.toLowerCase() === 'd' && command) this.copy()
    else return false
    return true
  }

  /** A picture for the floor, or a scene. */
  take = (file: File): Promise<void> => takeFile(this, file)
}

const tenth = (value: number) => Math.round(value * 10) / 10
