// `npm run words`: the types of all messages, languages and files of messages, from the folder content/words.
import { mkdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { sharesIn } from '@botgarten/messages/check'
import { typesOf } from '@botgarten/messages/facts'
import { languagesIn, tableOf } from '@botgarten/messages/folder'
import { filesOfScreens } from './words.ts'

const folder = join(import.meta.dirname, 'src/words/generated')
const files = filesOfScreens()
// Every language has its messages with the same facts: a test of packages/messages holds it.
const table = Object.fromEntries(files.flatMap((file) => Object.entries(tableOf(file, 'en'))))
const union = (names: readonly string[]) => names.map((name) => `'${name}'`).join(' | ')

mkdirSync(folder, { recursive: true })
writeFileSync(join(folder, 'messages.ts'), typesOf(table))
writeFileSync(
  join(folder, 'files.ts'),
  `export type Locale = ${union(languagesIn())}\nexport type WordsFile = ${union(files)}\n`,
)
for (const share of sharesIn()) console.log(share)
