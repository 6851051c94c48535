import type { Words } from '#words/message.ts'

/** A row of a block in reading order: words, and places where a field, an input or an icon stands. */
export type Piece = { readonly text: string } | { readonly name: string }

// Private-use characters: no word of ours holds them.
const open = '\uE000'
const close = '\uE001'

/** Says the row and cuts it at its placeholders. `names`: what may stand in `{}`. */
export function piecesOf(key: string, names: readonly string[], words: Words): readonly Piece[] {
  const marks = Object.fromEntries(names.map((name) => [name, open + name + close]))
  return words(key, marks)
    .split(new RegExp(`(${open}[^${close}]*${close})`))
    .map((part) => (part.startsWith(open) ? { name: part.slice(1, -1) } : { text: part.trim() }))
    .filter((piece) => !('text' in piece) || piece.text !== '')
}
