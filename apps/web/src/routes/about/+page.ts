import { fetchSortingWords } from '#words/say.ts'

export const load = () => fetchSortingWords()
