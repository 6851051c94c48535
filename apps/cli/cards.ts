import { basename } from 'node:path'
import type { Command } from './commands.ts'
import { allCards, textOf, wrongAnswers } from './content.ts'
import { options, refuseMore } from './options.ts'

const known = { json: { type: 'boolean' } } as const

/** `botgarten cards [--json]`: every card, its start poses, checks and typical wrong answers. */
export const cards: Command = { options: known, carryOut: listCards }

function listCards(args: string[]): string {
  const { values, positionals } = options(args, known)
  refuseMore(positionals)
  const list = allCards().map(({ folder, card }) => ({
    id: card.id,
    code: card.code,
    title: { en: textOf(folder, 'en').title, de: textOf(folder, 'de').title },
    playground: card.playground,
    grades: card.grades,
    minutes: card.minutes,
    starts: card.starts,
    checks: card.checks.map(({ id, kind, seconds }) => ({ id, kind, seconds })),
    wrong: wrongAnswers(folder).map((file) => basename(file, '.json')),
  }))
  if (values.json) return JSON.stringify(list)
  return list
    .map(({ id, code, title }) => `${id.padEnd(16)}${code.padEnd(8)}${title.en} / ${title.de}`)
    .join('\n')
}
