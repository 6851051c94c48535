import { hasKnobs, knobsAtZero, onlyBegun } from '@botgarten/content/own-card'
import {
  cardColours,
  cardLanguages,
  languagesOf,
  mostOfCard,
  ownKinds,
  playedFrom,
  type Asked,
  type CardLanguage,
  type OwnCard,
  type OwnCardText,
  type OwnCheck,
  type OwnProgram,
  type Project,
} from '@botgarten/programs'
import type { Pose } from '@botgarten/simulation'
import { ProjectAutosave } from '#lab/autosave.svelte.ts'
import type { OpenedDraft } from './cards.ts'
import { Proof } from './proof.svelte.ts'

const noText: OwnCardText = { title: '', story: '', task: '', hints: ['', '', ''] }

/** A browser could take it for a tag; the card's reader refuses it. */
const plainText = (text: string) => text.replace(/<(?=\s*[a-z/!?])/gi, '‹')

/** One card that is being made: every change goes through here, is saved, and tried by Bo. */
export class CardMaker {
  readonly autosave: ProjectAutosave
  readonly proof: Proof
  readonly id: string
  readonly #opened: Project
  #card = $state.raw<OwnCard>(undefined as never)
  /** Index of the start place that is in hand. */
  chosen = $state(0)

  constructor({ id, revision, project, floor }: OpenedDraft) {
    this.id = id
    this.#opened = project
    this.#card = project.ownCard
    this.autosave = new ProjectAutosave(id, revision)
    this.proof = new Proof(floor)
    this.proof.follow(this.project)
  }

