import { createLab, type Document } from '@botgarten/lab'
import { paintFloor } from '@botgarten/simulation'
import { behaviours } from './programs.ts'
import { pushingWorld } from './worlds.ts'

export interface Run {
  readonly name: string
  readonly document: Document
  readonly seed: number
}

/** What a run of one minute came to. */
export interface Outcome {
  readonly name: string
  readonly hash: string
  /** The same minute again, from a moment in its middle on. */
  readonly restored: string
  /** Did it push something? */
  readonly pushed: boolean
  readonly problem: string | null
}

const minute = 60 * 60

/** Twenty programs: five behaviours in four worlds full of things to push, every other one with noise. */
export const runs: readonly Run[] = Object.entries(behaviours).flatMap(([name, behaviour]) =>
  [0, 1, 2, 3].map((k) => ({
    ...{ name: `${name} ${k}`, seed: 11 + k },
    document: { ...behaviour(k), world: pushingWorld(k) },
  })),
)

export function carryOut({ name, document, seed }: Run): Outcome {
  const lab = createLab()
  lab.load(document, paintFloor(document.world), { seed, checks: [] })
  lab.start()
  lab.advance(minute)
  const [hash, { obstacles, problem }] = [lab.hash(), lab.view()]
  lab.goTo(minute / 2 - 7)
  lab.resume()
  lab.advance(minute / 2 + 7)
  const pushed = document.world.obstacles.some(({ pose }, index) => pose.x !== obstacles[index]?.pose.x)
  return { name, hash, restored: lab.hash(), pushed, problem: problem?.problem ?? null }
}

export const names = runs.map(({ name }) => name)

/** Outcomes of the runs of these names. */
export const outcomes = (some: readonly string[]) =>
  runs.filter(({ name }) => some.includes(name)).map(carryOut)
