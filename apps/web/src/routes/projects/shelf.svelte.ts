import { placeOf } from '#lib/content/cards.ts'
import { listBin, takeBack, throwAway } from '#lib/storage/bin.ts'
import { watchTabs } from '#lib/storage/channel.ts'
import { keepsAnything, type Kept } from '#lib/storage/database.ts'
import type { Merged } from '#lib/storage/files.ts'
import { nameOfCopy } from '#lib/storage/copy-name.ts'
import { freshId, list, rename, save } from '#lib/storage/projects.ts'
import { wordsOfRefusal } from '#lib/storage/refusal.ts'
import * as m from '#lib/words/generated/messages.js'
import type { Project } from '@botgarten/programs'
import { shownName } from '#lib/content/names.ts'

/** What is said after a deed, and how it is taken back. */
interface Said {
  readonly text: string
  readonly takeBack?: () => Promise<void>
}

/** What is told in a dialog. */
interface Told {
  readonly title: string
  readonly text: string
  readonly good: boolean
}

/** All projects of this device in a child's hands. */
export class Shelf {
  #all = $state.raw<readonly Kept[] | null>(null)
  #binned = $state(0)
  #keeps = $state(true)
  #open = $state.raw<readonly string[]>([])
  #said = $state.raw<Said | null>(null)
  #told = $state.raw<Told | null>(null)

  /** null until they have been read. */
  get all() {
    return this.#all
  }
  get binned() {
    return this.#binned
  }
  /** Does this browser keep anything? */
  get keeps() {
    return this.#keeps
  }
  get said() {
    return this.#said
  }
  get told() {
    return this.#told
  }

  isOpenElsewhere = (id: string): boolean => this.#open.includes(id)

  /** Begins to listen to other tabs. Returns how to end it. */
  watch(): () => void {
    void this.look()
    return watchTabs({
      open: (id) => (this.#open = [...this.#open, id]),
      closed: (id) => (this.#open = this.#open.filter((other) => other !== id)),
      changed: () => void this.look(),
    })
  }

  async look(): Promise<void> {
    const [all, bin, keeps] = await Promise.all([list(), listBin(), keepsAnything()])
    this.#all = all
    this.#binned = bin.length
    this.#keeps = keeps
  }

  hush(): void {
    this.#said = null
    this.#told = null
  }

  async #did(outcome: { readonly kind: string }, said: Said): Promise<void> {
    await this.look()
    if (outcome.kind === 'full' || outcome.kind === 'refused') this.#refuse('notKept')
    else this.#said = outcome.kind === 'gone' ? { text: m['projects.gone']() } : said
  }

  #refuse(...problem: Parameters<typeof wordsOfRefusal>): void {
    this.#told = { ...wordsOfRefusal(...problem), good: false }
  }

  async rename({ id }: Kept, name: string): Promise<void> {
    await this.#did(await rename(id, name), { text: m['projects.renamed']({ name }) })
  }

  async duplicate(one: Kept): Promise<void> {
    const name = nameOfCopy(shownName(one), (this.#all ?? []).map(shownName))
    const outcome = await save(freshId(placeOf(one.project)), { ...one.project, name }, 0)
    await this.#did(outcome, { text: m['projects.doubled']({ name }) })
  }

  async throwAway(one: Kept): Promise<void> {
    const name = shownName(one)
    const outcome = await throwAway(one.id)
    const back = async () => {
      if (outcome.kind === 'moved')
        await this.#did(await takeBack(outcome.id), { text: m['projects.back']({ name }) })
    }
    await this.#did(outcome, { text: m['projects.thrown']({ name }), takeBack: back })
  }

  /** Takes a file up. Returns the project where it holds one; a home file is told about here. */
  async openFile(file: File): Promise<{ readonly id: string; readonly project: Project } | null> {
    const { openProjectFile } = await import('#lib/storage/later.ts')
    const outcome = await openProjectFile(file)
    if ('problem' in outcome) this.#refuse(outcome.problem, outcome.facts)
    else if ('merged' in outcome) this.tellMerged(outcome.merged)
    else return outcome
    await this.look()
    return null
  }

  /** Says what became of a home file. */
  tellMerged(merged: Merged | undefined): void {
    if (!merged) return
    const { added, copies, same, binned, broken, settings } = merged
    const text = [
      m['projects.merged']({ added, same }),
      ...(copies > 0 ? [m['projects.mergedCopies']({ copies })] : []),
      ...(binned > 0 ? [m['projects.mergedBin']({ binned })] : []),
      ...(settings.taken ? [m['projects.mergedSettings']()] : []),
      ...(settings.kept ? [m['projects.keptSettings']()] : []),
      ...(settings.sorted ? [m['projects.keptSorting']()] : []),
      ...(broken > 0 ? [m['projects.mergedBroken']({ broken })] : []),
    ].join(' ')
    this.#told = { title: m['projects.mergedTitle'](), text, good: broken === 0 }
  }

  async takeHome(): Promise<void> {
    const { saveHomeFile } = await import('#lib/storage/later.ts')
    if (!(await saveHomeFile())) this.#refuse('nothingToTake')
  }
}
