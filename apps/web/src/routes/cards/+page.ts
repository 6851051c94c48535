import { ownCards } from '#features/own-cards/feature.ts'
import { fetchWords } from '#words/message.ts'
import type { PageLoad } from './$types'

/** Without a project the page shows all own cards; `?p=` opens one that is being made. */
export const load: PageLoad = async ({ url }) => {
  await fetchWords(...ownCards.words)
  return { project: url.searchParams.get('p') }
}
