import { placeOf } from '#content/cards.ts'
import { listBin, takeBack, throwAway } from '#storage/bin.ts'
import { watchTabs } from '#storage/channel.ts'
import { keepsAnything } from '#storage/database.ts'
import type { HomeFile, Merged } from '#storage/files.ts'
import { saveRaw } from '#storage/handout.ts'
import { nameOfCopy, wordsOfRefusal } from '#storage/messages.ts'
import { freshId, list, load, open, rename, save, type Listed } from '#storage/projects.ts'
import type { Damaged } from '#storage/records.ts'
import { m } from '#words/message.ts'
import type { Project } from '@botgarten/programs'
import { shownName } from '#content/names.ts'

/** What is said after a action, and how it is taken back. */
interface Said {
  readonly text: string
  readonly takeBack?: () => Promise<void>
}

/** What is told in a dialog. */
interface Told {
  readonly title: string
  readonly text: string
  readonly good: boolean
  /** Files that wait to be saved, each by a press of its own: browsers stop pages that save several at once. */
  readonly files?: readonly HomeFile[]
}

/** All projects of this device in a child's hands. */
export class ProjectList {
  #all = $state.raw<readonly Listed[] | null>(null)
  #damaged = $state.raw<readonly Damaged[]>([])
  #binned = $state(0)
  #keeps = $state(true)
  #open = $state.raw<readonly string[]>([])
  #said = $state.raw<Said | null>(null)
  #told = $state.raw<Told | null>(null)

  /** null until they have been read. */
  get all() {
    return this.#all
  }
  /** What of them cannot be read. */
  get damaged() {
    return this.#damaged
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
    this.#all = all.projects
    this.#damaged = all.damaged
    this.#binned = bin.thrown.length + bin.damaged.length
    this.#keeps = keeps
  }

  hush(): void {
    this.#said = null
    this.#told = null
  }

  async #did(outcome: { readonly kind: string }, said: Said): Promise<void> {
    await this.look()
    if (outcome.kind === 'gone') this.#said = { text: m['projects.gone']() }
    else if (outcome.kind === 'saved' || outcome.kind === 'moved') this.#said = said
    else this.#refuse(outcome.kind === 'tooMuch' ? 'tooMuch' : 'notKept')
  }

  #refuse(...problem: Parameters<typeof wordsOfRefusal>): void {
    this.#told = { ...wordsOfRefusal(...problem), good: false }
  }

  async rename({ id }: Listed, name: string): Promise<void> {
    await this.#did(await rename(id, name), { text: m['projects.renamed']({ name }) })
  }

  /** A project of the list with its pictures, under the name it bears there; says so where it cannot be read. */
  async whole(one: Listed): Promise<Project | null> {
    const kept = await open(one.id)
    if (!kept) {
      await this.look()
      this.#refuse('damaged')
      return null
    }
    return { ...kept.project, name: shownName(one) }
  }

  async duplicate(one: Listed): Promise<void> {
    const project = await this.whole(one)
    if (!project) return
    const name = nameOfCopy(shownName(one), (this.#all ?? []).map(shownName))
    const outcome = await save(freshId(placeOf(one.project)), { ...project, name }, 0)
    await this.#did(outcome, { text: m['projects.doubled']({ name }) })
  }

  throwAway(one: Listed): Promise<void> {
    return this.#throwAway(one.id, shownName(one))
  }

  throwDamaged({ id, name }: Damaged): Promise<void> {
    return this.#throwAway(id, name ?? m['projects.damaged']())
  }

  /** Hands out all that lies there of a project that cannot be read. */
  async saveDamaged({ id, name, raw }: Damaged): Promise<void> {
    saveRaw(name ?? m['projects.damaged'](), (await load(id))?.project ?? raw)
  }

  async #throwAway(id: string, name: string): Promise<void> {
    const outcome = await throwAway(id)
    const back = async () => {
      if (outcome.kind === 'moved')
        await this.#did(await takeBack(outcome.id), { text: m['projects.back']({ name }) })
    }
    await this.#did(outcome, { text: m['projects.thrown']({ name }), takeBack: back })
  }

  /** Takes a file up. Returns the project where it holds one; a home file is told about here. */
  async openFile(
    file: File,
  ): Promise<{ readonly id: string; readonly project: Project; readonly lost?: boolean } | null> {
    const { openProjectFile } = await import('#storage/files.ts')
    const outcome = await openProjectFile(file)
    if ('problem' in outcome) this.#refuse(outcome.problem, outcome.facts)
    else if (!('merged' in outcome)) return outcome
    // The dialog counts the new projects, so the list shows them first.
    await this.look()
    if ('merged' in outcome) this.tellMerged(outcome.merged)
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
      ...(broken > 0 ? [m['projects.mergedBroken']({ broken })] : []),
    ].join(' ')
    this.#told = { title: m['projects.mergedTitle'](), text, good: broken === 0 }
  }

  async takeHome(): Promise<void> {
    const { homeFiles } = await import('#storage/files.ts')
    const files = await homeFiles()
    if (files.length === 0) return this.#refuse('nothingToTake')
    if (files.length === 1) return files[0]!.save()
    const title = m['projects.manyFiles']({ count: files.length })
    this.#told = { title, text: m['projects.manyFilesText'](), good: true, files }
  }
}
