import { content } from '@botgarten/content/files'
import type { CardHead } from '@botgarten/content/catalogue'
import type { Command } from './commands.ts'
import { options, refuseMore } from './options.ts'

const known = { json: { type: 'boolean' } } as const

/** `botgarten cards [--json]`: every card, its start poses, checks and typical wrong answers. */
export const cards: Command = { options: known, execute: listCards }

type Titles = CardHead['title']

/** In every language that the card has, English first. */
export const ordered = ({ en, ...others }: Titles): Titles => (en === undefined ? others : { en, ...others })

/** `Friendship / Freundschaft`: a language without a text of its own is not said. */
export const inOneLine = (title: Titles): string => [...new Set(Object.values(ordered(title)))].join(' / ')

function listCards(args: string[]): string {
  const { values, positionals } = options(args, known)
  refuseMore(positionals)
  const list = content.cards.map(({ id, code, title }) => {
    const { playground, grades, minutes, starts, checks } = content.card(id)!.card
    return {
      ...{ id, code, title: ordered(title) },
      ...{ playground, grades, minutes, starts },
      checks: checks.map(({ id, kind, seconds }) => ({ id, kind, seconds })),
      wrong: content.wrongAnswers(id),
    }
  })
  if (values.json) return JSON.stringify(list)
  return list.map(({ id, code, title }) => `${id.padEnd(16)}${code.padEnd(8)}${inOneLine(title)}`).join('\n')
}
