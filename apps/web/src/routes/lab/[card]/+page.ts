import { error } from '@sveltejs/kit'
import { fetchBlocklyWords } from '#lib/editor/blockly-words.ts'
import { allCards } from '#lib/content/cards.ts'
import type { EntryGenerator, PageLoad } from './$types'

// Names that are not among the entries are answered by the server, with the page that says so.
export const prerender = 'auto'

export const entries: EntryGenerator = () => [{ card: 'free' }, ...allCards.map(({ id }) => ({ card: id }))]

export const load: PageLoad = async ({ params, url }) => {
  const [{ openLab }] = await Promise.all([import('#lib/state/opening.ts'), fetchBlocklyWords()])
  const opened = await openLab(params.card, url.searchParams.get('p'))
  if (!opened) error(404, params.card)
  return { opened, startAtOnce: url.searchParams.has('start') }
}
