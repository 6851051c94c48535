declare module '*.md' {
  import type { CardText } from '@botgarten/materials'
  const text: CardText
  export default text
}

declare module 'content:words' {
  import type { Table } from '@botgarten/messages'
  import type { Locale, WordsFile } from '#words/generated/files.ts'
  /** A folder of `content/words` each, in the order of their names. */
  export const languages: readonly Locale[]
  /** Its files, and Blockly's own words. */
  export const files: {
    readonly [locale in Locale]: {
      readonly [file in WordsFile | 'blockly']: () => Promise<{ readonly default: Table }>
    }
  }
}

declare module 'content:materials/heads' {
  import type { Item } from '@botgarten/materials/items'
  import type { Question } from '@botgarten/materials/questions'
  /** `number`: of the item's folder, among those of its kind. */
  type NumberedItem = Item & { readonly number: number }
  const heads: { readonly items: readonly NumberedItem[]; readonly questions: readonly Question[] }
  export default heads
}

declare module 'content:materials/alignment' {
  import type { Alignment } from '@botgarten/materials/items'
  const alignment: Alignment
  export default alignment
}

declare module 'content:materials/references' {
  import type { Reference } from '@botgarten/materials/items'
  const references: readonly Reference[]
  export default references
}

declare module 'content:materials/programs' {
  import type { CardProgram } from '@botgarten/materials'
  const programs: { readonly [name: string]: CardProgram | undefined }
  export default programs
}

declare module 'content:materials/blocks' {
  import type { Block } from '@botgarten/blocks'
  const blocks: { readonly [card: string]: readonly Block[] | undefined }
  export default blocks
}

declare module 'content:examples' {
  import type { Template } from '@botgarten/blocks'
  export default function examples(): Promise<{ readonly [type: string]: readonly Template[] | undefined }>
}
