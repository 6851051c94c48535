import { fetchLateWords } from '#lib/words/say.ts'

export const load = () => fetchLateWords()
