// `npm run words`: the types of all messages, languages and files of messages, from the folder content/words.
import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { compile } from '@inlang/paraglide-js'
import { languagesIn } from '@botgarten/messages/folder'
import { filesOfScreens } from './words.ts'

const project = join(import.meta.dirname, 'project.inlang')
const outdir = join(import.meta.dirname, 'src/words/generated')

const files = filesOfScreens()
const languages = languagesIn()
const settings = {
  $schema: 'https://inlang.com/schema/project-settings',
  baseLocale: 'en',
  locales: languages,
  modules: ['../../node_modules/@inlang/plugin-message-format/dist/index.js'],
  'plugin.inlang.messageFormat': {
    pathPattern: files.map((file) => `../../content/words/{locale}/${file}.json`),
  },
}
mkdirSync(project, { recursive: true })
writeFileSync(join(project, 'settings.json'), JSON.stringify(settings, null, 2))

await compile({
  project,
  outdir,
  strategy: ['baseLocale'],
  outputStructure: 'locale-modules',
  emitTsDeclarations: true,
})

const union = (names: readonly string[]) => names.map((name) => `'${name}'`).join(' | ')
writeFileSync(
  join(outdir, 'files.ts'),
  `export type Locale = ${union(languages)}\nexport type WordsFile = ${union(files)}\n`,
)
// Paraglide leaves timers behind that would hold the process for half a minute.
process.exit()
