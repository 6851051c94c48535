// Compares the packages that each workspace imports with the dependencies in its package.json.
import { globSync, readFileSync } from 'node:fs'
import { isBuiltin } from 'node:module'
import { join, posix } from 'node:path'
import ts from 'typescript'

export interface Manifest {
  readonly name: string
  readonly workspaces?: readonly string[]
  readonly dependencies?: { readonly [name: string]: string }
  readonly devDependencies?: { readonly [name: string]: string }
}

/** One import of a package. */
export interface Import {
  readonly from: string
  /** Erased before anything runs: `import type`. */
  readonly isType: boolean
}

export interface Workspace {
  /** Below the repository; '' for its root. */
  readonly folder: string
  readonly manifest: Manifest
  /** Paths below the repository. */
  readonly files: readonly string[]
}

const readManifest = (root: string, folder: string) =>
  JSON.parse(readFileSync(join(root, folder, 'package.json'), 'utf8')) as Manifest

const isLeftOut = (path: string) =>
  /(^|\/)(node_modules|generated|build|test-results|\.[^/]+)(\/|$)/.test(path.replaceAll('\\', '/'))

/** Every workspace with its code; a file belongs to the deepest workspace around it. */
export function workspacesIn(root: string): readonly Workspace[] {
  const patterns = readManifest(root, '').workspaces ?? []
  const folders = patterns
    .flatMap((pattern) => globSync(`${pattern}/package.json`, { cwd: root }))
    .map((path) => path.replaceAll('\\', '/').replace('/package.json', ''))
    .sort()
  const files = globSync('**/*.{ts,mjs,js,svelte,css}', { cwd: root, exclude: isLeftOut })
    .map((path) => path.replaceAll('\\', '/'))
    .sort()
  const ownerOf = (file: string) => folders.find((folder) => file.startsWith(`${folder}/`)) ?? ''
  const byFolder = Map.groupBy(files, ownerOf)
  return ['', ...folders].map((folder) => ({
    folder,
    manifest: readManifest(root, folder),
    files: byFolder.get(folder) ?? [],
  }))
}

/** `@sveltejs/kit` of `@sveltejs/kit/vite`; null for a file, a module of Node or an alias of the build. */
function packageOf(path: string, specifier: string): string | null {
  if (specifier.startsWith('.')) {
    // Scripts and browser tests run before anything is installed: for them a path is no dependency.
    if (!/^(packages|apps)\//.test(path)) return null
    const [, own] = /^packages\/([^/]+)\//.exec(posix.join(posix.dirname(path), specifier)) ?? []
    return own ? `@botgarten/${own}` : null
  }
  if (/^([/#$]|[\w-]+:)/.test(specifier) || isBuiltin(specifier)) return null
  return /^(@[^/]+\/)?[^/]+/.exec(specifier)?.[0] ?? null
}

/** The packages that a file imports, our own by their paths too. Components are read by their scripts and the `import()` of their markup. */
export function importsOf(path: string, text: string): readonly Import[] {
  const found = path.endsWith('.css') ? fontsIn(text) : importsIn(scriptOf(path, text))
  return found.flatMap(({ from, isType }) => {
    const name = packageOf(path, from)
    return name === null ? [] : [{ from: name, isType }]
  })
}

const fontsIn = (css: string): Import[] =>
  [...css.matchAll(/url\('([^']+)'\)/g)].map(([, from]) => ({ from: from!, isType: false }))

function scriptOf(path: string, text: string): string {
  if (!path.endsWith('.svelte')) return text
  const script = /<script[^>]*>(.*?)<\/script>/gs
  const scripts = [...text.matchAll(script)].map(([, code]) => code!)
  const inMarkup = text.replace(script, '').match(/\bimport\('[^']+'\)/g) ?? []
  return [...scripts, ...inMarkup].join('\n')
}

function importsIn(code: string): Import[] {
  const found: Import[] = []
  const visit = (node: ts.Node): void => {
    const one = importAt(node)
    if (one) found.push(one)
    ts.forEachChild(node, visit)
  }
  visit(ts.createSourceFile('file.ts', code, ts.ScriptTarget.Latest))
  return found
}

function importAt(node: ts.Node): Import | null {
  if (ts.isImportDeclaration(node) && ts.isStringLiteral(node.moduleSpecifier))
    return { from: node.moduleSpecifier.text, isType: node.importClause?.isTypeOnly ?? false }
  if (ts.isExportDeclaration(node) && node.moduleSpecifier && ts.isStringLiteral(node.moduleSpecifier))
    return { from: node.moduleSpecifier.text, isType: node.isTypeOnly }
  if (ts.isImportTypeNode(node) && ts.isLiteralTypeNode(node.argument))
    return { from: (node.argument.literal as ts.StringLiteral).text, isType: true }
  if (!ts.isCallExpression(node) || node.expression.kind !== ts.SyntaxKind.ImportKeyword) return null
  const [argument] = node.arguments
  return argument && ts.isStringLiteral(argument) ? { from: argument.text, isType: false } : null
}

/** Tools of every test, which the root has for all. */
const ofTheRoot = ['vitest', 'fast-check']
/** A tool that compiles itself into its output: the adapter leaves `dependencies` out of the bundle. */
const compiledIn = ['@sveltejs/kit']

/** Does a file belong to tests or to a build? Such code is no part of the product. */
export function isTool({ folder }: Workspace, file: string): boolean {
  if (!/^(packages|apps)\//.test(folder)) return true
  if (folder === 'apps/web' && !file.startsWith('apps/web/src/')) return true
  return /\.test\.ts$|\/(testing|contract)\/|\/test-bench\.ts$/.test(file)
}

/** Differences between a workspace's manifest and its code, one a line. */
export function unlike(workspace: Workspace, importsIn: (file: string) => readonly Import[]): string[] {
  const { folder, manifest, files } = workspace
  const { dependencies = {}, devDependencies = {} } = manifest
  const ofProduct = new Set<string>()
  const ofTools = new Set<string>()
  for (const file of files)
    for (const { from, isType } of importsIn(file)) {
      if (from === manifest.name || (folder !== '' && ofTheRoot.includes(from))) continue
      // Type imports of other packages are erased; those of our own packages count as dependencies.
      const isErased = isType && !from.startsWith('@botgarten/')
      ;(isTool(workspace, file) || isErased || compiledIn.includes(from) ? ofTools : ofProduct).add(from)
    }
  const hasTypes = (name: string) => `@types/${name}` in devDependencies
  const isOwn = (name: string) => name.startsWith('@botgarten/')
  return [
    ...[...ofProduct].filter((name) => !(name in dependencies)).map((name) => `needs ${name}`),
    ...Object.keys(dependencies)
      .filter((name) => !ofProduct.has(name))
      .map((name) => `does not import ${name}`),
    ...[...ofTools]
      .filter((name) => !ofProduct.has(name) && !(name in devDependencies) && !hasTypes(name))
      .map((name) => `needs ${name} for development`),
    // Of the packages of others, `npm run check:unused` finds those that no script and no configuration names.
    ...Object.keys(devDependencies)
      .filter((name) => (isOwn(name) && !ofTools.has(name)) || ofProduct.has(name))
      .map((name) => `does not need ${name} for development`),
  ].map((line) => `${folder || 'package.json'} ${line}`)
}
