import { type Markdown, spoken } from '#parts/markdown.ts'
import type { Embed, ItemMarkdown, ItemNode } from '@botgarten/content/items'
import { m } from '#words/message.ts'
import { flows } from './drawn/flow/flows.ts'
import { flowWords } from './drawn/flow/flow.ts'
import { allQuestions, questionText } from './library.ts'
import type { QuestionText } from '@botgarten/content/questions'
import { headingOf } from './sides.ts'
import type { Slide } from './slides/deck.ts'

type Node = Markdown[number]

const paragraph = (children: Markdown): Node => ({ type: 'paragraph', children })
const sentence = (value: string): Node => paragraph([{ type: 'text', value }])
const said = (nodes: ItemMarkdown): Markdown => nodes.flatMap(saidOf)

/** What a voice says of a node: pictures by their words, tables row by row. */
function saidOf(node: ItemNode): Markdown {
  switch (node.type) {
    case 'text':
      return [node]
    case 'embed':
      return sayableEmbed(node.embed).map(sentence)
    case 'image':
      return [sentence(node.alt)]
    case 'table':
      return [node.head, ...node.rows].map((row) =>
        paragraph(
          row
            .filter((cell) => cell.length > 0)
            .flatMap((cell, index) => [
              ...(index > 0 ? [{ type: 'text', value: ', ' } as const] : []),
              ...said(cell),
            ]),
        ),
      )
    case 'list':
      return [{ type: 'list', ordered: node.ordered, children: said(node.children) }]
    case 'listItem':
      return [{ type: 'listItem', children: [paragraph(said(node.children).flatMap(within))] }]
    case 'strong':
    case 'emphasis':
    case 'link':
      return said(node.children)
    default:
      return [paragraph(said(node.children))]
  }
}

/** A line of a list is one sentence, however it is written. */
const within = (node: Node): Markdown => (node.type === 'paragraph' ? node.children : [node])

/** The words of an item as a voice says them; null where there are none. */
export const sayable = (nodes: ItemMarkdown): string | null => spoken(said(nodes)) || null

/** What a voice says of what a text names, sentence by sentence: the words on it. What is drawn is looked at. */
function sayableEmbed(embed: Embed): readonly string[] {
  if (embed.kind === 'timer') return [m['materials.swapAfter']({ minutes: embed.minutes })]
  if (embed.kind === 'flow') return flowWords(flows[embed.id])
  if (embed.kind !== 'questions') return []
  return allQuestions
    .filter(({ module }) => module === embed.module)
    .flatMap(({ id, choices }) => {
      const text = questionText(id)
      return [text.question, ...choices.map((choice) => text.choices[choice] ?? '')]
    })
}

/** A question as a voice asks it: first what is asked, then what can be answered. */
export const questionAloud = ({ question, choices }: QuestionText, order: readonly string[]): string =>
  spoken([question, ...order.map((choice) => choices[choice] ?? '')].map(sentence))

/** What a voice says once a question is answered: was it guessed, what happens, and why. */
export const answerAloud = ({ choices, why }: QuestionText, answer: string, guessed: boolean): string =>
  spoken([
    sentence(guessed ? m['materials.guessed']() : m['materials.otherwise']()),
    sentence(`${m['materials.thatHappens']()}: ${choices[answer] ?? ''}`),
    ...said(why),
  ])

/**
 * What a voice says of a slide: what stands on it, and never what the teacher says to it. `shown`: on the whole screen, where
 * questions are asked one by one and have a voice of their own.
 */
export function slideAloud({ title, words, shown: drawn }: Slide, shown = false): string {
  const left = drawn.filter((node) => !(shown && node.type === 'embed' && node.embed.kind === 'questions'))
  return sayable([headingOf(title), ...words, ...left]) ?? title
}
