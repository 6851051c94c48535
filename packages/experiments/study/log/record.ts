import type { Lab, Wheels } from '@botgarten/lab'
import type { Drive } from '@botgarten/learning/neural-network/examples/types'
import type { Entry } from './code-book.ts'
import type { TypedTexts } from './typed-texts.ts'

/** Takes what has happened. */
export interface Pen {
  readonly write: (entry: Entry) => void
  readonly texts: TypedTexts
}

/** A lab that writes down what it is told, and goes as it would without. */
export interface RecordedLab {
  readonly lab: Lab
  /** Writes what has not been written yet. */
  readonly flush: () => void
  /** The child rests, or leaves: a run that is on ends in the log. */
  readonly end: () => void
}

/** The verbs of a lab, without those that only tell. */
type Verbs = Pick<
  Lab,
  | 'edit'
  | 'rebuild'
  | 'start'
  | 'stop'
  | 'pause'
  | 'resume'
  | 'step'
  | 'setStops'
  | 'advance'
  | 'setWeight'
  | 'setBrain'
  | 'place'
  | 'press'
  | 'drive'
  | 'record'
  | 'remember'
  | 'setTraining'
  | 'pressButton'
  | 'goTo'
  | 'branch'
  | 'swap'
  | 'reset'
  | 'view'
>

/**
 * Writes down all that a lab is told from here on: replayed in this order it makes the same runs, to the last bit. The lab goes
 * back to its start first, as it stands in the first line.
 * @param opened `place`: id of a card, or `free`; `seed`: with which the lab was loaded
 */
export function recorded(
  lab: Lab,
  pen: Pen,
  opened: { readonly place: string; readonly seed: number },
): RecordedLab {
  lab.reset()
  pen.write({ event: 'open', ...opened, ...pen.texts.document(lab.document()) })
  const writer = new Writer(lab, pen, opened.seed)
  const own = verbsOf(lab, pen, writer)
  const handler = {
    get: (target: Lab, name: keyof Lab): unknown =>
      Object.hasOwn(own, name) ? own[name as keyof Verbs] : target[name].bind(target),
  }
  return { lab: new Proxy(lab, handler), flush: writer.flush, end: writer.end }
}

/** Time that goes by, and runs that end, between the verbs. */
class Writer {
  readonly #lab: Lab
  readonly #pen: Pen
  readonly #seed: number
  #on = false
  #ticks = 0
  #checks = ''

  constructor(lab: Lab, pen: Pen, seed: number) {
    this.#lab = lab
    this.#pen = pen
    this.#seed = seed
    this.seeChecks()
  }

