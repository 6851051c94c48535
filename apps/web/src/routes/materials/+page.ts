import { fetchItems } from '#features/materials/library.ts'
import { fetchLateWords, fetchSortingWords } from '#words/say.ts'

export const load = async () => {
  await Promise.all([fetchItems(), fetchSortingWords(), fetchLateWords()])
}
