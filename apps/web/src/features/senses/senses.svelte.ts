import { untrack } from 'svelte'
import { prefersReducedMotion } from 'svelte/motion'
import type { TryView } from '@botgarten/lab/trying'
import { coinFor, drawCoin } from '#drawing/coin.ts'
import type { Command, Group } from '#drawing/commands.ts'
import { drawFan, drawFanNow, fanInSight, roomIn, type Fan } from '#drawing/fan.ts'
import type { Point, Size } from '#drawing/points.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { language } from '#words/language.svelte.ts'
import { edgeAt, type EdgeField, type Edges } from './model/edges.ts'
import { Night, type SetFields } from './model/night.svelte.ts'
import { cellAt, fanOf, keepRows, rowsOf, type Row } from './model/table.ts'
import Choice from './view/Choice.svelte'
import Over from './view/Over.svelte'
import Pane from './view/Pane.svelte'

declare module '#lab/slots.ts' {
  interface Slots {
    /** What a robot learns by trying with its own sensors. */
    senses: Senses
  }
}

/**
 * Milliseconds between two looks at what is learned: each may draw the whole table again. One of more cells than `many` is
 * looked at less often, and so is one that learns faster than an eye follows.
 */
const often = 100
const calm = 400
const seldom = 500
const many = 300
const fast = 4

/** An edge while a hand pulls it: of which sensor, and where it is. */
interface Pulled {
  readonly sensor: number
  readonly field: EdgeField
  readonly value: number
}

/** What is shown of learning by trying: the table of now or of then, and what of it is drawn on the floor. */
export class Senses {
  readonly Pane = Pane
  readonly Choice = Choice
  readonly Over = Over
  readonly session: LabSession
  /** Learns while nobody looks. */
  readonly night: Night
  readonly #setFields: SetFields
  #now = $state.raw<TryView | null>(null)
  #pulled = $state.raw<Pulled | null>(null)
  /** The cell that was tapped; null: that of the last move is looked at. */
  chosen = $state.raw<{ readonly state: number; readonly action: number } | null>(null)
  /** Are the edges on the rays to be pulled? */
  edgesOpen = $state(false)

  constructor(session: LabSession, setFields: SetFields) {
    this.session = session
    this.night = new Night(session, setFields)
    this.#setFields = setFields
    this.#look()
  }

  /** Null where no block tries any more. */
  get now() {
    return this.#now
  }

  /** Follows the lab. Not with every frame: while it runs, ten times a second. Returns how to end it. */
  open(): () => void {
    const { session } = this
    const close = $effect.root(() => {
      $effect(() => {
        if (session.lab.facts.phase === 'running') {
          const timer = setInterval(this.#look, this.#pause)
          return () => clearInterval(timer)
        }
        void [session.lab.view, session.lab.document, session.robotId]
        untrack(this.#look)
        return undefined
      })
    })
    return () => {
      close()
      this.night.end()
    }
  }

  get #pause() {
    const cells = untrack(() => this.#now?.table.q.length ?? 0)
    if (prefersReducedMotion.current || cells > many) return seldom
    return this.session.lab.speed >= fast ? calm : often
  }

  #look = (): void => {
    const now = this.session.lab.trying(this.session.robotId)
    this.#now = now
    if (now?.stage === 'trying' || now?.curve.length) this.night.note(now.curve)
  }

  #shown: readonly Row[] = []
  readonly rows = $derived.by(
    () => (this.#shown = keepRows(this.#shown, this.#now ? rowsOf(this.#now.table) : [])),
  )
  readonly #last = $derived.by(() => this.#now?.last ?? null)

  /** The cell whose number is looked at. */
  readonly cell = $derived.by(() => {
    const { chosen, rows } = this
    if (chosen && rows[chosen.state]?.cells[chosen.action]) return chosen
    const last = this.#last
    return last ? { state: last.from, action: last.action } : null
  })

  /** How the number of that cell has just come about; null where it was not the last one to change. */
  readonly trace = $derived.by(() => {
    const [last, cell] = [this.#last, this.cell]
    return last && cell && last.from === cell.state && last.action === cell.action ? last : null
  })

  // ---- on the floor ----

  readonly #fan: Fan | null = $derived.by(() => {
    const now = this.#now
    if (!now || this.rows.length === 0 || this.edgesOpen || now.stage === 'fresh') return null
    const { sensors } = this.session.config
    const [one, two] = now.table.sensors.map(({ port }) => sensors[port]?.y ?? 0)
    return fanOf(now.table, this.rows, now.state, two !== undefined && one! < two)
  })
  /** Is what the robot senses shown as fields before it? */
  readonly fans = $derived.by(() => this.#fan !== null)
  #drawn: { readonly key: string; readonly fields: Group } | null = null

  /** Under the robot. The same picture as long as nothing else is known: it is only moved. Px. */
  under(at: Point, heading: number, scale: number, seen: Size & Point): readonly Command[] {
    const fan = this.#fan
    if (!fan) return []
    const [room, turn] = [roomIn(seen), 90 - heading]
    const shapes = [this.#fields(fan, scale, room), ...drawFanNow(fan, scale, room)]
    return [{ kind: 'group', ...fanInSight(fan, scale, { at, turn, seen }), turn, shapes }]
  }

  #fields(fan: Fan, scale: number, room: number): Group {
    const key = JSON.stringify([fan.fields, fan.actions, scale, room])
    if (this.#drawn?.key !== key) this.#drawn = { key, fields: drawFan(fan, scale, room) }
    return this.#drawn.fields
  }

  readonly #coin = $derived.by(() => {
    const last = this.#now?.stage === 'trying' ? this.#now.last : null
    return last && coinFor(last.reward, language.locale)
  })

  /** Over the robot: what has just been paid. @param at px */
  over(at: Point, heading: number, scale: number): readonly Command[] {
    return this.#coin ? drawCoin(this.#coin, at, heading, 12 * scale) : []
  }

  // ---- edges ----

  /** Edges of a sensor as they are pulled, or as its block says; null for colours, touch, and where both are the same. */
  edgesOf(sensor: number): Edges | null {
    const trial = this.#now?.outline.trial
    const mode = trial?.sensors[sensor]?.mode
    const [low, high] = trial?.edges[sensor] ?? []
    if ((mode !== 'distance' && mode !== 'light') || low === undefined || high === undefined) return null
    const pulled = this.#pulled?.sensor === sensor ? this.#pulled : null
    return pulled?.field === 'LOW' ? [pulled.value, high] : pulled ? [low, pulled.value] : [low, high]
  }

  /** A hand pulls an edge; the block learns of it when it lets go. */
  pull(sensor: number, field: EdgeField, wanted: number): void {
    const edges = this.edgesOf(sensor)
    if (edges) this.#pulled = { sensor, field, value: edgeAt(field, edges, wanted) }
  }

  letGo(): void {
    const pulled = this.#pulled
    this.#pulled = null
    if (pulled) this.setEdge(pulled.sensor, pulled.field, pulled.value)
  }

  /** Writes an edge into its block: one step to undo. */
  setEdge(sensor: number, field: EdgeField, value: number): void {
    const edges = this.edgesOf(sensor)
    const block = this.#now?.outline.senses[sensor]
    if (!edges || block === undefined || edges[field === 'LOW' ? 0 : 1] === value) return
    this.#setFields(block, { [field]: String(value) })
  }

  /** Index of the looked-at cell in the table; −1: there is none. */
  get at(): number {
    const { cell } = this
    return this.#now && cell ? cellAt(this.#now.table, cell.state, cell.action) : -1
  }
}
