import type { Finding } from '@botgarten/blocks'
import type { Document } from '@botgarten/lab'
import { check, stationsOf, type Program, type Project } from '@botgarten/programs'
import type { Change, LabEvent } from './change.ts'

export const noProgram: Program = { stacks: [], config: { stacks: [] } }

/** After these there may be something else to fix. */
const looksAnew: readonly Change['kind'][] = ['program', 'config', 'robots']

/** What there is to fix in the programs of all robots. */
export class Findings {
  /** By the id of the robot. */
  #all = $state.raw<{ readonly [robot: string]: readonly Finding[] }>({})
  readonly #document: () => Document
  readonly #maps: { readonly [id: string]: number }

  constructor(document: () => Document, project: Pick<Project, 'maps'>) {
    this.#document = document
    this.#maps = stationsOf(project)
    this.#look()
  }

  hear = (event: LabEvent): void => {
    if (event.kind === 'changed' && looksAnew.includes(event.change.kind)) this.#look()
  }

  #look(): void {
    const { programs, world } = this.#document()
    this.#all = Object.fromEntries(
      world.robots.map(({ id, program, config }) => [
        id,
        check(programs[program] ?? noProgram, { ...config, maps: this.#maps }),
      ]),
    )
  }

  of(robot: string): readonly Finding[] {
    return this.#all[robot] ?? []
  }

  /** The first robot whose program has to be fixed before it can run. */
  get stuck(): string | undefined {
    const { robots } = this.#document().world
    return robots.find(({ id }) => this.of(id).some(({ stops }) => stops))?.id
  }
}
