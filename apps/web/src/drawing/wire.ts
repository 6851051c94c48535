import { forget, type Picture } from './canvas.ts'
import type { Command, Group, Lines } from './commands.ts'
import { beginsWith } from './prefix.ts'
import { isPicture, type Frame } from './surface.ts'

// Frames on their way to a worker. What stays the same for many frames travels once and is named by a number from then on:
// the shapes of a group that is painted as a picture, and pictures. The rest travels as text: a browser takes many small
// objects apart far more slowly.

type SentGroup = Omit<Group, 'shapes'> & {
  readonly shapes: readonly Sent[]
  /** Number of its shapes, which have travelled before. */
  readonly stillId?: number
}
type Sent = Exclude<Command, Group | Lines> | SentGroup

type SentPicture = Omit<Picture, 'source'> & { readonly kind: 'picture'; readonly id: number }

interface NewStill {
  readonly id: number
  /** Number of those that its shapes go on from. */
  readonly after?: number
  /** As text, unless long rows of numbers are among them. */
  readonly shapes: readonly Command[] | string
}

interface Body extends Omit<Frame, 'shapes' | 'under'> {
  readonly shapes: readonly Sent[]
  readonly under: readonly (SentGroup | SentPicture)[]
}

export interface SentFrame {
  /** A `Body`. */
  readonly text: string
  readonly newStills: readonly NewStill[]
  /** Numbers of shapes that are not needed any more. */
  readonly dropped: readonly number[]
  readonly newSources: readonly (readonly [id: number, source: CanvasImageSource])[]
}

/** What is remembered of shapes that have travelled. */
interface Travelled {
  readonly id: number
  /** Number of the last frame they were in. */
  used: number
  /** So many frames without them are waited for until they are dropped. */
  readonly kept: number
}

/** From so many square px on, a picture takes megabytes. */
const large = 100_000
const keptOf = ({ still }: Group) => (still && still.width * still.height > large ? 3 : 300)

/** Are rows of numbers among them that text does not hold? */
const hasRows = (shapes: readonly Command[]): boolean =>
  shapes.some((one) => one.kind === 'lines' || (one.kind === 'group' && hasRows(one.shapes)))

/** Makes frames ready to travel. */
export class Sender {
  readonly #stills = new Map<readonly Command[], Travelled>()
  /** The last shapes of a group that grows, by their first. */
  readonly #grown = new WeakMap<Command, readonly Command[]>()
  #next = 0
  #frame = 0
  /** Those of the last frame: the other side has no others. */
  #sources: ReadonlyMap<CanvasImageSource, number> = new Map()
  #newStills: NewStill[] = []
  #last = ''

  /** null: it looks as the one before. */
  send({ shapes, under, ...rest }: Frame): SentFrame | null {
    this.#frame += 1
    const newSources = this.#takeSources(under)
    const text = JSON.stringify({
      ...rest,
      shapes: shapes.map((one) => this.#sent(one)),
      under: under.map((one) => (isPicture(one) ? this.#sentPicture(one) : this.#sentGroup(one))),
    } satisfies Body)
    if (text === this.#last) return null
    this.#last = text
    return { text, newStills: this.#newStills.splice(0), dropped: this.#drop(), newSources }
  }

  #drop(): readonly number[] {
    const old = [...this.#stills].filter(([, { used, kept }]) => this.#frame - used > kept)
    for (const [shapes] of old) this.#stills.delete(shapes)
    return old.map(([, { id }]) => id)
  }

  #sent(command: Command): Sent {
    if (command.kind === 'lines')
      throw new Error('Many lines at once belong into a group that stays the same.')
    return command.kind === 'group' ? this.#sentGroup(command) : command
  }

  #sentGroup(group: Group): SentGroup {
    if (group.still) return { ...group, shapes: [], stillId: this.#idOf(group) }
    return { ...group, shapes: group.shapes.map((one) => this.#sent(one)) }
  }

  #idOf(group: Group): number {
    const known = this.#stills.get(group.shapes)
    if (known) {
      known.used = this.#frame
      return known.id
    }
    const id = this.#next++
    const { shapes, ...part } = this.#newPart(group)
    this.#newStills.push({ id, ...part, shapes: hasRows(shapes) ? shapes : JSON.stringify(shapes) })
    this.#stills.set(group.shapes, { id, used: this.#frame, kept: keptOf(group) })
    return id
  }

  /** Of what grows only what the other side does not have. */
  #newPart({ shapes, grows }: Group): { readonly after?: number; readonly shapes: readonly Command[] } {
    const [first] = shapes
    if (!grows || !first) return { shapes }
    const before = this.#grown.get(first)
    this.#grown.set(first, shapes)
    const travelled = before && this.#stills.get(before)
    if (!before || !travelled || !beginsWith(shapes, before)) return { shapes }
    return { after: travelled.id, shapes: shapes.slice(before.length) }
  }

  #sentPicture({ source, ...place }: Picture): SentPicture {
    return { kind: 'picture', ...place, id: this.#sources.get(source)! }
  }

  #takeSources(under: Frame['under']): SentFrame['newSources'] {
    const before = this.#sources
    const sources = under.filter(isPicture).map(({ source }) => source)
    this.#sources = new Map(sources.map((source) => [source, before.get(source) ?? this.#next++]))
    return [...this.#sources].flatMap(([source, id]) => (before.has(source) ? [] : [[id, source] as const]))
  }
}

/** Makes frames of what has travelled: what was one object is one object again, frame after frame. */
export class Receiver {
  readonly #stills = new Map<number, readonly Command[]>()
  readonly #sources = new Map<number, CanvasImageSource>()

  receive({ text, newStills, dropped, newSources }: SentFrame): Frame {
    for (const still of newStills) this.#add(still)
    const { shapes, under, ...rest } = JSON.parse(text) as Body
    for (const id of dropped) this.#drop(id)
    for (const [id, source] of newSources) this.#sources.set(id, source)
    this.#closeUnused(under)
    return {
      ...rest,
      shapes: shapes.map((one) => this.#received(one)),
      under: under.map((one) => (one.kind === 'picture' ? this.#picture(one) : this.#group(one))),
    }
  }

  #add({ id, after, shapes }: NewStill): void {
    const own = typeof shapes === 'string' ? (JSON.parse(shapes) as readonly Command[]) : shapes
    this.#stills.set(id, after === undefined ? own : [...this.#stills.get(after)!, ...own])
  }

  #drop(id: number): void {
    const shapes = this.#stills.get(id)
    if (shapes) forget(shapes)
    this.#stills.delete(id)
  }

  #picture({ id, x, y, width, height }: SentPicture): Picture {
    return { source: this.#sources.get(id)!, x, y, width, height }
  }

  #received(sent: Sent): Command {
    return sent.kind === 'group' ? this.#group(sent) : sent
  }

  #group({ stillId, shapes, ...group }: SentGroup): Group {
    if (stillId === undefined) return { ...group, shapes: shapes.map((one) => this.#received(one)) }
    return { ...group, shapes: this.#stills.get(stillId)! }
  }

  #closeUnused(under: Body['under']): void {
    const used = new Set(under.flatMap((one) => (one.kind === 'picture' ? [one.id] : [])))
    for (const [id, source] of this.#sources) {
      if (used.has(id)) continue
      if (typeof ImageBitmap !== 'undefined' && source instanceof ImageBitmap) source.close()
      this.#sources.delete(id)
    }
  }
}
