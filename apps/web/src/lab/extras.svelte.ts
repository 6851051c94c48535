import type { Document } from '@botgarten/lab'
import type { Learned, Progress, Project } from '@botgarten/programs'
import type { Change } from './change.ts'
import { ownPictureIn } from './opening.ts'

/** What a project holds besides what runs: its name, its pictures, what was learned, which blocks are offered. */
export class Extras {
  readonly #opened: Project
  name = $state('')
  #learned: NonNullable<Project['q']>
  #shelf = $state.raw<Project['shelf']>()
  /** Pictures of floors, those of steps that can be taken back too. */
  pictures = $state.raw<Project['assets']>({})

  constructor(opened: Project) {
    this.#opened = opened
    this.name = opened.name
    this.#learned = opened.q ?? {}
    this.#shelf = opened.shelf
    this.pictures = opened.assets
  }

  get shelf() {
    return this.#shelf
  }

  learnedBy(program: string): Learned | undefined {
    return this.#learned[program]
  }

  /** Takes over what is no part of the running lab. */
  take(change: Change & { readonly kind: 'learned' | 'shelf' }): void {
    if (change.kind === 'shelf') this.#shelf = change.after
    else this.#learned = { ...this.#learned, [change.program]: change.after }
  }

  addPictures(pictures: Project['assets'] = {}): void {
    this.pictures = { ...this.pictures, ...pictures }
  }

  /** The project as it stands now: what is kept and what a file holds. */
  projectOf(
    { programs, world, brains, tables }: Document,
    progress: Progress,
    effort: Project['effort'],
  ): Project {
    const assets = ownPictureIn(world.floor, this.pictures)
    const learned = Object.keys(this.#learned).length > 0 && { q: this.#learned }
    const shelf = this.#shelf && { shelf: this.#shelf }
    const parts = {
      programs,
      world,
      brains,
      ...(tables && { tables }),
      ...(effort && { effort }),
      progress,
      assets,
    }
    return { ...this.#opened, name: this.name, ...parts, ...learned, ...shelf }
  }
}
