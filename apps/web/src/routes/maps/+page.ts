import { mapDesigner } from '#features/map-designer/feature.ts'
import { fetchWords } from '#words/message.ts'
import type { PageLoad } from './$types'

/** Without a project the page says how a map begins; `?p=` and `&m=` open a map of a project, `?p=` alone a new one in it. */
export const load: PageLoad = async ({ url }) => {
  await fetchWords(...mapDesigner.words)
  return { project: url.searchParams.get('p'), map: url.searchParams.get('m') }
}
