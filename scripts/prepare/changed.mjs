import { execFileSync } from 'node:child_process'
import { globSync, readFileSync } from 'node:fs'
import { house, inHouse } from './house.mjs'

/** @param {string[]} args */
const git = (...args) =>
  execFileSync('git', args, { cwd: house, encoding: 'utf8' }).split('\n').filter(Boolean)

/** Where this branch left main; the last commit on main itself. */
function base() {
  try {
    const [where] = git('merge-base', 'HEAD', 'main')
    return where
  } catch {
    return 'HEAD'
  }
}

/** Files that are not as they were on main, and are still there. */
export const changedFiles = (since = base()) => [
  ...new Set([
    ...git('diff', '--name-only', '--diff-filter=d', since),
    ...git('ls-files', '--others', '--exclude-standard'),
  ]),
]

/**
 * The room that a file is in: a feature, another folder of the web app, a package, `content`.
 * @param {string} file
 */
export const roomOf = (file) =>
  /^(?:apps\/web\/src\/features|apps\/web\/src|packages|apps)\/([\w-]+)\//.exec(file)?.[1] ??
  /^([\w-]+)\//.exec(file)?.[1] ??
  null

/**
 * Files with browser tests, each with the rooms that its first line names.
 * @returns {{ file: string, rooms: string[] }[]}
 */
export const specs = () =>
  globSync('e2e/tests/*.{spec,touch}.ts', { cwd: house })
    .map((file) => file.replaceAll('\\', '/'))
    .toSorted()
    .map((file) => {
      const [, rooms = ''] = /^\/\/ Rooms: (.+)/.exec(readFileSync(inHouse(file), 'utf8')) ?? []
      return { file, rooms: rooms.split(', ').filter(Boolean) }
    })

/**
 * Browser tests that have changed, and those of rooms in which something has.
 * @param {readonly string[]} changed
 */
export function specsOf(changed, all = specs()) {
  const rooms = new Set(changed.filter((file) => !file.endsWith('.test.ts')).map(roomOf))
  return all
    .filter(({ file, rooms: own }) => changed.includes(file) || own.some((room) => rooms.has(room)))
    .map(({ file }) => file)
}