  /** Notes ticks that went by; stretches without a hand between them are one line. */
  time(ticks: number, practising: boolean): void {
    if (practising && this.#ticks > 0) this.flush()
    this.#ticks += ticks
    if (practising || this.#ticks >= longestStretch) this.flush(practising)
  }

  flush = (practising = false): void => {
    if (this.#ticks > 0) this.#pen.write({ event: 'time', ticks: this.#ticks, practising })
    this.#ticks = 0
  }

  /** A verb, written as what it was, or as a run that began, or after one that it ended. */
  verb<Result>(entry: Entry, act: () => Result): Result {
    this.flush()
    const before = this.#end()
    const result = act()
    const { tick, phase } = this.#lab.now()
    const begun = entry.event === 'edit' && tick < before.ticks
    if (begun || entry.event === 'run' || entry.event === 'reset') this.#note(before)
    this.#pen.write(entry)
    if (entry.event === 'run' || (entry.event === 'step' && phase === 'paused')) this.#on = true
    this.seeEnd()
    return result
  }

  start(): void {
    this.verb({ event: 'run', seed: this.#seed }, () => this.#lab.start())
  }

  /** Has a run ended by itself, or was it stopped? */
  seeEnd(): void {
    const { phase } = this.#lab.now()
    if (this.#on && phase !== 'running' && phase !== 'paused') this.end()
  }

  end = (): void => {
    this.flush()
    this.#note(this.#end())
    this.#on = false
  }

  #end() {
    const passed = this.#on
      ? this.#lab
          .view()
          .checks.filter((one) => one.passed)
          .map(({ id }) => id)
      : []
    return { ticks: this.#lab.now().tick, hash: this.#lab.hash(), passed }
  }

  #note(end: Omit<Extract<Entry, { event: 'end' }>, 'event'>): void {
    if (this.#on && end.ticks > 0) this.#pen.write({ event: 'end', ...end })
  }

  /** What has turned green or open since the last look. */
  seeChecks(view = this.#lab.view()): void {
    const now = view.checks.map(({ passed }) => (passed ? '1' : '0')).join('')
    if (now === this.#checks) return
    const before = this.#checks
    this.#checks = now
    if (before === '') return
    this.flush()
    view.checks.forEach(({ id: check, passed }, at) => {
      if (now[at] !== before[at]) this.#pen.write({ event: 'check', check, passed, tick: view.tick })
    })
  }
}

/** Ten seconds: so much is lost where a device is switched off. */
const longestStretch = 600

/** Makes a verb that writes down what it was told before it does it. */
type Said = <Name extends keyof Verbs>(
  name: Name,
  entry: (...given: Parameters<Lab[Name]>) => Entry,
) => Lab[Name]

function verbsOf(lab: Lab, { texts }: Pen, writer: Writer): Verbs {
  const said: Said = (name, entry) => {
    type Given = Parameters<Lab[typeof name]>
    const act = (...given: Given) => (lab[name] as (...given: Given) => unknown)(...given)
    return ((...given: Given) => writer.verb(entry(...given), () => act(...given))) as Lab[typeof name]
  }
  return {
    ...timeOf(lab, writer),
    ...documentsOf(lab, texts, writer, said),
    ...coursesOf(said),
    ...handsOf(texts, said),
  }
}

const timeOf = (lab: Lab, writer: Writer): Pick<Verbs, 'start' | 'advance' | 'view'> => ({
  start: () => writer.start(),
  advance(ticks, examples) {
    const before = lab.now().tick
    const moved = lab.advance(ticks, examples)
    if (!moved) return false
    const { tick, practising } = lab.now()
    writer.time(practising ? tick - before : ticks, practising)
    writer.seeEnd()
    return true
  },
  view(robot) {
    const view = lab.view(robot)
    if (!view.time.past) writer.seeChecks(view)
    return view
  },
})

const documentsOf = (
  lab: Lab,
  texts: TypedTexts,
  writer: Writer,
  said: Said,
): Pick<Verbs, 'edit' | 'rebuild' | 'setBrain' | 'setTraining'> => ({
  edit(programs, fromStart = false) {
    const old = lab.document().programs
    const news = Object.fromEntries(Object.entries(programs).filter(([id, one]) => old[id] !== one))
    const entry = { event: 'edit', programs: texts.programs(news), fromStart } as const
    writer.verb(entry, () => lab.edit(programs, fromStart))
  },
  rebuild: said('rebuild', (document, floor, stood = {}) => {
    const written = texts.document(document)
    return { event: 'rebuild', ...written, floor: floor !== undefined, stood }
  }),
  setBrain: said('setBrain', (brain, value) => ({ event: 'brain', brain, value: texts.brain(value) })),
  setTraining: said('setTraining', (brain, change) => {
    const without = (['examples', 'practice'] as const).filter((part) => change[part] === null)
    return { event: 'training', brain, change: texts.training(change), without }
  }),
})

type Courses = 'stop' | 'pause' | 'resume' | 'reset' | 'branch' | 'swap' | 'step' | 'setStops' | 'goTo'

const coursesOf = (said: Said): Pick<Verbs, Courses> => ({
  stop: said('stop', () => ({ event: 'stop' })),
  pause: said('pause', () => ({ event: 'pause' })),
  resume: said('resume', () => ({ event: 'resume' })),
  reset: said('reset', () => ({ event: 'reset' })),
  branch: said('branch', () => ({ event: 'branch' })),
  swap: said('swap', () => ({ event: 'swap' })),
  step: said('step', (step, robot = '') => ({ event: 'step', step, robot })),
  setStops: said('setStops', (blocks) => ({ event: 'stops', blocks: [...blocks] })),
  goTo: said('goTo', (tick) => ({ event: 'look', tick: tickOf(tick) })),
})

type Hands = 'setWeight' | 'place' | 'press' | 'pressButton' | 'drive' | 'record' | 'remember'

const handsOf = (texts: TypedTexts, said: Said): Pick<Verbs, Hands> => ({
  setWeight: said('setWeight', (brain, from, to, weight, set = '') => ({
    ...({ event: 'knob', brain, from, to, weight } as const),
    set: texts.hide(set),
  })),
  place: said('place', (thing, pose, start) => ({ event: 'place', thing, pose, start: start ?? null })),
  press: said('press', (key, down, robot = '') => ({ event: 'key', key, down, robot })),
  pressButton: said('pressButton', (button, down, robot = '') => ({ event: 'button', button, down, robot })),
  drive: said('drive', (wheels, others = {}, robot = '') => {
    const hand = wheels && { ...inPercent(wheels), others }
    return { event: 'pad', hand, robot }
  }),
  record: said('record', (recording) => {
    const told = recording && { ...recording, drive: driveOf(recording.drive) }
    return { event: 'record', recording: told }
  }),
  remember: said('remember', (row) => {
    const told = { ...row, wheels: inPercent(row.wheels), drive: driveOf(row.drive) }
    return { event: 'remember', row: told }
  }),
})

/** Without what a child may have written beside it. */
const driveOf = ({ id, by, seed }: Drive): Drive => ({ id, by, seed })

/** The lab takes no more. */
const inPercent = ({ left, right }: Wheels): Wheels => ({ left: within(left), right: within(right) })
const within = (percent: number) => Math.max(-100, Math.min(100, percent))

/** The present, where no tick is named. */
const tickOf = (tick: number) => (tick > lastTick ? lastTick : Math.max(0, Math.round(tick)))
const lastTick = 86_400_000
