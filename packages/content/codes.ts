import { readFileSync } from 'node:fs'
import { join } from 'node:path'

export type CodeLanguage = 'de' | 'en'

const read = (language: CodeLanguage): readonly string[] =>
  readFileSync(join(import.meta.dirname, `../../content/codes/${language}.txt`), 'utf8')
    .trim()
    .split('\n')

const lists: { [language in CodeLanguage]?: readonly string[] } = {}

/** The 1,024 words that codes of classes are made of. Each is known by its first four letters. */
export const codeWords = (language: CodeLanguage): readonly string[] => (lists[language] ??= read(language))
