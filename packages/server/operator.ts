import { existsSync, readFileSync } from 'node:fs'
import { inRepository } from './repository.ts'
import { CannotServe, causeIn } from './problem.ts'

const mostLetters = 100_000

/**
 * What whoever runs this lab has written about themselves, for the page "about": the file that `BOTGARTEN_OPERATOR`
 * names, else `operator.md` in the folder of the product. Read once, at the start.
 * @returns Markdown; null where there is none, so that the empty file of the build answers
 * @throws {CannotServe} that names the file, where it is there or was named and cannot be read
 */
export function readOperator(env: NodeJS.ProcessEnv, usual = inRepository('operator.md')): string | null {
  const named = env['BOTGARTEN_OPERATOR']
  if (!named && !existsSync(usual)) return null
  try {
    return readFileSync(named || usual, 'utf8').slice(0, mostLetters)
  } catch (error) {
    const why = causeIn(error)
    throw named
      ? new CannotServe('namedOperator', { path: named, why })
      : new CannotServe('usualOperator', { path: usual, why })
  }
}
