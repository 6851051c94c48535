import {
  format,
  orderOf,
  penFor,
  readPseudonym,
  type Entry,
  type Line,
  type Pen,
  type StudyPlan,
} from '@botgarten/experiments/study'
import { version } from '@botgarten/programs'
import { placeOfStudy } from '#storage/study-sign.ts'
import {
  putAside,
  putLines,
  readStudy,
  takeAside,
  writeStudy,
  type LineRecord,
  type OpenStudy,
  type Sitting,
} from '#storage/study.ts'

/** Lines wait so long for others, in milliseconds, before they are kept. */
const pause = 1000

const randomName = () =>
  `s${[...crypto.getRandomValues(new Uint8Array(4))].map((byte) => byte.toString(16).padStart(2, '0')).join('')}`

/** The study of this device, the child that sits at it, and the pen that writes for it. */
class Device {
  #open = $state.raw<OpenStudy | null>(readStudy())
  readonly #page = randomName()
  /** Did this device keep everything so far? */
  keeps = $state(true)
  #waiting: Line[] = []
  #timer: ReturnType<typeof setTimeout> | undefined
  #listeners: readonly (() => void)[] = []
  #pen: Pen | null = null

  get plan(): StudyPlan | null {
    return this.#open?.plan ?? null
  }
  get ready(): boolean {
    return this.#open?.ready ?? false
  }
  get child(): Sitting | null {
    return this.#open?.child ?? null
  }
  /** Is what happens written down now? */
  get writes(): boolean {
    const { child } = this
    return child !== null && child.yes && !child.rests && this.holds
  }
  /** Does this page write, and not one that was opened after it? */
  get holds(): boolean {
    return this.child?.page === this.#page
  }
  /** Modules in the order of the child's group. */
  get modules(): StudyPlan['modules'] {
    const { plan, child } = this
    if (!plan || !child) return []
    return orderOf(plan.modules, plan.order, plan.seed, child.group) as StudyPlan['modules']
  }

  /** A page that was opened, or goes on, writes from now on. */
  hold(): void {
    if (!this.holds) this.#change({ page: this.#page })
  }

  /** Another page has changed something. */
  look = ({ key }: Pick<StorageEvent, 'key'>): void => {
    if (key === placeOfStudy) this.#take(readStudy())
  }

  /** Is told when somebody begins, rests, goes on or ends. Returns how to listen no more. */
  listen(listener: () => void): () => void {
    this.#listeners = [...this.#listeners, listener]
    return () => (this.#listeners = this.#listeners.filter((one) => one !== listener))
  }

  open(plan: StudyPlan): void {
    this.#set({ plan, ready: false, child: null })
  }

  /** Hands the device to children: the researcher has the consents. */
  handOut(): void {
    if (this.plan) this.#set({ plan: this.plan, ready: true, child: null })
  }

  /** Ends the study on this device. What was written stays until it is deleted. */
  close(): void {
    this.#set(null)
  }

  /** A child begins. Returns whether its pseudonym is one of this study. */
  begin(typed: string, yes: boolean): boolean {
    const { plan } = this
    const found = readPseudonym(typed)
    if (!plan || !found || found.group > plan.groups || found.child > plan.children) return false
    const pseudonym = typed.replace(/[\s.-]/g, '').toUpperCase()
    const { group } = found
    const sitting = {
      session: randomName(),
      began: Date.now(),
      last: 0,
      lines: 0,
      part: 0,
      rests: false,
      page: this.#page,
    }
    this.#set({ plan, ready: true, child: { pseudonym, group, yes: yes && plan.log, ...sitting } })
    const order = this.modules.map(({ id }) => id)
    this.write({ event: 'session', format, version, study: plan.id, group, seed: plan.seed, order })
    this.write({ event: 'part', module: order[0]! })
    this.keep()
    return true
  }

  /** Goes on to the next module. */
  goOn(): void {
    const { child } = this
    if (!child || child.part + 1 >= this.modules.length) return
    this.hold()
    this.#change({ part: child.part + 1 })
    this.write({ event: 'part', module: this.modules[child.part + 1]!.id })
    this.keep()
  }

  /** Who follows a lab ends its run first, as long as there is a pen. */
  rest(): void {
    if (!this.writes) return
    this.#before()
    this.write({ event: 'rest' })
    this.#change({ rests: true })
  }

  wake(): void {
    this.#change({ rests: false, page: this.#page })
  }

  /** The child has ended: the next one can come. */
  end(): void {
    this.hold()
    this.#before()
    this.write({ event: 'over' })
    this.keep()
    const { plan } = this
    if (plan) this.#set({ plan, ready: true, child: null })
  }

  /** The pen of the child; null while nothing is written down. */
  get pen(): Pen | null {
    const { child } = this
    if (!child || !this.writes) return null
    this.#pen ??= penFor(child, this.#time, this.#put)
    return this.#pen
  }

  write(entry: Entry): void {
    this.pen?.write(entry)
  }

  /** Of the last line that was written, and never before it, whatever the clock says. */
  #last = 0
  #time = (): number => {
    const { child } = this
    if (child) this.#last = Math.max(this.#last, child.last, Date.now() - child.began)
    return this.#last
  }

  #put = (line: Line): void => {
    if (!this.writes) return
    this.#waiting.push(line)
    this.#timer ??= setTimeout(() => this.keep(), pause)
  }

  /** Lines that the device has not said to have kept. */
  #sent: readonly LineRecord[] = []

  /** Keeps on the device what has been written. */
  keep = (): void => {
    clearTimeout(this.#timer)
    this.#timer = undefined
    const { child } = this
    const lines = this.#waiting.splice(0)
    if (lines.length === 0 || !child) return
    const records = lines.map((line, at) => recordOf(line, child, child.lines + at))
    this.#save({
      ...this.#open!,
      child: { ...child, last: lines.at(-1)!.t, lines: child.lines + lines.length },
    })
    this.#sent = [...this.#sent, ...records]
    void putLines(records).then((kept) => {
      this.keeps &&= kept
      this.#sent = this.#sent.filter((one) => !records.includes(one))
    })
  }

  /** The page is left: what is on its way is kept at once. */
  leave = (): void => {
    this.keep()
    putAside(this.#sent)
  }

  #enders: readonly (() => void)[] = []
  /** Is called before the pen is put down. Returns how to be called no more. */
  beforeEnd(ender: () => void): () => void {
    this.#enders = [...this.#enders, ender]
    return () => (this.#enders = this.#enders.filter((one) => one !== ender))
  }
  #before(): void {
    for (const ender of this.#enders) ender()
  }

  #change(change: Partial<Sitting>): void {
    const { child } = this
    if (child) this.#set({ ...this.#open!, child: { ...child, ...change } })
  }

  #set(open: OpenStudy | null): void {
    this.keeps = writeStudy(open) && this.keeps
    this.#take(open)
  }

  #take(open: OpenStudy | null): void {
    if (open?.child?.session !== this.child?.session) {
      this.#pen = null
      this.#last = 0
    }
    this.#open = open
    for (const listener of this.#listeners) listener()
  }

  #save(open: OpenStudy | null): void {
    this.#open = open
    this.keeps = writeStudy(open) && this.keeps
  }
}

const recordOf = (line: Line, { began }: Sitting, n: number): LineRecord => ({
  ...{ pseudonym: line.pseudonym, session: line.session, began, n },
  text: JSON.stringify(line),
})

/** One a page: who follows a lab, and who shows it, mean the same. */
export const device = new Device()

void takeAside()
