import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { house as repoRoot, inHouse as inRepo } from '../prepare/house.mjs'
import { runtime } from '../prepare/runtime.mjs'
import { importsOf, keyOfTest } from './graph.mjs'
import { hashOf, hashOfTree, readTree } from './tree.mjs'

const folders = ['packages', 'apps', 'content', 'e2e', 'benchmarks', 'scripts']
const cache = join('node_modules', '.cache', 'arrows')

/** The imports of every module of the repository, read by dependency-cruiser. */
function readImports() {
  const bin = inRepo('node_modules', 'dependency-cruiser', 'bin', 'dependency-cruiser.mjs')
  const args = [bin, ...folders, '--output-type', 'json', '--cache', cache]
  const options = { cwd: repoRoot, encoding: 'utf8', maxBuffer: 2 ** 28 }
  return importsOf(JSON.parse(execFileSync(runtime(), args, options)).modules)
}

const isDocument = (path) => /^(benchmarks|docs)\/|^[^/]+\.md$/.test(path)
const isUnitTest = (path) => path.endsWith('.test.ts')
const isSpec = (path) => /^e2e\/.*\.(spec|touch|walk)\.ts$/.test(path)

/**
 * Keys of steps and test files: a key is a hash of everything that decides how it ends. `whole` is a hash of all files. No key is
 * given where there is no git.
 */
export function readKeys() {
  const tree = readTree()
  if (tree === null) return { whole: '', ofStep: () => null, ofTest: () => null, ofSpec: () => () => null }
  const imports = readImports()
  const textOf = (path) => readFileSync(inRepo(path), 'utf8')
  const whole = hashOfTree(tree)
  // Browser tests see the whole product, so that any file of it may decide.
  const product = hashOfTree(tree, (path) => !isDocument(path) && !isUnitTest(path) && !isSpec(path))
  return {
    whole,
    /** @param {string} name */
    ofStep: (name) => hashOf([`step ${name}`, whole]),
    /** @param {string} file */
    ofTest: (file) => keyOfTest({ tree, imports, textOf }, file),
    /**
     * @param {string} [mode] a further condition that decides, such as the sample
     * @returns {(file: string) => string}
     */
    ofSpec:
      (mode = '') =>
      (file) =>
        hashOf([`spec ${file}`, `mode ${mode}`, tree.get(file) ?? '', product]),
  }
}
