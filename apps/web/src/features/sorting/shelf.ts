import type { Project } from '@botgarten/programs'
import { placeOf } from '#content/cards.ts'
import { Keeper } from '#lab/keeper.svelte.ts'
import { readSetting, writeSetting } from '#storage/settings.ts'
import type { Kept } from './kept.ts'

/** Where a playground is kept. */
export interface Shelf {
  /** What lay there when it was opened; not to be trusted. */
  readonly kept: unknown
  keep(kept: () => Kept): void
  /** Saves what waits, now. */
  flush(): void
  /** Whose it is; null on the page that belongs to no project. */
  readonly owner: Owner | null
  close(): void
}

export interface Owner {
  /** The card, or `free`. */
  readonly place: string
  readonly id: string
  readonly keeper: Keeper
}

/** A project that is opened for sorting. */
export interface OpenedForSorting {
  readonly id: string
  readonly revision: number
  readonly project: Project
}

/** The page without a project: this device keeps what was done last. */
export const deviceShelf = (): Shelf => ({
  kept: readSetting<unknown>('sorting', null),
  keep: (kept) => writeSetting('sorting', kept()),
  flush: () => {},
  owner: null,
  close: () => {},
})

/** In the project's document: it goes wherever the project goes. */
export function projectShelf({ id, revision, project }: OpenedForSorting): Shelf {
  const keeper = new Keeper(id, revision)
  let { name } = project
  keeper.whenRenamed = (renamed) => (name = renamed)
  return {
    kept: project.sorting ?? null,
    keep: (kept) => keeper.changed(() => ({ ...project, name, sorting: kept() })),
    flush: () => void keeper.flush(),
    owner: { place: placeOf(project), id, keeper },
    close: () => keeper.close(),
  }
}
