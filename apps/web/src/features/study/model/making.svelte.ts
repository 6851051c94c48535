import { writePlan, type StudyPlan } from '@botgarten/experiments/study'
import { allCards } from '#content/cards.ts'
import { message } from '#words/message.ts'

type Module = StudyPlan['modules'][number]
type Draft = { -readonly [Name in keyof StudyPlan]: StudyPlan[Name] }

/** The ways of learning a module may begin with: the first cards of each bed. */
const beds = ['network', 'q-learning', 'sorting'] as const
const firstCards = 3

const moduleOf = (bed: string): Module => ({
  id: bed,
  title: message(`study.bed.${bed}`),
  cards: allCards
    .filter((card) => card.bed === bed)
    .slice(0, firstCards)
    .map(({ id }) => id),
})

const randomSeed = () => crypto.getRandomValues(new Uint32Array(1))[0]! % 1_000_000

/** A name that can stand in a file, from a title: letters, digits and hyphens. */
const idFrom = (title: string): string =>
  title
    .normalize('NFKD')
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '')
    .slice(0, 40) || 'study'

/** A study that is being planned. */
export class Making {
  readonly draft = $state<Draft>({
    ...{ botgarten: 'study', version: 1, id: 'study', title: '', seed: randomSeed(), groups: 6, children: 5 },
    ...{ modules: beds.map(moduleOf), order: 'balanced', level: null, maps: null, log: true, word: '' },
  })

  /** The study as it would be kept; null while something is missing. */
  readonly plan = $derived.by((): StudyPlan | null => {
    const plan = { ...$state.snapshot(this.draft), id: idFrom(this.draft.title) } as StudyPlan
    try {
      writePlan(plan)
      return plan
    } catch {
      return null
    }
  })

  toggle(module: number, card: string): void {
    const { cards } = this.draft.modules[module]!
    const next = cards.includes(card) ? cards.filter((one) => one !== card) : [...cards, card]
    this.#change(module, { cards: next })
  }

  rename(module: number, title: string): void {
    this.#change(module, { title })
  }

  #change(at: number, change: Partial<Module>): void {
    this.draft.modules = this.draft.modules.map((one, index) => (index === at ? { ...one, ...change } : one))
  }

  add(): void {
    const ids = this.draft.modules.map(({ id }) => id)
    const number = ids.length + 1
    const id = ids.includes(`module-${number}`) ? `module-${number}-${randomSeed()}` : `module-${number}`
    this.draft.modules = [
      ...this.draft.modules,
      { id, title: message('study.newModule', { number }), cards: ['free'] },
    ]
  }

  remove(module: number): void {
    this.draft.modules = this.draft.modules.toSpliced(module, 1)
  }

  toggleMap(map: string, all: readonly string[]): void {
    const maps = this.draft.maps ?? all
    this.draft.maps = maps.includes(map) ? maps.filter((one) => one !== map) : [...maps, map]
    if (this.draft.maps.length === all.length) this.draft.maps = null
  }
}
