import { fetchItems } from '#lib/materials/library.ts'
import { fetchLateWords, fetchSortingWords } from '#lib/words/say.ts'

export const load = async () => {
  await Promise.all([fetchItems(), fetchSortingWords(), fetchLateWords()])
}
