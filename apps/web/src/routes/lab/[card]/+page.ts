import { error, redirect } from '@sveltejs/kit'
import { resolve } from '$app/paths'
import { bringClassWork } from '#app/class-work.ts'
import { studyPlace } from '#app/study-here.ts'
import { editor, fetchBlocklyWords, packs } from '#features/editor/feature.ts'
import { allCards } from '#content/cards.ts'
import { openLab } from '#lab/opening.ts'
import type { EntryGenerator, PageLoad } from './$types'

// Names that are not among the entries are answered by the server, with the page that says so.
export const prerender = 'auto'

export const entries: EntryGenerator = () => [{ card: 'free' }, ...allCards.map(({ id }) => ({ card: id }))]

export const load: PageLoad = async ({ params, url }) => {
  // The address of a project whose place is the sorting playground.
  if (params.card === 'sorting') redirect(307, resolve(`/sorting${url.search}` as '/sorting'))
  // The heaviest part travels while the screen is made. The screen asks for it too, and says so where it cannot come.
  editor.load().catch(() => undefined)
  fetchBlocklyWords().catch(() => undefined)
  const place = await studyPlace(params.card)
  if (place === null) redirect(307, resolve('/study'))
  // A child of a study has projects of its own, and sees no other's.
  const project = place?.project ?? url.searchParams.get('p')
  await bringClassWork(project ?? params.card)
  const opened = await openLab(params.card, project, packs)
  if (!opened) error(404, params.card)
  return { opened, startAtOnce: url.searchParams.has('start') }
}
