import { error } from '@sveltejs/kit'
import { allCards } from '#content/cards.ts'
import { library, ownPack, packIds } from '#features/materials/feature.ts'
import type { EntryGenerator, PageLoad } from './$types'

// Names that are not among the entries are answered by the server, with the page that says so.
export const prerender = 'auto'

export const entries: EntryGenerator = () => [
  ...library.allItems.map(({ kind, id }) => ({ kind, id })),
  ...modules.map((id) => ({ kind: 'questions', id })),
  ...[...packIds(), ownPack].map((id) => ({ kind: 'pack', id })),
  ...allCards.map(({ id }) => ({ kind: 'card', id })),
]

const modules = [...new Set(library.allQuestions.map(({ module }) => String(module)))]

export const load: PageLoad = async ({ params }) => {
  await library.fetchMaterials()
  if (params.kind === 'questions' && modules.includes(params.id))
    return { item: null, module: Number(params.id), pack: null }
  if (params.kind === 'pack' && [...packIds(), ownPack].includes(params.id))
    return { item: null, module: 0, pack: params.id }
  const item = library.itemNamed(params.id) ?? library.cardItem(params.id)
  if (item?.kind !== params.kind) error(404, params.id)
  return { item, module: 0, pack: null }
}
