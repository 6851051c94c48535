import type { Finding } from '@botgarten/blocks'
import type { Document } from '@botgarten/lab'
import { check, type Program } from '@botgarten/programs'

export const noProgram: Program = { stacks: [], config: { stacks: [] } }

/** What there is to mend in the programs of all robots. */
export class Findings {
  /** By the id of the robot. */
  #all = $state.raw<{ readonly [robot: string]: readonly Finding[] }>({})

  /** Looks everything through anew. */
  look({ programs, world }: Document): void {
    this.#all = Object.fromEntries(
      world.robots.map(({ id, program, config }) => [id, check(programs[program] ?? noProgram, config)]),
    )
  }

  of(robot: string): readonly Finding[] {
    return this.#all[robot] ?? []
  }

  /** The first robot whose program has to be mended before it can run. */
  stuck({ world }: Document): string | undefined {
    return world.robots.find(({ id }) => this.of(id).some(({ stops }) => stops))?.id
  }
}
