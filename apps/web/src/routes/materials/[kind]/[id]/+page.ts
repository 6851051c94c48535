import { error } from '@sveltejs/kit'
import { allCards, ownCardId } from '#content/cards.ts'
import { library, ownPack, packIds } from '#features/materials/feature.ts'
import type { EntryGenerator, PageLoad } from './$types'

// Names that are not among the entries are answered by the server, with the page that says so.
export const prerender = 'auto'

export const entries: EntryGenerator = () => [
  ...library.allItems.map(({ kind, id }) => ({ kind, id })),
  ...modules.map((id) => ({ kind: 'questions', id })),
  ...[...packIds(), ownPack].map((id) => ({ kind: 'pack', id })),
  ...allCards.map(({ id }) => ({ kind: 'card', id })),
  { kind: 'card', id: ownCardId },
]

const modules = [...new Set(library.allQuestions.map(({ module }) => String(module)))]

export const load: PageLoad = async ({ params, url }) => {
  if (params.kind === 'card' && params.id === ownCardId) {
    const { ownCardNamed } = await import('./own-card.ts')
    const own = await ownCardNamed(url.searchParams.get('p') ?? '')
    if (!own) error(404, params.id)
    return { item: null, module: 0, pack: null, own }
  }
  await library.fetchMaterials()
  if (params.kind === 'questions' && modules.includes(params.id))
    return { item: null, module: Number(params.id), pack: null, own: null }
  if (params.kind === 'pack' && [...packIds(), ownPack].includes(params.id))
    return { item: null, module: 0, pack: params.id, own: null }
  const item = library.itemNamed(params.id) ?? library.cardItem(params.id)
  if (item?.kind !== params.kind) error(404, params.id)
  return { item, module: 0, pack: null, own: null }
}
