import { existsSync, readFileSync } from 'node:fs'
import { inHouse } from './prepare/house.mjs'

const mostLetters = 100_000

/**
 * What whoever runs this lab has written about themselves, for the page "about": the file that `BOTGARTEN_OPERATOR`
 * names, else `operator.md` in the folder of the product. Read once, at the start.
 * @returns Markdown; null where there is none, so that the empty file of the build answers
 * @throws {Error} that names the file, where one was named and cannot be read
 */
export function readOperator(env: NodeJS.ProcessEnv, usual = inHouse('operator.md')): string | null {
  const named = env['BOTGARTEN_OPERATOR']
  if (!named && !existsSync(usual)) return null
  try {
    return readFileSync(named || usual, 'utf8').slice(0, mostLetters)
  } catch (cause) {
    throw new Error(`What stands about the operator cannot be read: ${named ?? usual}`, { cause })
  }
}
