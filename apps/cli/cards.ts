import { content } from '@botgarten/content/files'
import type { Command } from './commands.ts'
import { options, refuseMore } from './options.ts'

const known = { json: { type: 'boolean' } } as const

/** `botgarten cards [--json]`: every card, its start poses, checks and typical wrong answers. */
export const cards: Command = { options: known, execute: listCards }

function listCards(args: string[]): string {
  const { values, positionals } = options(args, known)
  refuseMore(positionals)
  const list = content.cards.map(({ id, code, title }) => {
    const { playground, grades, minutes, starts, checks } = content.card(id)!.card
    return {
      ...{ id, code, title: { en: title['en']!, de: title['de']! } },
      ...{ playground, grades, minutes, starts },
      checks: checks.map(({ id, kind, seconds }) => ({ id, kind, seconds })),
      wrong: content.wrongAnswers(id),
    }
  })
  if (values.json) return JSON.stringify(list)
  return list
    .map(({ id, code, title }) => `${id.padEnd(16)}${code.padEnd(8)}${title.en} / ${title.de}`)
    .join('\n')
}
