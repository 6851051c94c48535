import { rewardZoo } from '#features/reward-zoo/feature.ts'
import { fetchWords } from '#words/message.ts'
import type { PageLoad } from './$types'

/** Without `?cage=` or `?senses=` the page shows all cages. */
export const load: PageLoad = async ({ url }) => {
  await fetchWords(...rewardZoo.words)
  return { cage: url.searchParams.get('cage'), senses: url.searchParams.get('senses') }
}
