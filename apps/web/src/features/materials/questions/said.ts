import type { ItemMarkdown, ItemNode } from '@botgarten/content/items'
import type { QuestionText } from '@botgarten/content/questions'
import { m } from '#words/say.ts'
import { sayable } from '../sayable.ts'

const sentence = (value: string): ItemNode => ({ type: 'paragraph', children: [{ type: 'text', value }] })
const said = (sentences: readonly string[], more: ItemMarkdown = []): string =>
  sayable([...sentences.map(sentence), ...more]) ?? ''

/** A question as a voice asks it: first what is asked, then what can be answered. */
export const saidQuestion = ({ question, choices }: QuestionText, order: readonly string[]): string =>
  said([question, ...order.map((choice) => choices[choice] ?? '')])

/** What a voice says once a question is answered: was it guessed, what happens, and why. */
export const saidAnswer = ({ choices, why }: QuestionText, answer: string, guessed: boolean): string =>
  said(
    [
      guessed ? m['materials.guessed']() : m['materials.otherwise'](),
      `${m['materials.thatHappens']()}: ${choices[answer] ?? ''}`,
    ],
    why,
  )
