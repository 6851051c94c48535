// `npm run paraglide`: compiles the messages that change with a number with Paraglide, which is installed into a temporary
// folder (about a minute), and writes the sentences that the test of packages/messages compares with.
// `--check` writes nothing and fails where the committed sentences differ: a release runs it.
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import type { Table } from '../packages/messages/index.ts'
import { completeLanguages } from '../packages/messages/folder.ts'
import {
  casesOf,
  changingIn,
  fingerprintOf,
  referenceFile,
  type Reference,
} from '../packages/messages/testing/paraglide.ts'
import { asScript, npmAside, Trouble } from './prepare/run.mjs'

const compiler = '@inlang/paraglide-js'
const plugin = '@inlang/plugin-message-format'
const madeBy = { [compiler]: '2.25.4', [plugin]: '4.4.4' }

type Compiled = {
  readonly [key: string]: (facts: object, options: { readonly locale: string }) => string
}

async function install(folder: string): Promise<void> {
  writeFileSync(join(folder, 'package.json'), JSON.stringify({ private: true, dependencies: madeBy }))
  const { code, said } = await npmAside(['install', '--ignore-scripts', '--no-audit', '--no-fund'], {
    cwd: folder,
  })
  if (code !== 0) throw new Trouble(`npm could not install Paraglide:\n${said}`)
}

/** The functions that Paraglide compiles of tables of messages, by language. */
async function compile(folder: string, tables: { readonly [locale: string]: Table }): Promise<Compiled> {
  for (const [locale, table] of Object.entries(tables))
    writeFileSync(join(folder, `${locale}.json`), JSON.stringify(table))
  const project = join(folder, 'project.inlang')
  mkdirSync(project)
  writeFileSync(
    join(project, 'settings.json'),
    JSON.stringify({
      baseLocale: 'en',
      locales: Object.keys(tables),
      modules: [`./node_modules/${plugin}/dist/index.js`],
      'plugin.inlang.messageFormat': { pathPattern: './{locale}.json' },
    }),
  )
  const library = (await import(join(folder, `node_modules/${compiler}/dist/index.js`))) as {
    compile(options: object): Promise<unknown>
  }
  const outdir = join(folder, 'compiled')
  await library.compile({ project, outdir, strategy: ['baseLocale'] })
  writeFileSync(join(outdir, 'package.json'), '{ "type": "module" }')
  return (await import(join(outdir, 'messages/_index.js'))) as Compiled
}

function sentencesOf(locale: string, table: Table, compiled: Compiled): Reference['sentences'][string] {
  const entries = Object.entries(table).map(([key, message]) => {
    const sentences = casesOf(message).map((facts) => compiled[key]!(facts, { locale }))
    return [key, [fingerprintOf(message), ...sentences]] as const
  })
  return Object.fromEntries(entries)
}

/** One line a message, so that a difference names it. */
function asText({ madeBy, sentences }: Reference): string {
  const languages = Object.entries(sentences).map(([locale, byKey]) => {
    const lines = Object.entries(byKey).map(([key, row]) => `${JSON.stringify(key)}: ${JSON.stringify(row)}`)
    return `${JSON.stringify(locale)}: {\n${lines.join(',\n')}\n}`
  })
  return `{\n"madeBy": ${JSON.stringify(madeBy)},\n"sentences": {\n${languages.join(',\n')}\n}\n}\n`
}

async function freshReference(folder: string): Promise<string> {
  await install(folder)
  const tables = Object.fromEntries(completeLanguages.map((locale) => [locale, changingIn(locale)]))
  const compiled = await compile(folder, tables)
  const sentences = Object.entries(tables).map(([locale, table]) => [
    locale,
    sentencesOf(locale, table, compiled),
  ])
  return asText({ madeBy, sentences: Object.fromEntries(sentences) as Reference['sentences'] })
}

await asScript(async () => {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-paraglide-'))
  try {
    const fresh = await freshReference(folder)
    if (!process.argv.includes('--check')) writeFileSync(referenceFile, fresh)
    else if (readFileSync(referenceFile, 'utf8') !== fresh)
      throw new Trouble('Paraglide compiles other sentences than the committed ones: run npm run paraglide.')
    return 0
  } finally {
    rmSync(folder, { recursive: true, force: true })
  }
})
