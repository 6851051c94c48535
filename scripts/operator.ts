import { existsSync, readFileSync } from 'node:fs'
import { inHouse } from './prepare/house.mjs'
import { Trouble } from './prepare/run.mjs'

const mostLetters = 100_000

/**
 * What whoever runs this lab has written about themselves, for the page "about": the file that `BOTGARTEN_OPERATOR`
 * names, else `operator.md` in the folder of the product. Read once, at the start.
 * @returns Markdown; null where there is none, so that the empty file of the build answers
 * @throws {Trouble} that names the file and says what to do, where it is there or was named and cannot be read
 */
export function readOperator(env: NodeJS.ProcessEnv, usual = inHouse('operator.md')): string | null {
  const named = env['BOTGARTEN_OPERATOR']
  if (!named && !existsSync(usual)) return null
  try {
    return readFileSync(named || usual, 'utf8').slice(0, mostLetters)
  } catch (error) {
    throw new Trouble(sentenceFor(named, usual, (error as NodeJS.ErrnoException).code))
  }
}

function sentenceFor(named: string | undefined, usual: string, code = 'unknown error'): string {
  if (!named) return `${usual} cannot be read (${code}). Make it a file that may be read, or move it away.`
  const why = code === 'ENOENT' ? 'is not there' : `cannot be read (${code})`
  return `BOTGARTEN_OPERATOR names a file that ${why}: ${named}. Name another one, or leave BOTGARTEN_OPERATOR out.`
}
