import { ownKinds } from '@botgarten/programs'
import { message } from '#words/message.ts'

/** A part of a goal's sentence: words, or a number that is chosen there. */
export type Piece = string | { readonly name: string }

/** Stands around a name while the sentence is taken apart: no message holds it. */
const mark = '\u0001'

/** The sentence of a kind of goal, in the language of now, in pieces. */
export function sentenceOf(kind: string): readonly Piece[] {
  const names = [...Object.keys(ownKinds[kind]!.asks), 'seconds']
  const marked = Object.fromEntries(names.map((name) => [name, `${mark}${name}${mark}`]))
  return message(`cards.check.${kind}`, marked)
    .split(mark)
    .map((piece, index): Piece => (index % 2 === 0 ? piece : { name: piece }))
    .filter((piece) => piece !== '')
}
