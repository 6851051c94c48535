/// <reference types="@botgarten/content/page" />

declare module 'content:words' {
  import type { Table } from '@botgarten/messages'
  import type { Locale, WordsFile } from '#words/generated/files.ts'
  /** A folder of `content/words` each, in the order of their names. */
  export const languages: readonly Locale[]
  /** What each is called in itself. */
  export const names: { readonly [locale in Locale]: string }
  /** Its files, and Blockly's own words. */
  export const files: {
    readonly [locale in Locale]: {
      readonly [file in WordsFile | 'blockly']: () => Promise<{ readonly default: Table }>
    }
  }
}

declare module 'content:examples' {
  import type { Template } from '@botgarten/blocks'
  export default function examples(): Promise<{ readonly [type: string]: readonly Template[] | undefined }>
}
