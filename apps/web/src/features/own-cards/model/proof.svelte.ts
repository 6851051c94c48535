import { tryCard, type Outcome } from '@botgarten/content/own-card'
import { check, fitsWorld, lackOf, type CardLack, type OwnCard, type Project } from '@botgarten/programs'
import type { Floor } from '@botgarten/simulation'

/** Milliseconds of a frame that Bo's trials take. */
const budget = 8
/** A hand that goes on within this time is not done yet, in ms. */
const calm = 500

/** What keeps a card from being passed on; null: nothing. */
export type Lack = CardLack | 'unfit' | 'blocks' | 'trying' | 'unsolved' | 'start' | 'wrong'

type Run = Parameters<typeof tryCard>
interface Task {
  readonly key: string
  readonly run: Run
}
/** By the task's key; what has not been tried is not there. */
type Known = { readonly [key: string]: Outcome }

/** Bo tries a card that is being made: its solution, its start and its wrong answers, in pieces of frames. */
export class Proof {
  readonly #floor: Floor
  #known = $state.raw<Known>({})
  #tasks = $state.raw<readonly Task[]>([])
  #project = $state.raw<(Project & { readonly ownCard: OwnCard }) | null>(null)
  #frame = 0
  #timer: ReturnType<typeof setTimeout> | undefined
  /** Programs are frozen data: each has a number. */
  readonly #numbers = new WeakMap<object, number>()
  #count = 0

  constructor(floor: Floor) {
    this.#floor = floor
  }

  /** Tries what has changed, once the hand is calm. */
  follow(project: Project & { readonly ownCard: OwnCard }): void {
    cancelAnimationFrame(this.#frame)
    clearTimeout(this.#timer)
    this.#project = project
    this.#tasks = this.#canRun(project) ? this.#tasksOf(project) : []
    this.#timer = setTimeout(() => this.#go(), calm)
  }

  #canRun({ programs, world, ownCard }: Project & { readonly ownCard: OwnCard }): boolean {
    return (
      ownCard.checks.length > 0 &&
      world.robots.every(
        ({ program, config }) => !check(programs[program]!, config).some(({ stops }) => stops),
      )
    )
  }

  #tasksOf({ programs, brains, world, ownCard }: Project & { readonly ownCard: OwnCard }): readonly Task[] {
    const { starts, start, wrong = [], checks } = ownCard
    const task = (of: Run[1], at: number): Task => {
      const place = starts[at]!
      const known = [this.#numberOf(of.programs), this.#numberOf(of.brains)]
      const key = JSON.stringify([checks, place, ...known])
      return { key, run: [{ world }, of, { checks }, { start: place, floor: this.#floor }] }
    }
    const solved = { programs, brains }
    return [
      ...starts.map((_, at) => task(solved, at)),
      ...(start
        ? starts.map((_, at) => task({ ...start, programs: { ...programs, ...start.programs } }, at))
        : []),
      ...wrong.map((one) => task({ ...one, programs: { ...programs, ...one.programs } }, 0)),
    ]
  }

  #numberOf(part: object): string {
    const inner = Object.values(part).map((one: object) => {
      const number = this.#numbers.get(one) ?? (this.#count += 1)
      this.#numbers.set(one, number)
      return number
    })
    return inner.join()
  }

  #go(): void {
    const open = this.#tasks.find(({ key }) => !(key in this.#known))
    if (!open) return
    const going = tryCard(...open.run)
    const pass = () => {
      const end = performance.now() + budget
      do {
        const { done, value } = going.next()
        if (!done) continue
        this.#known = { ...this.#known, [open.key]: value }
        return this.#go()
      } while (performance.now() < end)
      this.#frame = requestAnimationFrame(pass)
    }
    this.#frame = requestAnimationFrame(pass)
  }

  #outcomes(from: number, count: number): readonly (Outcome | null)[] {
    return this.#tasks.slice(from, from + count).map(({ key }) => this.#known[key] ?? null)
  }
  get #places(): number {
    return this.#project?.ownCard.starts.length ?? 0
  }
  /** By start place: has Bo solved it? null: not tried yet. */
  get solved(): readonly (boolean | null)[] {
    return this.#outcomes(0, this.#places).map((one) => one && one.solved)
  }
  /** By wrong answer: is it refused? null: not tried yet. */
  get refused(): readonly (boolean | null)[] {
    const { start, wrong = [] } = this.#project?.ownCard ?? {}
    const before = this.#places * (start ? 2 : 1)
    return this.#outcomes(before, wrong.length).map((one) => one && !one.reached)
  }
  /** Does what children begin with solve it somewhere? null: not tried yet. */
  get startSolves(): boolean | null {
    if (!this.#project?.ownCard.start) return true
    const all = this.#outcomes(this.#places, this.#places)
    if (all.some((one) => one?.reached)) return true
    return all.includes(null) || all.length === 0 ? null : false
  }
  get isTrying(): boolean {
    return this.#tasks.some(({ key }) => !(key in this.#known))
  }

  /** What keeps the card from being passed on: the first thing. */
  get lack(): Lack | null {
    if (!this.#project) return 'trying'
    const { ownCard, world } = this.#project
    const missing = lackOf(ownCard)
    if (missing) return missing
    if (!fitsWorld(ownCard, world)) return 'unfit'
    if (!this.#canRun(this.#project)) return 'blocks'
    if (this.solved.includes(false)) return 'unsolved'
    if (this.startSolves) return 'start'
    if (this.refused.includes(false)) return 'wrong'
    return this.isTrying ? 'trying' : null
  }

  close(): void {
    cancelAnimationFrame(this.#frame)
    clearTimeout(this.#timer)
  }
}
