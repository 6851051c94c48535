import { mapDesigner } from '#features/map-designer/feature.ts'
import { fetchWords } from '#words/message.ts'
import type { PageLoad } from './$types'

/** Without a project the page says how a map begins; `?p=` and `&m=` open a map of a project, `?p=` alone a new one in it. */
export const load: PageLoad = async ({ url }) => {
  const [id, map] = [url.searchParams.get('p'), url.searchParams.get('m')]
  const [parts] = await Promise.all([mapDesigner.load(), fetchWords(...mapDesigner.words)])
  const opened = id === null ? null : await parts.openMapOf(id, map, '')
  return { parts, opened, missing: id !== null && opened === null }
}
