import { fetchSortingWords } from '#lib/words/say.ts'

export const load = () => fetchSortingWords()
