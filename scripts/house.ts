// How long files, functions and components are, now and at a commit: `npm run bench -- house` writes the table.
import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import ts from 'typescript'
import { house, inHouse } from './prepare/house.mjs'

export interface Source {
  readonly path: string
  readonly text: string
}

/** Of one part of the tree, without tests and what is generated. */
export interface Lengths {
  readonly files: readonly number[]
  readonly components: readonly number[]
  /** Of all functions with statements, callbacks among them. */
  readonly functions: readonly number[]
}

const git = (...args: string[]) =>
  execFileSync('git', args, { cwd: house, encoding: 'utf8', maxBuffer: 2 ** 28 })

const isCode = (path: string) => /\.(ts|svelte)$/.test(path) && !/\.test\.ts$|\/generated\//.test(path)

/** What git knows in a folder, as it lies there now. */
export const sourcesNow = (folder: string): Source[] =>
  git('ls-files', folder)
    .split('\n')
    .filter(isCode)
    .map((path) => ({ path, text: readFileSync(inHouse(path), 'utf8') }))

/** What a commit has in a folder. */
export const sourcesAt = (commit: string, folder: string): Source[] =>
  git('ls-tree', '-r', '--name-only', commit, folder)
    .split('\n')
    .filter(isCode)
    .map((path) => ({ path, text: git('show', `${commit}:${path}`) }))

export const isKnown = (commit: string): boolean => {
  try {
    git('cat-file', '-e', `${commit}^{commit}`)
    return true
  } catch {
    return false
  }
}

export function lengthsOf(sources: readonly Source[]): Lengths {
  const files = sources.map(({ text }) => linesOf(text))
  return {
    files,
    components: files.filter((_, index) => isComponent(sources[index]!)),
    functions: sources.flatMap(functionsOf),
  }
}

const isComponent = ({ path }: Source) => path.endsWith('.svelte')
const linesOf = (text: string) => text.trimEnd().split('\n').length

/** Lines of every function in a file, from its first word to its last brace. */
export function functionsOf(source: Source): number[] {
  const found: number[] = []
  for (const script of scriptsOf(source)) {
    const tree = ts.createSourceFile('script.ts', script, ts.ScriptTarget.Latest, true)
    const lineAt = (place: number) => tree.getLineAndCharacterOfPosition(place).line
    const visit = (node: ts.Node): void => {
      if (hasStatements(node)) found.push(lineAt(node.getEnd()) - lineAt(node.getStart(tree)) + 1)
      node.forEachChild(visit)
    }
    visit(tree)
  }
  return found
}

const hasStatements = (node: ts.Node) =>
  ts.isFunctionLike(node) && 'body' in node && node.body !== undefined && ts.isBlock(node.body)

/** A component's functions stand in its scripts. */
const scriptsOf = (source: Source) =>
  isComponent(source)
    ? [...source.text.matchAll(/<script[^>]*>(.*?)<\/script>/gs)].map(([, script]) => script!)
    : [source.text]
