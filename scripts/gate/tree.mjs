import { execFileSync } from 'node:child_process'
import { createHash } from 'node:crypto'
import { existsSync, readdirSync } from 'node:fs'
import { join } from 'node:path'
import { house as repoRoot } from '../prepare/house.mjs'

const mostBytes = 2 ** 28

/** @param {string[]} args @param {string} [input] */
const git = (args, input) =>
  execFileSync('git', args, { cwd: repoRoot, encoding: 'utf8', input, maxBuffer: mostBytes })
    .split('\0')
    .filter(Boolean)

/** Hashes of files as they are on disk, by `git hash-object`. @param {string[]} files */
function hashesOf(files) {
  if (files.length === 0) return []
  const input = `${files.join('\n')}\n`
  return execFileSync('git', ['hash-object', '--stdin-paths'], { cwd: repoRoot, encoding: 'utf8', input })
    .trim()
    .split('\n')
}

/**
 * Every file of the working tree that git does not ignore, with a hash of its content. Paths use forward slashes and are
 * relative to the repository. Null without git, as in an unpacked archive.
 * @returns {Map<string, string> | null}
 */
export function readTree() {
  try {
    const staged = git(['ls-files', '--stage', '-z']).map((row) => {
      const [, hash = '', path = ''] = /^\d+ ([0-9a-f]+) \d+\t(.*)$/s.exec(row) ?? []
      return [path, hash]
    })
    const tree = new Map(staged)
    const touched = [
      ...git(['diff', '--name-only', '-z']),
      ...git(['ls-files', '--others', '--exclude-standard', '-z']),
    ]
    for (const path of touched) if (!existsSync(`${repoRoot}/${path}`)) tree.delete(path)
    const there = [...new Set(touched)].filter((path) => existsSync(`${repoRoot}/${path}`))
    const hashes = hashesOf(there)
    there.forEach((path, index) => tree.set(path, hashes[index]))
    return tree
  } catch {
    return null
  }
}

/** One hash over names and texts, in any order. @param {Iterable<string>} parts */
export function hashOf(parts) {
  const hash = createHash('sha256')
  for (const part of [...parts].sort()) hash.update(part).update('\0')
  return hash.digest('hex')
}

/**
 * One hash over all files of a tree for which `isPart` holds.
 * @param {ReadonlyMap<string, string>} tree
 * @param {(path: string) => boolean} [isPart]
 */
export const hashOfTree = (tree, isPart = () => true) =>
  hashOf([...tree].filter(([path]) => isPart(path)).map(([path, hash]) => `${path} ${hash}`))

/**
 * Files below a folder by the end of their names, sorted; paths relative to the repository, with forward slashes.
 * @param {string} folder
 * @param {...string} ends
 */
export function listFiles(folder, ...ends) {
  const isListed = (path) => ends.some((end) => path.endsWith(end)) && !path.includes('node_modules/')
  return readdirSync(join(repoRoot, folder), { recursive: true, encoding: 'utf8' })
    .map((path) => `${folder}/${path.replaceAll('\\', '/')}`)
    .filter(isListed)
    .sort()
}

const testFolders = ['packages', 'content', 'apps/cli', 'apps/web/src', 'scripts', 'e2e', 'benchmarks']

/** All files with unit tests. Those whose name ends in `.slow.test.ts` take over 5 s: `npm run test:full` runs them. */
export const listUnitTests = () => testFolders.flatMap((folder) => listFiles(folder, '.test.ts'))

/** @param {string} file */
export const isSlow = (file) => file.endsWith('.slow.test.ts')
