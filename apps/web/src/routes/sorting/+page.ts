import { sorting } from '#features/sorting/feature.ts'
import { fetchWords } from '#words/message.ts'
import type { PageLoad } from './$types'

/** Without a project the page is this device's; `?p=` opens the sorting of a project. */
export const load: PageLoad = async ({ url }) => {
  const id = url.searchParams.get('p')
  const [opened] = await Promise.all([id === null ? null : openProject(id), fetchWords(...sorting.words)])
  return { opened, missing: id !== null && opened === null }
}

const openProject = async (id: string) => (await sorting.load()).openForSorting(id)