  get card() {
    return this.#card
  }
  /** In the language that is whole, else in the one that is begun. */
  get title(): string {
    const all = [...languagesOf(this.#card), ...cardLanguages]
    return (
      all.map((language) => this.#card.text[language]?.title ?? '').find((title) => title.trim() !== '') ?? ''
    )
  }
  get project(): Project & { readonly ownCard: OwnCard } {
    return { ...this.#opened, name: this.title || this.#opened.name, ownCard: this.#card }
  }
  get world() {
    return this.#opened.world
  }
  /** What children get; `whole`: with the solution, for colleagues. */
  played(whole = false): Project {
    return playedFrom(this.project, whole)
  }

  change(next: Partial<OwnCard>): void {
    this.#card = { ...this.#card, ...next }
    this.autosave.changed(() => this.project)
    this.proof.follow(this.project)
  }

  textIn(language: CardLanguage): OwnCardText {
    return this.#card.text[language] ?? noText
  }
  /** A language in which nothing is written is not there. */
  setText(language: CardLanguage, part: Partial<OwnCardText>): void {
    const before = this.textIn(language)
    const { title, story, task, hints } = { ...before, ...part }
    const [first, second, third] = hints
    const now: OwnCardText = {
      ...{ title: plainText(title), story: plainText(story), task: plainText(task) },
      hints: [plainText(first), plainText(second), plainText(third)],
    }
    const { [language]: _, ...others } = this.#card.text
    const isEmpty = [now.title, now.story, now.task, ...now.hints].every((text) => text === '')
    this.change({ text: isEmpty ? others : { ...others, [language]: now } })
  }
  setHint(language: CardLanguage, index: number, hint: string): void {
    const hints = this.textIn(language).hints.map((one, at) => (at === index ? hint : one))
    this.setText(language, { hints: hints as unknown as OwnCardText['hints'] })
  }

  setPlace(index: number, pose: Pose): void {
    const { width, height } = this.world.size
    const placed = {
      x: Math.min(width, Math.max(0, Math.round(pose.x))),
      y: Math.min(height, Math.max(0, Math.round(pose.y))),
      heading: ((Math.round(pose.heading) % 360) + 360) % 360,
    }
    this.change({ starts: this.#card.starts.map((one, at) => (at === index ? placed : one)) })
  }
  /** Where Bo stands in the project, or beside the place in hand. */
  addPlace(whereBoStands: boolean): void {
    const { starts } = this.#card
    if (starts.length >= mostOfCard.starts) return
    const { x, y, heading } = whereBoStands ? this.world.robots[0]!.pose : starts[this.chosen]!
    this.change({ starts: [...starts, { x, y, heading }] })
    this.chosen = starts.length
    this.setPlace(starts.length, whereBoStands ? { x, y, heading } : { x: x + 20, y: y + 20, heading })
  }
  removePlace(index: number): void {
    const { starts } = this.#card
    if (starts.length < 2) return
    this.chosen = Math.min(this.chosen, starts.length - 2)
    this.change({ starts: starts.filter((_, at) => at !== index) })
  }

  /** Kinds of checks for which the world has what they ask for. */
  get kinds(): readonly string[] {
    const { obstacles, robots } = this.world
    const sensors = Object.values(robots[0]!.config.sensors).map(({ kind }) => kind)
    const needsColour = ['led', 'speedOn', 'neverSees', 'says', 'silent', 'rests']
    return Object.entries(ownKinds).flatMap(([kind, { asks }]) => {
      if (Object.values(asks).includes('thing') && obstacles.length === 0) return []
      if (needsColour.includes(kind) && !sensors.includes('colour')) return []
      return ['sings', 'turnsBack'].includes(kind) && !sensors.includes('ultrasonic') ? [] : kind
    })
  }
  addCheck(kind: string): void {
    const { checks } = this.#card
    if (checks.length >= mostOfCard.checks) return
    const id = [kind, ...Array.from({ length: 9 }, (_, k) => `${kind}${k + 2}`)].find(
      (one) => !checks.some((check) => check.id === one),
    )!
    const { asks, lasts } = ownKinds[kind]!
    const numbers = Object.fromEntries(
      Object.entries(asks).map(([name, asked]) => [name, this.#preset(kind, name, asked)]),
    )
    this.change({ checks: [...checks, { id, kind, numbers, seconds: lasts ? 5 : 0 }] })
  }
  #preset(kind: string, name: string, asked: Asked): number | string {
    const { size, obstacles } = this.world
    if (typeof asked !== 'string') return presets[`${kind}.${name}`] ?? presets[name] ?? asked[0]
    const points = `${Math.round(size.width / 4)} ${Math.round(size.height / 2)}, ${Math.round((3 * size.width) / 4)} ${Math.round(size.height / 2)}`
    return {
      ...{ thing: obstacles[0]?.id ?? '', colour: cardColours[4], colours: cardColours[3], lamp: 'green' },
      ...{ check: '', x: Math.round(size.width / 2), y: Math.round(size.height / 2), points },
    }[asked]
  }
  setCheck(id: string, next: Partial<Pick<OwnCheck, 'numbers' | 'seconds'>>): void {
    this.change({ checks: this.#card.checks.map((one) => (one.id === id ? { ...one, ...next } : one)) })
  }
  /** What counted until it, or after it, counts all the time. */
  removeCheck(id: string): void {
    const others = this.#card.checks.filter((one) => one.id !== id)
    const freed = others.map((one): OwnCheck => {
      const numbers = Object.entries(one.numbers).map(([name, value]) => [
        name,
        value === id && ownKinds[one.kind]?.asks[name] === 'check' ? '' : value,
      ])
      return { ...one, numbers: Object.fromEntries(numbers) as OwnCheck['numbers'] }
    })
    this.change({ checks: freed })
  }

  /** Ways to begin that the solution has. */
  get beginnings(): readonly ('zero' | 'begun')[] {
    return hasKnobs(this.#opened) ? ['zero', 'begun'] : ['begun']
  }
  beginWith(beginning: 'zero' | 'begun' | OwnProgram): void {
    const start =
      beginning === 'zero'
        ? knobsAtZero(this.#opened)
        : beginning === 'begun'
          ? onlyBegun(this.#opened)
          : beginning
    this.change({ start })
  }
  /** How children begin: like which of the ways? null: with a program of another project. */
  get beginning(): 'zero' | 'begun' | null {
    const now = JSON.stringify(this.#card.start)
    if (now === JSON.stringify(knobsAtZero(this.#opened)) && hasKnobs(this.#opened)) return 'zero'
    return now === JSON.stringify(onlyBegun(this.#opened)) ? 'begun' : null
  }

  addWrong(name: string, program: OwnProgram): void {
    const wrong = this.#card.wrong ?? []
    if (wrong.length >= mostOfCard.wrong) return
    this.change({ wrong: [...wrong, { name: plainText(name).slice(0, mostOfCard.name), ...program }] })
  }
  removeWrong(index: number): void {
    this.change({ wrong: (this.#card.wrong ?? []).filter((_, at) => at !== index) })
  }

  close(): void {
    this.autosave.close()
    this.proof.close()
  }
}

/** Numbers to begin with, by kind and name, or by name. */
const presets: { readonly [name: string]: number } = {
  ...{ cm: 20, percent: 3, near: 60, far: 80, laps: 1, bumps: 0, least: 5, most: 50, light: 15, hertz: 150 },
  ...{ 'near.cm': 8, 'stays.cm': 8, 'cruises.cm': 300, 'turnsBack.near': 35, 'sings.near': 35 },
}
