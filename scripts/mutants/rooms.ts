/** A part of the code whose unit tests are asked. */
export interface Room {
  /** Folders and files with what is changed. */
  readonly code: readonly string[]
  /** The folders whose tests are asked, as far as they import the changed file. */
  readonly tests: readonly string[]
  /** Tests that walk folders: they find the changed file without importing it, and are asked each time. */
  readonly walking?: readonly string[]
  /** How much of what is tried has to be found, 0..1. */
  readonly goal: number
}

export const rooms: { readonly [name: string]: Room } = {
  storage: {
    code: ['apps/web/src/storage', 'apps/web/src/lab/autosave.svelte.ts'],
    tests: ['apps/web/src/storage', 'apps/web/src/lab'],
    goal: 0.9,
  },
  lab: { code: ['apps/web/src/lab'], tests: ['apps/web/src/lab'], goal: 0.8 },
  learning: {
    code: ['packages/learning'],
    tests: ['packages/learning'],
    walking: ['packages/learning/learners.test.ts'],
    goal: 0.8,
  },
  programs: { code: ['packages/programs'], tests: ['packages/programs'], goal: 0.8 },
  simulation: { code: ['packages/simulation'], tests: ['packages/simulation'], goal: 0.8 },
}
