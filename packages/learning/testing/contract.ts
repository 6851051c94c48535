import { existsSync, readdirSync, statSync } from 'node:fs'
import { join } from 'node:path'
import type { AnyLearner } from '../learner.ts'

const root = join(import.meta.dirname, '..')

/** A short run that every learner has, so that what holds for all of them can be tried on it. */
export interface Example {
  readonly parameters: object
  readonly data: unknown
  /** How many steps show all that it does. */
  readonly steps: number
}

/** Folders beside the learners. */
const others = ['proof', 'testing', 'node_modules']

/** Every folder that has to be a learner. */
export const learnerFolders = (from = root): string[] =>
  readdirSync(from).filter((name) => !others.includes(name) && statSync(join(from, name)).isDirectory())

/** The files that a learner's folder lacks. */
export function missingIn(folder: string, from = root): string[] {
  const files = readdirSync(join(from, folder))
  const lacks = ['index.ts', 'model.md', 'testing/example.ts'].filter(
    (file) => !existsSync(join(from, folder, file)),
  )
  return [...lacks, ...(files.some((file) => file.endsWith('.test.ts')) ? [] : ['a test'])]
}

export async function learnerIn(folder: string): Promise<{ learner: AnyLearner; example: Example }> {
  const [{ learner }, { example }] = (await Promise.all([
    import(join(root, folder, 'index.ts')),
    import(join(root, folder, 'testing/example.ts')),
  ])) as [{ learner?: AnyLearner }, { example?: Example }]
  if (!learner) throw new Error(`${folder}/index.ts exports no learner.`)
  if (!example) throw new Error(`${folder}/testing/example.ts exports no example.`)
  return { learner, example }
}

/** The commands that learners lack: `botgarten learn <name>` for each. */
export const withoutCommand = (names: readonly string[], commands: object): string[] =>
  names.filter((name) => !Object.hasOwn(commands, name))
