import { bringClassWork } from '#app/class-work.ts'
import { sorting } from '#features/sorting/feature.ts'
import { fetchWords } from '#words/message.ts'
import type { PageLoad } from './$types'

/** The project of the sorting playground, or `?p=` another one. */
export const load: PageLoad = async ({ url }) => {
  const id = url.searchParams.get('p')
  const [part] = await Promise.all([
    sorting.load(),
    fetchWords(...sorting.words),
    bringClassWork(id ?? 'sorting'),
  ])
  return part.openForSorting(id)
}
