import { posix } from 'node:path'
import { hashOf } from './tree.mjs'

/**
 * A module and its imports, as dependency-cruiser's JSON reporter lists them.
 * @typedef {{ source: string, dependencies: readonly { resolved: string }[] }} Module
 * @typedef {ReadonlyMap<string, readonly string[]>} Imports
 */

/** @param {readonly Module[]} modules @returns {Imports} paths relative to the repository */
export const importsOf = (modules) =>
  new Map(modules.map(({ source, dependencies }) => [source, dependencies.map(({ resolved }) => resolved)]))

/**
 * A file and everything that it imports, directly or not.
 * @param {Imports} imports
 * @param {string} file
 */
export function closureOf(imports, file) {
  const found = new Set([file])
  for (const one of found) for (const imported of imports.get(one) ?? []) found.add(imported)
  return found
}

const isContent = (path) => path.startsWith('content/')
/** `packages/lab`, `apps/web`, `e2e`: the folder that has a package.json of its own. */
const workspaceOf = (path) => /^(?:packages|apps)\/[^/]+/.exec(path)?.[0] ?? path.split('/')[0]
const starts = (...names) => names.flatMap((name) => [name, `node:${name}`])
const readers = starts('fs', 'fs/promises')
const starters = starts('child_process', 'worker_threads')

/** Every unit test depends on these. */
const everywhere = (path) =>
  /^(package-lock\.json|package\.json|tsconfig\.json|vitest\.config\.ts|scripts\/(testing|gate)\/)/.test(path)

/** Tests of the web app are compiled by its own configuration and read all words at their start. */
const ofWeb = (path) =>
  /^(NOTICE$|content\/words\/|apps\/web\/[^/]+$|apps\/web\/src\/words\/|packages\/(messages|content)\/[^/]*$)/.test(
    path,
  )

/**
 * Paths outside of its folder that a module names in its text: `'../../docs/study.md'`, relative to the repository. A bare `..`
 * may lead anywhere: '' stands for every file.
 * @param {string} module
 * @param {string} text
 * @returns {string[]}
 */
export function namedPaths(module, text) {
  if (/['"`]\.\.['"`]/.test(text)) return ['']
  const names = text.match(/(?<=['"`])(?:\.\.\/)+[\w@./-]*/g) ?? []
  return names
    .map((name) => posix.join(posix.dirname(module), name).replace(/\/$/, ''))
    .map((path) => (path === '.' || path.startsWith('..') ? '' : path))
}

/**
 * Which files decide how a test ends, beyond those that it imports. A test that reads files may read those of its own
 * workspace, of content/ and those that it or a module with file access names; one that starts processes or threads may run
 * any package.
 * @param {string} test
 * @param {ReadonlySet<string>} closure
 * @param {readonly string[]} named
 */
function readBy(test, closure, named) {
  const own = workspaceOf(test)
  const has = (names) => names.some((name) => closure.has(name))
  const isOwn = (path) => workspaceOf(path) === own
  const isTool = !/^(packages|apps|content)\//.test(test)
  const conditions = [everywhere]
  if (own === 'apps/web') conditions.push(ofWeb)
  if ([...closure].some((path) => path.startsWith('content:'))) conditions.push(isContent)
  if (isTool) conditions.push(() => true)
  if (has(readers)) conditions.push(isOwn, isContent)
  for (const name of named)
    conditions.push((path) => name === '' || path === name || path.startsWith(`${name}/`))
  if (has(starters)) conditions.push(isOwn, isContent, (path) => /^(packages|apps\/cli)\//.test(path))
  return (path) => conditions.some((holds) => holds(path))
}

/**
 * A hash of everything that decides how a unit test file ends: the same hash, the same outcome.
 * @param {{ tree: ReadonlyMap<string, string>, imports: Imports, textOf: (path: string) => string }} repository
 * @param {string} test
 */
export function keyOfTest({ tree, imports, textOf }, test) {
  const closure = closureOf(imports, test)
  const readsFiles = (path) => tree.has(path) && imports.get(path)?.some((one) => readers.includes(one))
  const named = [...closure].filter(readsFiles).flatMap((path) => namedPaths(path, textOf(path)))
  const isRead = readBy(test, closure, named)
  const parts = [...tree].filter(([path]) => closure.has(path) || isRead(path))
  return hashOf([`test ${test}`, ...parts.map(([path, hash]) => `${path} ${hash}`)])
}
