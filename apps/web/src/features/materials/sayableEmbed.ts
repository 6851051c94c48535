import type { Embed } from '@botgarten/content/items'
import { m } from '#words/say.ts'
import { flows } from './drawn/flow/flows.ts'
import { flowWords } from './drawn/flow/words.ts'
import { allQuestions, questionText } from './library.ts'

/** What a voice says of what a text names, sentence by sentence: the words on it. What is drawn is looked at. */
export function sayableEmbed(embed: Embed): readonly string[] {
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
