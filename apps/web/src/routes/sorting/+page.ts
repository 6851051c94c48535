import { error } from '@sveltejs/kit'
import { fetchSortingWords } from '#lib/words/say.ts'
import type { PageLoad } from './$types'

/** Without a project the page is everybody's; `?p=` opens the sorting of a project. */
export const load: PageLoad = async ({ url }) => {
  const id = url.searchParams.get('p')
  const [opened] = await Promise.all([id === null ? null : openProject(id), fetchSortingWords()])
  return { opened }
}

async function openProject(id: string) {
  const { openForSorting } = await import('#lib/playgrounds/sorting/open.ts')
  const opened = await openForSorting(id)
  return opened ?? error(404, id)
}
