import { fetchItems } from '#features/materials/library.ts'
import { fetchWords } from '#words/say.ts'

export const load = async () => {
  await Promise.all([fetchItems(), fetchWords('materials')])
}
