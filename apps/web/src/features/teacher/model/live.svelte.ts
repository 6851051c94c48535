import * as v from 'valibot'
import { inOrder } from '@botgarten/classroom/tiles'
import { LiveStream } from '#parts/page/live-stream.ts'
import type { Source } from '#parts/page/source.ts'
import * as answers from './answers.ts'
import type { SchoolClass } from './answers.ts'
import { Refused, type ClassApi } from './api.ts'
import { Attempts } from './attempts.svelte.ts'
import type { Tile } from './live.ts'

/** The session is over, or the class is deleted or hidden. */
const isOver = (error: unknown) => error instanceof Refused && [401, 404, 410, 423].includes(error.status)

/** A hint of a card by its number from 1, or in own words. */
type Hint = { readonly card: string; readonly hint: number } | { readonly text: string }
/** The start program of a card, or a project as its file has it. */
type StartProgram = { readonly card: string } | { readonly file: string }

/** A cable that was pulled is no end of a stream: one that was silent for so long is looked after, so often. */
const silence = 12_000
const checkEvery = 5000

const read = <Schema extends v.GenericSchema>(schema: Schema, { data }: { readonly data: string }) =>
  v.parse(schema, JSON.parse(data))

/** A class as it is now: a stream of the server keeps it so. */
export class LiveClass {
  readonly id: string
  readonly #api: ClassApi
  readonly #stream: LiveStream
  #state = $state.raw<v.InferOutput<typeof answers.liveState> | null>(null)
  /** The server's clock minus ours, ms. */
  #shift = $state(0)
  #connection = $state<'opening' | 'open' | 'broken' | 'ended'>('opening')
  readonly #attempts = new Attempts()
  #heardAt = 0
  #checking = false

  constructor(api: ClassApi, id: string, open: (path: string) => Source = (path) => new EventSource(path)) {
    this.#api = api
    this.id = id
    this.#stream = new LiveStream(
      () => open(`/api/class${this.#path('/stream')}`),
      (source) => this.#follow(source),
      () => this.#broke(),
    )
  }

  /** Null until the first event. */
  get school(): SchoolClass | null {
    return this.#state?.class ?? null
  }

  get tiles(): readonly Tile[] {
    return this.#state?.tiles ?? []
  }

  get attention(): boolean {
    return (this.#state?.attention ?? null) !== null
  }

  /** `broken`: what is seen may be old; it comes back by itself. `ended`: the class or the session is over. */
  get connection() {
    return this.#connection
  }

  get refused(): string | null {
    return this.#attempts.refused
  }

  /** The time by the server's clock. */
  at = (here: number): number => here + this.#shift

  /** Those who need somebody first, as the server has them. */
  inOrder = (now: number): readonly Tile[] => inOrder(this.tiles, now)

  /** Follows the class until the returned function is called. */
  watch(): () => void {
    this.#stream.open()
    const checks = setInterval(() => void this.#check(silence), checkEvery)
    const check = () => void this.#check(0)
    const page = typeof window === 'undefined' ? null : window
    for (const event of ['offline', 'online']) page?.addEventListener(event, check)
    return () => {
      for (const event of ['offline', 'online']) page?.removeEventListener(event, check)
      clearInterval(checks)
      this.#stream.close()
    }
  }

  #follow(source: Source): void {
    source.addEventListener('state', (event) => this.#take(read(answers.liveState, event)))
    source.addEventListener('tiles', (event) => this.#merge(read(answers.liveTiles, event)))
    source.addEventListener('end', (event) => this.#end(read(answers.liveEnd, event).reason))
  }

  /** Where nothing was heard for so long, the server is asked; where it does not answer, the stream is opened again. */
  async #check(silent: number): Promise<void> {
    if (this.#checking || this.#connection === 'ended' || Date.now() - this.#heardAt < silent) return
    this.#checking = true
    try {
      const state = await this.#api.ask(answers.liveState, 'GET', this.#path('/live'))
      if (this.#stream.isWanted && this.#connection === 'broken') this.#stream.open()
      this.#take(state)
    } catch (error) {
      this.#connection = isOver(error) ? 'ended' : 'broken'
    }
    this.#checking = false
  }

  #take(state: v.InferOutput<typeof answers.liveState>): void {
    this.#heardAt = Date.now()
    this.#state = state
    this.#shift = state.now - Date.now()
    this.#connection = 'open'
  }

  #merge({ now, tiles }: v.InferOutput<typeof answers.liveTiles>): void {
    if (!this.#state) return
    this.#heardAt = Date.now()
    const freshOf = (id: string) => tiles.find((tile) => tile.id === id)?.live
    const all = this.#state.tiles.map((tile) => ({ ...tile, live: freshOf(tile.id) ?? tile.live }))
    this.#state = { ...this.#state, now, tiles: all }
  }

  #end(reason: string): void {
    if (reason === 'again') return this.#stream.open()
    this.#stream.close()
    this.#connection = 'ended'
  }

  #broke(): void {
    if (this.#connection !== 'ended') this.#connection = 'broken'
  }

  open = () => this.#do('POST', '/open')
  close = () => this.#do('POST', '/close')
  stopJoining = () => this.#do('POST', '/stop-joining')
  callAttention = (on: boolean) => this.#do('PUT', '/attention', { on })
  handDown = (pupil: string) => this.#do('POST', `/pupils/${pupil}/hand-down`)
  /** @param cards null: all of them */
  setFree = (cards: readonly string[] | null, level: SchoolClass['level']) =>
    this.#do('PUT', '/free', { cards, level })

  /** @param pupil null: all */
  sendHint = (pupil: string | null, hint: Hint) =>
    this.#do('POST', '/handouts', { to: pupil === null ? 'all' : [pupil], kind: 'hint', ...hint })

  /** @param pupil null: all */
  sendProgram(pupil: string | null, program: StartProgram): Promise<boolean> {
    if ('card' in program)
      return this.#do('POST', '/handouts', {
        ...{ to: pupil === null ? 'all' : [pupil], kind: 'program', card: program.card },
      })
    return this.#do('POST', `/programs?to=${pupil ?? 'all'}`, JSON.parse(program.file))
  }

  /**
   * A pupil's project; the child sees who looks for as long as this is asked again and again.
   * @param known what the last look found
   */
  async look(pupil: string, known: Looked | null): Promise<Looked | null> {
    const query = known ? `?known=${known.id}:${known.revision}` : ''
    const found = await this.#attempts.try(() =>
      this.#api.ask(answers.insideAnswer, 'POST', this.#path(`/pupils/${pupil}/inside${query}`)),
    )
    if (!found?.project) return known
    const { id, revision, project } = found.project
    if (project === null || project === undefined) return known
    return { id, revision, file: JSON.stringify(project) }
  }

  /** The child sees that nobody looks any more. */
  lookAway = (pupil: string) => this.#do('DELETE', `/pupils/${pupil}/inside`)

  #path = (path: string) => `/classes/${this.id}${path}`

  #do = (method: 'POST' | 'PUT' | 'DELETE', path: string, body?: unknown): Promise<boolean> =>
    this.#attempts.do(() => this.#api.send(method, this.#path(path), body))
}

/** What was found inside. */
export interface Looked {
  readonly id: string
  readonly revision: number
  /** The project, not read yet. */
  readonly file: string
}
