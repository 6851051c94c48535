import { createHash } from 'node:crypto'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { promised } from '@botgarten/browsers/promised'
import { fill } from '@botgarten/messages'
import { languagesIn, ownTableOf } from '@botgarten/messages/folder'

/** File of messages that the document itself shows, without the scripts of the lab. */
export const ofDocument = 'older'

/** `older.js` without comments and indentation. */
export const script = readFileSync(join(import.meta.dirname, 'older.js'), 'utf8')
  .replaceAll(/\/\*\*.*?\*\/|^\s*\/\/.*$/gm, '')
  .replaceAll(/\n\s*/g, '\n')
  .trim()

/** The source for `script-src` of the Content Security Policy that lets a browser run the script. */
export const scriptHash = `sha256-${createHash('sha256').update(script).digest('base64')}` as const

const box = 'margin:0;padding:16px;background:#fffdf8;color:#22303c;font:18px/1.5 sans-serif'
const button = 'min-height:44px;padding:0 16px;border:2px solid;border-radius:12px;font:inherit'
const paragraph = 'margin:0 0 12px;max-width:60em'

const escaped = (text: string) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;')

/** Messages of one language; null if it lacks one of them. */
function textsOf(language: string, keys: readonly string[]): readonly string[] | null {
  const messages = ownTableOf(ofDocument, language)
  const texts = keys.map((key) => {
    const message = messages[`${ofDocument}.${key}`]
    return message === undefined ? null : escaped(fill(message, promised, language))
  })
  return texts.every((text) => text !== null) ? texts : null
}

/** The same messages in every language that has them: the language of the user is not known yet. */
const paragraphs = (keys: readonly string[]): string =>
  languagesIn()
    .map((language) => ({ language, texts: textsOf(language, keys) }))
    .map(({ language, texts }) =>
      texts ? `<p lang="${language}" style="${paragraph}">${texts.join(' ')}</p>` : '',
    )
    .join('')

const closing = () =>
  languagesIn()
    .flatMap((language) => textsOf(language, ['close']) ?? [])
    .join(' / ')

const hidden = (id: string, keys: readonly string[]) =>
  `<div id="${id}" role="alert" style="${box}" hidden>${paragraphs(keys)}<button type="button" style="${button}">${closing()}</button></div>`

/** The HTML that a document shows if the browser is older than the promised ones, runs no scripts, or cannot load them. */
export const olderHtml = (): string =>
  [
    `<noscript><div style="${box}">${paragraphs(['noScript'])}</div></noscript>`,
    hidden('browser-old', ['title', 'text']),
    hidden('page-failed', ['broken']),
    `<script>${script}</script>`,
  ].join('')
