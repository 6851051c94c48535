// Files with prose in the repository, now and, if they were deleted, as they were last committed.
import { execFileSync } from 'node:child_process'
import { existsSync, readFileSync } from 'node:fs'
import { house, inHouse } from '../prepare/house.mjs'
import { hasProse, passagesOf } from './passages.ts'

/** Generated files, and texts for children, which have their own checks. */
const isOurs = (path: string) => hasProse(path) && !/(^|\/)generated\/|^content\/|\/goldens\//.test(path)

const git = (cwd: string, ...args: string[]) =>
  execFileSync('git', args, { cwd, encoding: 'utf8', maxBuffer: 2 ** 28 })

/** All files with prose that git knows or would add, by path. */
export const proseFiles = (): string[] =>
  git(house, 'ls-files', '-z', '--cached', '--others', '--exclude-standard', '--deduplicate')
    .split('\0')
    .filter((path) => isOurs(path) && existsSync(inHouse(path)))

export const readFile = (path: string): string => readFileSync(inHouse(path), 'utf8')

/** The lines of a file's prose, without indentation. */
export const linesOf = (path: string, text: string): string[] =>
  passagesOf(path, text)
    .flatMap((passage) => passage.text.split('\n'))
    .map((line) => line.trim())
    .filter((line) => line !== '')

/** Last committed text of files that no longer exist; those of which git has no text are left out. */
export function lastTexts(paths: readonly string[], root = house): Map<string, string> {
  const texts = new Map<string, string>()
  for (const path of paths) {
    const commit = git(root, 'log', '-1', '--format=%H', '--diff-filter=AM', '--', path).trim()
    if (commit) texts.set(path, git(root, 'show', `${commit}:${path}`))
  }
  return texts
}
