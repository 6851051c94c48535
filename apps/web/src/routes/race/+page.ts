import { races } from '#features/races/feature.ts'
import { fetchWords } from '#words/message.ts'
import type { PageLoad } from './$types'

/** `?map=` a map that everybody has; `?p=` what a project of this device learns; `?brains=` a course on which brains race, `&class=` with those that a class has shared; `&you` begins with the child's walk. */
export const load: PageLoad = async ({ url }) => {
  await fetchWords(...races.words)
  const { searchParams: asked } = url
  return {
    project: asked.get('p'),
    map: asked.get('map'),
    brains: asked.get('brains'),
    school: asked.get('class'),
    you: asked.has('you'),
  }
}
