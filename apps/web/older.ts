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

const box = 'padding:16px;background:#fffdf8;color:#22303c;font:18px/1.5 sans-serif'
const button = 'min-height:44px;padding:0 16px;border:2px solid;border-radius:12px;font:inherit'

const escaped = (text: string) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;')

/** The message in every language that has it: the language of the user is not known yet. */
function messagesOf(key: string): readonly { readonly language: string; readonly text: string }[] {
  return languagesIn().flatMap((language) => {
    const message = ownTableOf(ofDocument, language)[`${ofDocument}.${key}`]
    return message === undefined ? [] : [{ language, text: escaped(fill(message, promised, language)) }]
  })
}

/**
 * The HTML that a document shows if the browser is older than the promised ones, runs no scripts, or cannot load them. Every stored
 * page has it, so that it is one message for all cases.
 */
export function olderHtml(): string {
  const paragraphs = messagesOf('text').map(({ language, text }) => `<p lang="${language}">${text}</p>`)
  const close = messagesOf('close').map(({ text }) => text)
  return [
    `<div id="older" role="alert" style="${box}" hidden>${paragraphs.join('')}`,
    `<button type="button" style="${button}">${close.join(' / ')}</button></div>`,
    '<noscript><style>#older{display:block}#older button{display:none}</style></noscript>',
    `<script>${script}</script>`,
  ].join('')
}
